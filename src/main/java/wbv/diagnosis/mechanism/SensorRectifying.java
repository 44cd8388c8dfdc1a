package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Start.fixed;

import java.util.Arrays;
import java.util.List;
import wbv.body.SensorFault;

/** A sensor that loses the sign, as some of a rig do. */
record SensorRectifying() implements Mechanism {

    /** How far a signal that lost its sign may turn negative, in parts of its height. */
    private static final double NOISE = 0.1;

    @Override
    public Entry entry() {
        return new Entry("sensor.rectifying", Family.SENSOR, "The sensor %s loses the sign",
                "Turn the sensor upside down: a sign must change.");
    }

    @Override
    public List<Hypothesis> atSensor(Scene scene, int output) {
        double[] y = scene.measured().get(output);
        double top = Arrays.stream(y).max().orElse(1);
        double bottom = Arrays.stream(y).min().orElse(-1);
        return scene.onRig() && top > 0 && bottom > -NOISE * top
                ? List.of(Hypothesis.fault(this, scene, output, new SensorFault.Rectifying(), List.of(), List.of(fixed()))) : List.of();
    }
}

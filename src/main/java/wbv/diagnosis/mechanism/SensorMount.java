package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Start.fixed;
import static wbv.diagnosis.mechanism.Hypothesis.Start.grid;

import java.util.List;
import java.util.Optional;
import wbv.body.SensorFault;

/** A sensor that rides on a soft mount. None on a rig. */
record SensorMount() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("sensor.mount", Family.SENSOR, "The sensor %s rides on a soft mount",
                "Add 20 g to the sensor, or tape a second, light one beside it: a mount's resonance falls, all else stays.");
    }

    @Override
    public List<Hypothesis> atSensor(Scene scene, int output) {
        return scene.onRig() ? List.of() : List.of(Hypothesis.fault(this, scene, output, new SensorFault.MountResonance(10, 0.3),
                List.of(factor(2.5, 60), factor(0.01, 2)), grid(new double[] {6, 10, 18}, f -> fixed(f, 0.3))));
    }

    @Override
    public Optional<String> against(Mechanism rival) {
        boolean told = rival.family() == Family.COUPLING || rival.family() == Family.DYNAMIC || rival instanceof SensorGain;
        return told ? Optional.of(entry().experiment()) : Optional.empty();
    }

    @Override
    public boolean isAlwaysRefitted() {
        return true;
    }

    @Override
    public boolean imitatesAt(String key, boolean low) {
        return true;
    }
}

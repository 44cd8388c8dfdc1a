package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;

import java.util.List;
import java.util.Optional;
import wbv.body.SensorFault;
import wbv.diagnosis.mechanism.Hypothesis.Start;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/** A sensor that is tilted, where all three of its axes were recorded. Not looked for on a rig. */
record SensorMisalignment() implements Mechanism {

    static final String POSE = "Hold a static pose: a tilted sensor splits gravity, nothing else does.";
    /** Tilt to start from, and its unit [rad]. */
    private static final double TILT = 0.02;

    @Override
    public Entry entry() {
        return new Entry("sensor.misalignment", Family.SENSOR, "The sensor %s is tilted", POSE);
    }

    @Override
    public List<Hypothesis> atSensor(Scene scene, int output) {
        Channel channel = scene.outputs().get(output);
        boolean accelerometer = !scene.onRig() && channel.quantity() == Quantity.ACCELERATION;
        List<Channel> across = accelerometer ? scene.beside(channel, Quantity.ACCELERATION) : List.of();
        return across.size() != 2 ? List.of() : List.of(Hypothesis.fault(this, scene, output,
                new SensorFault.Misalignment(across.get(0), across.get(1), TILT, TILT), List.of(sum(TILT, -0.9, 0.9), sum(TILT, -0.9, 0.9)),
                List.of(Start.of(new double[] {TILT, TILT}, new int[] {0}, new int[] {1}))));
    }

    @Override
    public Doubt doubt(String key) {
        return Doubt.TILT;
    }

    @Override
    public Optional<String> against(Mechanism rival) {
        boolean told = rival.family() == Family.COUPLING || rival instanceof SensorDelay || rival instanceof SensorMount
                || rival instanceof SensorGain;
        return told ? Optional.of(POSE) : Optional.empty();
    }
}

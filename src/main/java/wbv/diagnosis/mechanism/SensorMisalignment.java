package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;

import java.util.List;
import java.util.Optional;
import wbv.body.SensorFault;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * A sensor that is tilted: towards both axes across, or about one axis where two were recorded; all its channels in a model with them. Not
 * looked for on a rig.
 */
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
        List<Integer> device = scene.device(output).stream().filter(o -> scene.outputs().get(o).quantity() == Quantity.ACCELERATION)
                .toList();
        if (accelerometer && device.size() == 2) {
            return device.get(0) == output ? List.of(turned(scene, device)) : List.of();
        }
        if (across.size() == 1) {
            return List.of(Hypothesis.fault(this, scene, output, new SensorFault.Turned(across.get(0), TILT), List.of(sum(TILT, -0.9, 0.9)),
                    List.of(Start.scaled(TILT))));
        }
        return across.size() != 2 ? List.of() : List.of(Hypothesis.fault(this, scene, output,
                new SensorFault.Misalignment(across.get(0), across.get(1), TILT, TILT), List.of(sum(TILT, -0.9, 0.9), sum(TILT, -0.9, 0.9)),
                List.of(Start.of(new double[] {TILT, TILT}, new int[] {0}, new int[] {1}))));
    }

    /** About the axis across both that the model reads: one reads of the other what that loses. */
    private Hypothesis turned(Scene scene, List<Integer> device) {
        List<SensorFault> faults = List.of(new SensorFault.Turned(scene.outputs().get(device.get(1)), TILT),
                new SensorFault.Turned(scene.outputs().get(device.get(0)), -TILT));
        return Hypothesis.fault(this, scene, device, faults, List.of(List.of(1.0), List.of(-1.0)), List.of(sum(TILT, -0.9, 0.9)),
                List.of(Start.scaled(TILT)));
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

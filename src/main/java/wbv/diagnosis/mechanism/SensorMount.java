package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Start.fixed;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.Arrays;
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
        if (scene.onRig()) {
            return List.of();
        }
        // How far a mount of 10 Hz is stretched by what its sensor read; a third more stiffness there is plain.
        double stretch = Math.sqrt(Arrays.stream(scene.measured().get(output)).map(a -> a * a).average().orElse(0))
                / Math.pow(2 * Math.PI * 10, 2);
        double cubic = 0.3 / Math.max(stretch * stretch, 1e-12);
        return List.of(Hypothesis.fault(this, scene, output, new SensorFault.MountResonance(10, 0.3),
                List.of(factor(2.5, 60), factor(0.01, 2)), grid(new double[] {6, 10, 18}, f -> fixed(f, 0.3))),
                Hypothesis.fault(this, scene, output, "stiffening", new SensorFault.StiffeningMount(10, 0.3, cubic),
                        List.of(factor(2.5, 60), factor(0.01, 2), factor(1e-3 * cubic, 1e3 * cubic)),
                        grid(new double[] {6, 10, 18}, f -> fixed(f, 0.2, cubic * Math.pow(f / 10, 4)))));
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

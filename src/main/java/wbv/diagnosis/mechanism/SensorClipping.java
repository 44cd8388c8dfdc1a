package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Start.fixed;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import wbv.body.SensorFault;

/** A sensor whose range ends, below, above or at both ends. */
record SensorClipping() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("sensor.clipping", Family.SENSOR, "The sensor %s clips",
                "Repeat at a third of the level: what clips must vanish.");
    }

    @Override
    public List<Hypothesis> atSensor(Scene scene, int output) {
        double[] y = scene.measured().get(output);
        double top = Arrays.stream(y).max().orElse(1);
        double bottom = Arrays.stream(y).min().orElse(-1);
        if (scene.onRig() && !(top > 0 && bottom < 0)) {
            return List.of();
        }
        List<Start> levels = new ArrayList<>(grid(new double[] {0.98, 0.9, 0.8}, q -> fixed(q * bottom, q * top)));
        if (!scene.onRig()) {
            levels.add(fixed(10 * bottom, 0.9 * top));
            levels.add(fixed(0.9 * bottom, 10 * top));
        }
        return List.of(Hypothesis.fault(this, scene, output, new SensorFault.Clipping(bottom, top),
                List.of(factor(0.01 * bottom, 40 * bottom), factor(0.01 * top, 40 * top)), levels));
    }

    @Override
    public Optional<String> against(Mechanism rival) {
        return rival.family() == Family.SPRING || rival.family() == Family.CONTACT ? Optional.of(Family.LEVELS) : Optional.empty();
    }
}

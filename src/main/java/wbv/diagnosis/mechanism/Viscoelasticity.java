package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.List;
import java.util.Optional;
import wbv.body.law.MaxwellArm;

/** A spring in series with a dashpot beside the link (Maxwell). */
record Viscoelasticity() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("memory.viscoelastic", Family.DYNAMIC, "The link %s relaxes: it remembers its past deflection");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        if (!scene.onRig()) {
            double k = link.stiffness();
            return List
                    .of(Hypothesis.law(this, link, "", new MaxwellArm(0.1 * k, 0.05), List.of(factor(1e-3 * k, 20 * k), factor(0.003, 3)),
                            grid(new double[] {0.015, 0.05, 0.2}, t -> Start.of(new double[] {0.1 * k, t}, new int[] {0}))));
        }
        double k = link.own();
        double r = link.deflection();
        double v = link.speed();
        return !(k > 0) ? List.of() : List.of(Hypothesis.law(this, link, "", new MaxwellArm(0.1 * k, r / v),
                List.of(factor(1e-3 * k, 100 * k), factor(1e-2 * r / v, 100 * r / v)),
                grid(new double[] {0.3, 1, 5}, q -> Start.of(new double[] {0.1 * k, q * r / v}, new int[] {0}))));
    }

    @Override
    public Optional<String> against(Mechanism rival) {
        return rival instanceof StretchReflex ? Optional.of(entry().experiment()) : Optional.empty();
    }

    @Override
    public boolean isAlwaysRefitted() {
        return true;
    }

    @Override
    public boolean isImitatedByNumbers() {
        return true;
    }

    /** Of all relaxation times but those in the band, it is a spring or a dashpot. */
    @Override
    public boolean imitatesAt(String key, boolean low) {
        return true;
    }
}

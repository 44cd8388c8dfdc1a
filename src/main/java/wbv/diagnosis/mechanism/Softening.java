package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Start.fixed;
import static wbv.diagnosis.mechanism.Hypothesis.Start.grid;

import java.util.List;
import wbv.body.law.SaturatingSpring;
import wbv.diagnosis.mechanism.Hypothesis.Number;

/** A spring whose force saturates. */
record Softening() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("stiffness.softening", Family.SPRING, "The link %s softens with deflection");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double r = link.deflection();
        if (scene.onRig()) {
            return link.own() > 0 ? List.of(law(link, factor(0.02 * r, 50 * r), r, 0.5, 1.5, 4)) : List.of();
        }
        return List.of(law(link, factor(5e-5, 5e-2), r, 0.25, 0.6, 1.5, 4));
    }

    /**
     * @param r unit of the knee [m]
     * @param knees to start from, in that unit
     */
    private Hypothesis law(Scene.Link link, Number knee, double r, double... knees) {
        return Hypothesis.law(this, link, "", new SaturatingSpring(r), List.of(knee), grid(knees, q -> fixed(q * r)));
    }
}

package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Start.fixed;
import static wbv.diagnosis.mechanism.Hypothesis.Start.grid;

import java.util.List;
import java.util.Optional;
import wbv.body.law.GradualSaturation;
import wbv.body.law.SaturatingSpring;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis.Number;

/** A spring whose force saturates, over a bend that is as wide as most or another. */
record Softening() implements Mechanism {

    /**
     * Sharpness of a bend [1]: at a knee's deflection it has 2^(-1/n) of what it would have without, from a tenth to all but a thirtieth.
     */
    private static final double WIDEST = 0.3;
    private static final double NARROWEST = 20;

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

    @Override
    public Optional<Hypothesis> further(Hypothesis plain, double[] found) {
        return plain.additions().get(0) instanceof Addition.InLink in && in.law() instanceof SaturatingSpring
                ? Optional.of(new Hypothesis(this, plain.where(), "gradual",
                        List.of(new Addition.InLink(in.link(), new GradualSaturation(found[0], 1))),
                        List.of(plain.numbers().get(0), factor(WIDEST, NARROWEST).named("sharpness")),
                        grid(new double[] {1, 1.5, 4}, n -> fixed(found[0], n))))
                : Optional.empty();
    }

    /**
     * @param r unit of the knee [m]
     * @param knees to start from, in that unit
     */
    private Hypothesis law(Scene.Link link, Number knee, double r, double... knees) {
        return Hypothesis.law(this, link, "", new SaturatingSpring(r), List.of(knee), grid(knees, q -> fixed(q * r)));
    }
}

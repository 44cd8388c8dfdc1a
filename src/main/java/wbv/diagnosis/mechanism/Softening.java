package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.fixed;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import wbv.body.law.Saturation.GradualSaturation;
import wbv.body.law.Saturation.PartialSaturation;
import wbv.body.law.Saturation.SaturatingSpring;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis.Number;

/** A spring whose force saturates, over a bend that is as wide as most or another, or that keeps a part of its stiffness. */
record Softening() implements Mechanism {

    /**
     * Sharpness of a bend [1]: at a knee's deflection it has 2^(-1/n) of what it would have without, from a tenth to all but a thirtieth.
     */
    private static final double WIDEST = 0.3;
    private static final double NARROWEST = 20;
    /** Share of the stiffness that is kept, and a step of it [1]: what buckles pushes back, and what keeps all does not soften. Assumed. */
    private static final double LEAST_KEPT = -0.5;
    private static final double MOST_KEPT = 0.95;
    private static final double STEP = 0.1;

    @Override
    public Entry entry() {
        return new Entry("stiffness.softening", Family.SPRING, "The link %s softens with deflection");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double r = link.deflection();
        return link.own() > 0
                ? List.of(Hypothesis.law(this, link, "", new SaturatingSpring(r), List.of(factor(0.02 * r, 50 * r)),
                        grid(new double[] {0.25, 0.6, 1.5, 4}, q -> fixed(q * r))))
                : List.of();
    }

    /** Over a bend of another width, and then of a part of the stiffness. */
    @Override
    public Optional<Hypothesis> further(Hypothesis plain, double[] found) {
        if (!(plain.additions().get(0) instanceof Addition.InLink in)) {
            return Optional.empty();
        }
        if (in.law() instanceof SaturatingSpring) {
            return Optional.of(form(plain, "gradual", new Addition.InLink(in.link(), new GradualSaturation(found[0], 1)),
                    factor(WIDEST, NARROWEST).named("sharpness"), grid(new double[] {1, 1.5, 4}, n -> fixed(found[0], n))));
        }
        return in.law() instanceof GradualSaturation
                ? Optional.of(form(plain, "partial", new Addition.InLink(in.link(), new PartialSaturation(found[0], found[1], 0)),
                        sum(STEP, LEAST_KEPT, MOST_KEPT).named("kept_share"),
                        List.of(fixed(found[0], found[1], 0), fixed(found[0] / 2, found[1], 0.5))))
                : Optional.empty();
    }

    private Hypothesis form(Hypothesis plain, String name, Addition law, Number further, List<Start> starts) {
        List<Number> numbers = new ArrayList<>(plain.numbers());
        numbers.add(further);
        return new Hypothesis(this, plain.where(), name, List.of(law), numbers, starts);
    }
}

package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Hypothesis.Start.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import wbv.body.law.BumpStop;
import wbv.body.law.HertzStop;
import wbv.body.law.Law;
import wbv.diagnosis.mechanism.Hypothesis.Number;
import wbv.diagnosis.mechanism.Hypothesis.Start;

/** A stop to one side or to both, straight or round as a ball is. */
record EndStop() implements Mechanism {

    /** The least gap to start from on a person, above the least that is looked for [m]. */
    private static final double LEAST = 2.1e-5;
    /** The same on a rig, in parts of the deflection. */
    private static final double LEAST_PART = 2e-3;

    @Override
    public Entry entry() {
        return new Entry("contact.bumpstop", Family.CONTACT, "The link %s hits a stop");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        double r = link.deflection();
        double k = link.stiffness();
        List<Hypothesis> out = new ArrayList<>();
        for (Law.Side side : Law.Side.values()) {
            if (scene.onRig()) {
                out.add(stop(link, side, k, List.of(sum(k, 1e-6 * k, 1000 * k), factor(1e-3 * r, 20 * r)), LEAST_PART * r, 0.6, 0.85,
                        0.97));
            } else {
                out.add(stop(link, side, 0.2 * k, List.of(sum(0.2 * k, 1e-6 * k, 40 * k), factor(2e-5, 2e-2)), LEAST,
                        side == Law.Side.BOTH ? new double[] {0.3, 0.6, 0.85, 0.97} : new double[] {0.55, 0.75, 0.9, 0.98}));
            }
            double hertz = 0.5 * k / Math.sqrt(r);
            if (scene.onRig()) {
                out.add(round(link, side, hertz, List.of(sum(hertz, 1e-6 * hertz, 1000 * hertz), factor(1e-3 * r, 20 * r)),
                        LEAST_PART * r));
            } else if (side == Law.Side.COMPRESSION) {
                out.add(round(link, side, hertz, List.of(sum(hertz, 1e-6 * hertz, 100 * hertz), factor(1e-6, 2e-2)), LEAST));
            }
        }
        return out;
    }

    /**
     * @param k its stiffness to start from
     * @param least gap to start from [m]
     * @param shares of the time in which it is not touched
     */
    private Hypothesis stop(Scene.Link link, Law.Side side, double k, List<Number> bounds, double least, double... shares) {
        return Hypothesis.law(this, link, side.name().toLowerCase(Locale.ROOT), new BumpStop(k, link.deflection(), side), bounds,
                starts(link, side, k, least, shares));
    }

    /**
     * One round as a ball is.
     *
     * @param k as its law has it, to start from
     * @param least as for a straight one
     */
    private Hypothesis round(Scene.Link link, Law.Side side, double k, List<Number> bounds, double least) {
        String form = side == Law.Side.COMPRESSION ? "hertz" : "hertz " + side.name().toLowerCase(Locale.ROOT);
        return Hypothesis.law(this, link, form, new HertzStop(k, link.deflection(), side), bounds, starts(link, side, k, least, 0.5, 0.8));
    }

    private static List<Start> starts(Scene.Link link, Law.Side side, double k, double least, double... shares) {
        return grid(shares, q -> Start.of(new double[] {k, Math.max(least, link.reached(side, q))}, new int[] {0}));
    }

    @Override
    public boolean yieldsTo(Hypothesis rival) {
        return rival.kind() instanceof Asymmetry || rival.kind() instanceof Separation || rival.kind() instanceof Hardening;
    }
}

package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import wbv.body.law.BoucWen;
import wbv.body.law.BristleFriction;
import wbv.body.law.Law;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Slot;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Hysteresis;
import wbv.diagnosis.mechanism.Start;

/**
 * Friction whose bristles bend before they slide, and a spring of which a part yields, are one continuum: stiff bristles beside a
 * spring are a spring that yields early. Which of the two a link has, the form of the loop tells, once each is fitted as well as
 * it can be: from where the other stands, and hysteresis that comes little by little (Iwan, Journal of Applied Mechanics 1966). The
 * stiffness that a model gives its link is that of some amplitude: what slides is a part of it, or stands beside it.
 */
final class Yielding {

    private static final double BREAKAWAY = 1.05;
    private static final double STRIBECK = 0.01;
    /** The most of a link's stiffness that becomes bristles: a link keeps some. */
    private static final double MOST = 0.97;
    private static final double LEAST = 1e-3;

    private final Refinement refinement;
    private final List<Hypothesis> all;
    private final Fitter.State base;

    /** @param all hypotheses on top of the base */
    Yielding(Refinement refinement, List<Hypothesis> all, Fitter.State base) {
        this.refinement = refinement;
        this.all = all;
        this.base = base;
    }

    /** Rivals of a fit whose last hypothesis is friction or hysteresis, polished; none of any other. */
    List<Fitter.State> rivals(Fitter.State fit) {
        Hypothesis last = fit.candidate().last();
        if (!(last.additions().get(0) instanceof Addition.InLink in)) {
            return List.of();
        }
        double[] found = fit.candidate().values(last, fit.x());
        double stiffness = fit.candidate().at(fit.x()).structure().stiffness()[in.link()];
        if (in.law() instanceof BoucWen && found.length == 2) {
            double hanging = Math.max(found[0], LEAST) * stiffness;
            double force = hanging * found[1];
            List<Fitter.State> out = new ArrayList<>(of(in.link(), BristleFriction.class).map(bristles -> polished(fit, in.link(),
                    stiffness - MOST * hanging, bristles, List.of(new double[] {force, BREAKAWAY * force, STRIBECK, hanging})))
                    .orElse(List.of()));
            out.addAll(gradual(fit, in.link(), stiffness - hanging, hanging, found[1]));
            return out;
        }
        if (in.law() instanceof BristleFriction) {
            double hanging = found[3];
            double share = hanging / (hanging + stiffness);
            double yield = found[0] / hanging;
            List<Fitter.State> out = new ArrayList<>(
                    of(in.link(), BoucWen.class).map(stage -> polished(fit, in.link(), stiffness + hanging, stage,
                            List.of(new double[] {share, yield}))).orElse(List.of()));
            out.addAll(gradual(fit, in.link(), stiffness, hanging, yield));
            return out;
        }
        return List.of();
    }

    /** Friction with bristles, or hysteresis in one stage, in a link; empty where the library has none. */
    private Optional<Hypothesis> of(int link, Class<? extends Law> law) {
        return all.stream().filter(h -> h.additions().get(0) instanceof Addition.InLink in && in.link() == link
                && in.law().getClass() == law).findFirst();
    }

    /**
     * Hysteresis that comes little by little, as a part of a link's spring or beside it, whichever leaves the spring nearer to what it is
     * said to be.
     *
     * @param sliding stiffness of the link where all that may slide does [N/m]
     * @param hanging what is added while all of it sticks [N/m]
     * @param yield deflection at which it slides [m]
     */
    private List<Fitter.State> gradual(Fitter.State from, int link, double sliding, double hanging, double yield) {
        String where = from.candidate().last().where();
        double sticking = sliding + hanging;
        double given = base.candidate().given(Slot.of(Slot.Kind.STIFFNESS, link));
        boolean beside = given * given <= sliding * sticking;
        Hypothesis gradual = beside ? new Hysteresis().beside(link, where, Math.max(given, LEAST * hanging), hanging, yield)
                : new Hysteresis().gradual(link, where, hanging / sticking, yield);
        return polished(from, link, beside ? sliding : sticking, gradual,
                gradual.starts().stream().map(Start::values).toList());
    }

    /** The best of fits from some starts, with a stiffness of its own in the link; none if it fails. */
    private List<Fitter.State> polished(Fitter.State from, int link, double stiffness, Hypothesis hypothesis, List<double[]> starts) {
        double[] x = Arrays.copyOf(from.x(), base.x().length);
        base.candidate().stiffness(link).ifPresent(own -> x[own] = base.candidate().knobs().get(own).coordinate(stiffness));
        return refinement.polished(base.candidate(), hypothesis, x, from.frame(), starts);
    }
}

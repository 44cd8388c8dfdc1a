package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;

/** Fits hypotheses to their end, every law by free run, and says what is left of a mismatch then. */
public final class Refinement {

    /** Steps of a moment that are tried, in its own unit [1]. */
    private static final double[] SHIFTS = {-1.5, -0.8, -0.4, -0.2, -0.1, -0.05, -0.02, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 1.5};

    private final Evidence evidence;
    private final Fitter fitter;

    Refinement(Evidence evidence) {
        this.evidence = evidence;
        this.fitter = new Fitter(evidence);
    }

    /** Whether a fit went far to make up for what is missing: then it is a bad place to start from. */
    public static boolean bent(Fitter.State base) {
        return IntStream.range(0, base.x().length)
                .anyMatch(i -> base.candidate().knobs().get(i).unit() == 0 && base.candidate().knobs().get(i).deviation() > 1
                        && Math.abs(base.x()[i]) > Priors.NUMBER);
    }

    /**
     * A part of the data that is enough to tell which hypotheses are worth the whole; empty where it may not be, as where the model with
     * other numbers explains the part: what goes by the clock is not in it, and anything that comes with free numbers would explain it.
     */
    public Optional<Trial.Ground> brief(Fitter.State base) {
        if (base.reduced() < Priors.STRANGE || base.candidate().added().stream().anyMatch(Hypothesis::byTheClock)) {
            return Optional.empty();
        }
        return evidence.brief().flatMap(part -> evidence.known().once(new In(part, base), () -> brief(part, base)));
    }

    private record In(Evidence part, Fitter.State base) implements Known.Question<Optional<Trial.Ground>> {}

    private static Optional<Trial.Ground> brief(Evidence part, Fitter.State base) {
        Fitter own = new Fitter(part);
        Fitter.State there = own.lookWithSlopes(base.candidate(), base.x(), own.frame(base.candidate(), base.x(), part.fit()));
        return own.fit(base.candidate(), base.x(), there, Effort.FIRST_STEPS, Effort.ENOUGH).reduced() < Priors.STRANGE
                ? Optional.empty()
                : Optional.of(Trial.Ground.of(own, there));
    }

    /**
     * What is left beyond the noise [1]; half of it at least, so that fits near the noise are alike.
     *
     * @param reduced mean square of a whitened residual
     */
    public static double excess(double reduced) {
        return Math.max(reduced - 1, Priors.LOUD - 1);
    }

    /** Whether a fit explains {@link Priors#NEARLY_ALL} of the mismatch of a base. */
    public static boolean explainsNearlyAll(Fitter.State base, Fitter.State fit) {
        return explained(base, fit) > Priors.NEARLY_ALL;
    }

    /** Part of a mismatch that is explained, 0 to 1. */
    public static double explained(Fitter.State base, Fitter.State best) {
        return explained(base, best.reduced());
    }

    /**
     * Part of a mismatch that is explained, 0 to 1.
     *
     * @param left mean square of the whitened residual with it
     */
    public static double explained(Fitter.State base, double left) {
        return Math.max(0, Math.min(1, (base.reduced() - left) / Math.max(base.reduced() - 1, 1e-9)));
    }

    /**
     * What a formula that is right leaves at most of the mismatch of a base, being wrong by {@link Priors#FORM} of its force, as a mean
     * square of the whitened residual.
     */
    public static double form(Fitter.State base) {
        return 1 + Priors.FORM * Priors.FORM * (base.reduced() - 1);
    }

    /**
     * Whether a name takes a mismatch that a force of its own might make. Such a force, arbitrary as it is, leaves nothing of it; but where
     * each line has x times the noise's power, of which a name explains a part η, the name gains ηx, and whatever process gains x - ln(1 +
     * x). And what a name takes most of is no force of its own, whatever the name leaves.
     *
     * @param without mean square of the whitened residual that the model without the name leaves [1]
     * @param with likewise, what the name leaves [1]
     */
    public static boolean isTaken(double without, double with) {
        return with - 1 < Math.max(Priors.MAJORITY * Priors.MAJORITY * (without - 1), Math.log(without));
    }

    /** A trial fitted to its end, in the whitening of what it stands on. */
    Fitter.State finish(Fitter.State begun, Fitter.State base) {
        return timed(fitter.fit(begun.candidate(), begun.x(), base.frame(), Effort.FINAL_STEPS, Effort.ROUGH), 1);
    }

    /** A moment is not found by slopes: steps of it are tried, and the rest refitted, until none helps. */
    private Fitter.State timed(Fitter.State fit, int rounds) {
        Fitter.State best = fit;
        for (int i = 0; i < best.candidate().knobs().size(); i++) {
            Knob knob = best.candidate().knobs().get(i);
            if (!knob.isMoment() || best.failed()) {
                continue;
            }
            for (int round = 0; round < rounds; round++) {
                Fitter.State start = best;
                for (double shift : SHIFTS) {
                    double[] x = start.x().clone();
                    x[i] = knob.within(x[i] + shift);
                    Fitter.State look = fitter.look(start.candidate(), x, start.frame());
                    best = look.cost() < best.cost() ? look : best;
                }
                if (best == start) {
                    break;
                }
                Fitter.State again = fitter.fit(best.candidate(), best.x(), best.frame(), Effort.FIRST_STEPS, Effort.ENOUGH);
                best = again.cost() < best.cost() ? again : best;
            }
        }
        return best;
    }

    /** A leader fitted to the end, in the whitening of its own model. */
    public Fitter.State polish(Fitter.State fit) {
        return polish(fit.candidate(), fit.x());
    }

    /**
     * The same, and where it bent the model and leaves something still, begun anew from the model's numbers as given too: of two resonances
     * on one path, a neck's and a mount's, each may have taken the other's place, and no step leads back.
     */
    Fitter.State polishFromBoth(Fitter.State fit) {
        Fitter.State first = polish(fit);
        if (first.failed() || !bent(first) || excess(first.reduced()) <= PairSearch.QUIET) {
            return first;
        }
        Candidate candidate = first.candidate();
        Fitter.State anew = polish(candidate, Candidate.standing(first.x(), Arrays.copyOf(candidate.start(), candidate.given())));
        return !anew.failed() && anew.reduced() < first.reduced() ? anew : first;
    }

    /**
     * The same from coordinates at which nothing was simulated yet.
     *
     * @param x coordinates [1], one a knob. Not modified.
     */
    public Fitter.State polish(Candidate candidate, double[] x) {
        Fitter.State once = polishedOnce(candidate, x);
        return polishedOnce(candidate, once.x());
    }

    /**
     * The best of a hypothesis from some starts, polished; none if it fails.
     *
     * @param on what it is added to
     * @param x coordinates of that [1], one a knob. Not modified.
     * @param starts values of the hypothesis' numbers, each in its unit
     */
    List<Fitter.State> polished(Candidate on, Hypothesis hypothesis, double[] x, Fitter.Frame frame, List<double[]> starts) {
        Fitter.State best = fitted(on, hypothesis, x, frame, starts);
        return best.failed() ? List.of() : List.of(polish(best));
    }

    /** The same without polish, in the frame given; failed if all starts fail. */
    Fitter.State fitted(Candidate on, Hypothesis hypothesis, double[] x, Fitter.Frame frame, List<double[]> starts) {
        Candidate with = on.with(hypothesis);
        return Parallel
                .map(starts, values -> fitter.fit(with, on.extended(x, with, hypothesis, values), frame, Effort.STEPS, Effort.ENOUGH))
                .stream()
                .min(Comparator.comparingDouble(Fitter.State::cost)).orElseThrow();
    }

    /** The first steps from coordinates at which nothing was simulated yet, in the whitening of the model there. */
    Fitter.State begun(Candidate candidate, double[] x) {
        return fitter.fit(candidate, x, fitter.frame(candidate, x, evidence.fit()), Effort.FIRST_STEPS, Effort.ENOUGH);
    }

    private Fitter.State polishedOnce(Candidate candidate, double[] x) {
        return timed(fitter.fit(candidate, x, fitter.frame(candidate, x, evidence.fit()), Effort.POLISHING_STEPS, Effort.FINE),
                Effort.TRIES);
    }

    /**
     * Whether the numbers that one form of a law has more than another are worth their price, on data that were not used too.
     *
     * @param more how many; less than none cost nothing
     */
    public boolean pays(Fitter.State further, Fitter.State simpler, int more) {
        return outweighs(new Chosen(further, Math.max(0, more) * Calibration.standard().price()), Chosen.single(simpler));
    }

    /** Whether one is likelier than the other by data fitted and not used, see {@link Chosen#outweighs}. */
    public boolean outweighs(Chosen one, Chosen other) {
        return one.outweighs(heldOut(one.fit()), other, heldOut(other.fit()));
    }

    /** χ² per number on the held-out window [1]. */
    public double heldOut(Fitter.State fit) {
        return evidence.known().once(new Unused(fit.candidate(), fit.x()),
                () -> new Fitter(evidence, evidence.whole()).look(fit.candidate(), fit.x(), evidence.heldOut()).reduced());
    }

    /**
     * What a fit leaves of data not used is asked.
     *
     * @param x coordinates of the fit [1], one a knob; the same where it is the same array
     */
    private record Unused(Candidate candidate, double[] x) implements Known.Question<Double> {}

    /**
     * Whether the last hypothesis of a fit stands at a bound that nothing real has: a mass of half a person, a slow drift over in seconds.
     */
    public static boolean extreme(Fitter.State fit) {
        Hypothesis last = fit.candidate().last();
        return Arrays.stream(fit.candidate().positions(last)).anyMatch(i -> {
            Knob knob = fit.candidate().knobs().get(i);
            boolean free = knob.high() - knob.low() > 1e-2;   // a number that is held stands at a bound without meaning it
            boolean low = fit.x()[i] <= knob.low() + 1e-6;
            boolean high = fit.x()[i] >= knob.high() - 1e-6;
            return free && (low || high) && last.kind().imitatesAt(knob.key(), low);
        });
    }
}

package wbv.diagnosis;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import wbv.diagnosis.mechanism.Hypothesis;

/** How the best fit stands against the model without it and against others. */
final class Standing {

    private final Fitter.State base;
    private final Fitter.State best;
    private final List<Fitter.State> leaders;

    Standing(Fits fits) {
        this.base = fits.base();
        this.best = fits.best();
        this.leaders = fits.leaders();
    }

    /** Part of the mismatch that the found mechanisms explain. */
    double explained() {
        return explained(base, best);
    }

    static double explained(Fitter.State base, Fitter.State best) {
        return explained(base, best.reduced());
    }

    /** Part of a mismatch that is explained, 0 to 1. @param left mean square of the residual with it */
    static double explained(Fitter.State base, double left) {
        return Math.max(0, Math.min(1, (base.reduced() - left) / Math.max(base.reduced() - 1, 1e-9)));
    }

    /** How much worse the best other mechanism is, in units of what the best one leaves. */
    double rivalry() {
        Set<String> own = new HashSet<>();
        best.candidate().added().forEach(h -> own.add(h.mechanism() + h.where()));
        double rival = leaders.stream().filter(fit -> !own.contains(fit.candidate().last().mechanism() + fit.candidate().last().where()))
                .mapToDouble(Fitter.State::reduced).findFirst().orElse(base.reduced());
        return (Math.min(rival, base.reduced()) - best.reduced()) / Math.max(best.reduced() - 1, 0.1);
    }

    double probability(double rivalry) {
        double r = Math.max(0, rivalry);
        double p = 0.62 + 0.36 * r / (r + 1.5);
        double share = Math.min(1, explained() / 0.95);
        return Math.min(0.98, p * Math.pow(share, 2));
    }

    /**
     * The other mechanisms, each once, sharing what probability is left: none is likelier than what was named in proportion to what it leaves, and
     * what they do not take belongs to what is in no library.
     *
     * @param named probability of what was named; 1 where nothing was
     */
    List<Diagnosis.Named> rivals(double left, double named) {
        List<Diagnosis.Named> out = new ArrayList<>();
        Set<String> seen = new HashSet<>();
        best.candidate().added().forEach(h -> seen.add(h.mechanism() + h.where()));
        double share = left / 2;
        for (Fitter.State rival : leaders) {
            Hypothesis h = rival.candidate().added().get(0);
            if (out.size() < 5 && seen.add(h.mechanism() + h.where())) {
                double worse = Math.min(1, Refinement.excess(best.reduced()) / Refinement.excess(rival.reduced()));
                out.add(new Diagnosis.Named(h.mechanism(), h.where(), Math.min(share, named * worse), Map.of(), Map.of(), rival.reduced()));
                share /= 2;
            }
        }
        return out;
    }

    /** How credible a hypothesis is by itself: what explains more is said first, whichever was added first. */
    int rankAlone(Hypothesis hypothesis) {
        return IntStream.range(0, leaders.size()).filter(i -> leaders.get(i).candidate().added().stream()
                .allMatch(alone -> alone.mechanism().equals(hypothesis.mechanism()) && alone.where().equals(hypothesis.where())))
                .findFirst().orElse(leaders.size());
    }
}

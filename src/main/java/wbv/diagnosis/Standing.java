package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Calibration;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;

/** How the best fit stands against the model without it and against others. */
final class Standing {

    static final Claim UNKNOWN = Claim.elseAt("", "");
    /** Other mechanisms that are told. */
    private static final int RIVALS = 5;

    private final Fitter.State base;
    private final Fitter.State best;
    private final double price;
    private final List<Fitter.State> leaders;
    private final Posterior posterior;

    Standing(Fits fits) {
        this.base = fits.base();
        this.best = fits.best();
        this.price = fits.price();
        this.leaders = fits.leaders();
        this.posterior = posteriorOfAll();
    }

    /** Part of the mismatch that the found mechanisms explain. */
    double explained() {
        return Refinement.explained(base, best);
    }

    /** How likely what was found is, and what else it may be. */
    Posterior posterior() {
        return posterior;
    }

    /** How likely what was found is; nothing where nothing was. */
    double probability() {
        return best == base ? 0 : posterior.of(found());
    }

    /** How likely one of the mechanisms that were found is, whether the others are there or not. */
    double probability(Hypothesis hypothesis) {
        return posterior.mass(claim -> claim.equals(claim(hypothesis))) + (best.candidate().added().size() > 1 ? probability() : 0);
    }

    /** What is read off it: that a part of what was found is all there is does not contradict it. */
    DecisionRule.Reading reading() {
        Set<Claim> parts = best.candidate().added().stream().map(Standing::claim).collect(Collectors.toSet());
        Map<Claim, Double> merged = new LinkedHashMap<>();
        posterior.probabilities().forEach((claim, p) -> merged.merge(parts.contains(claim) ? found() : claim, p, Double::sum));
        return new DecisionRule(Priors.USUAL).read(new Posterior(merged));
    }

    /**
     * The likeliest other mechanisms, each once.
     *
     * @param most probability that they may have together
     */
    List<Diagnosis.Named> rivals(double most) {
        double sum = posterior.mass(claim -> claim.kind() == Claim.Kind.NAMED && !claim.equals(found()));
        double scale = sum > most ? most / sum : 1;
        List<Fitter.State> others = leaders.stream().filter(fit -> !isOwn(fit.candidate().added().get(0))).toList();
        return named(others, posterior, found()).stream().map(rival -> rival.at(scale * rival.probability())).toList();
    }

    /**
     * Single mechanisms as names, each once, likeliest first.
     *
     * @param but that is not among them
     */
    static List<Diagnosis.Named> named(List<Fitter.State> fits, Posterior posterior, Claim but) {
        Set<Claim> seen = new HashSet<>(Set.of(but));
        return fits.stream().filter(fit -> seen.add(claim(fit)))
                .map(fit -> new Diagnosis.Named(fit.candidate().last().mechanism(), fit.candidate().last().where(),
                        posterior.of(claim(fit)), Map.of(), Map.of(), fit.reduced()))
                .sorted(Comparator.comparingDouble(Diagnosis.Named::probability).reversed()).limit(RIVALS).toList();
    }

    /** What a fit claims: all that it adds, together. */
    static Claim claim(Fitter.State fit) {
        return Claim.named(fit.candidate().added().stream().map(Standing::name).collect(Collectors.joining(" + ")));
    }

    private Claim found() {
        return claim(best);
    }

    private boolean isOwn(Hypothesis hypothesis) {
        return best.candidate().added().stream().anyMatch(own -> name(own).equals(name(hypothesis)));
    }

    private static Claim claim(Hypothesis hypothesis) {
        return Claim.named(name(hypothesis));
    }

    private static String name(Hypothesis hypothesis) {
        return hypothesis.mechanism() + " at " + hypothesis.where();
    }

    /** What is left of each claim makes its evidence; all that is the same for all is left out. */
    private Posterior posteriorOfAll() {
        Calibration calibration = Calibration.standard();
        Map<Claim, Double> left = new LinkedHashMap<>();
        double least = leaders.stream().mapToDouble(Fitter.State::reduced).min().orElse(base.reduced());
        if (best != base) {
            // What was preferred to another that fits a little better is as likely.
            left.put(found(), Math.min(best.reduced(), least));
        }
        leaders.forEach(fit -> left.merge(claim(fit), fit.reduced(), Math::min));
        left.put(Claim.VALUES, base.reduced());
        left.put(UNKNOWN, 1 + Calibration.unlisted(base.reduced() - 1));
        double[] evidence = calibration.evidence(left.values().stream().mapToDouble(Double::doubleValue).toArray());
        List<Posterior.Weighed> all = new ArrayList<>();
        for (Claim claim : left.keySet()) {
            all.add(new Posterior.Weighed(claim, claim.equals(found()) ? Math.exp(-price) : 1, evidence[all.size()]));
        }
        return Posterior.of(all, 1).but(calibration.lapse(), UNKNOWN);
    }

    /** How credible a hypothesis is by itself: what explains more is said first, whichever was added first. */
    int rankAlone(Hypothesis hypothesis) {
        return IntStream.range(0, leaders.size()).filter(i -> leaders.get(i).candidate().added().stream()
                .allMatch(alone -> alone.mechanism().equals(hypothesis.mechanism()) && alone.where().equals(hypothesis.where())))
                .findFirst().orElse(leaders.size());
    }
}

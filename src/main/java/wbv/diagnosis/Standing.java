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
import java.util.stream.Stream;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Calibration;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.OwnNumbers;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;

/** How the best fit stands against the model without it and against others. */
final class Standing {

    static final Claim UNKNOWN = Claim.elseAt("", "");
    /** Other mechanisms that are told. */
    private static final int RIVALS = 5;
    /** By how much less likely a fit may be than the likeliest to be of no account, whatever else speaks for it [nat]. */
    private static final double NEGLIGIBLE = 15;
    private static final String AT = " at ";

    private final Fitter.State base;
    private final Fitter.State best;
    private final double price;
    private final List<Fitter.State> leaders;
    private final List<Weight> weights;
    private final Posterior posterior;

    /**
     * What a fit says for its claim.
     *
     * @param evidence of the data, but for what is the same for all [nat]
     * @param numbers  of the model's own numbers [nat]
     */
    private record Weight(Claim claim, Fitter.State fit, double evidence, double numbers) {

        double sum() {
            return evidence + numbers;
        }

        Weight withNumbers(double own) {
            return new Weight(claim, fit, evidence, own);
        }
    }

    Standing(Fits fits) {
        this.base = fits.base();
        this.best = fits.best();
        this.price = fits.price();
        this.leaders = fits.leaders();
        this.weights = weights(fits.evidence());
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
        List<Fitter.State> others = strongest().filter(weight -> weight.fit().candidate().added().size() == 1)
                .map(Weight::fit).filter(fit -> !isOwn(fit.candidate().last())).toList();
        return named(others, posterior, found()).stream()
                .map(rival -> rival.at(scale * rival.probability()).with(numbers(Claim.named(rival.mechanism() + AT + rival.where()))))
                .toList();
    }

    /** How likely the model's own numbers are with what was found [nat], 0 or less. */
    double numbers() {
        return numbers(found());
    }

    private double numbers(Claim claim) {
        return strongest().filter(weight -> weight.claim().equals(claim)).findFirst().map(Weight::numbers).orElse(0.0);
    }

    private Stream<Weight> strongest() {
        return weights.stream().filter(weight -> weight.claim().kind() == Claim.Kind.NAMED)
                .sorted(Comparator.comparingDouble(Weight::sum).reversed());
    }

    /**
     * Single mechanisms as names, each once by the first of its forms, likeliest first.
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
        return hypothesis.mechanism() + AT + hypothesis.where();
    }

    /**
     * What is left of each claim and how far the model's own numbers had to move for it make its evidence; all that is the same for all is
     * left out. Best first; numbers are looked at as far down as they may matter.
     */
    private List<Weight> weights(Evidence evidence) {
        Calibration calibration = Calibration.standard();
        double unlisted = 1 + Calibration.unlisted(base.reduced() - 1);
        double least = Stream.concat(leaders.stream(), Stream.of(base, best)).mapToDouble(Fitter.State::reduced)
                .reduce(unlisted, Math::min);
        List<Weight> all = new ArrayList<>(List.of(new Weight(Claim.VALUES, base, calibration.evidence(base.reduced(), least), 0)));
        leaders.forEach(fit -> all.add(new Weight(claim(fit), fit, calibration.evidence(fit.reduced(), least), 0)));
        if (best != base) {
            // What was preferred to another that fits a little better is as likely.
            double left = leaders.stream().mapToDouble(Fitter.State::reduced).reduce(best.reduced(), Math::min);
            all.add(new Weight(found(), best, calibration.evidence(left, least) - price, 0));
        }
        all.sort(Comparator.comparingDouble(Weight::evidence).reversed());
        Fitter fitter = new Fitter(evidence);
        List<Weight> out = new ArrayList<>();
        double most = Double.NEGATIVE_INFINITY;
        for (Weight weight : all) {
            // What stands for a simulation has numbers that nobody gave.
            boolean matters = weight.evidence() > most - NEGLIGIBLE && !evidence.standsForSimulation();
            Weight whole = matters ? weight.withNumbers(OwnNumbers.logPrior(fitter, weight.fit())) : weight;
            most = Math.max(most, whole.sum());
            out.add(whole);
        }
        out.sort(Comparator.comparingDouble(Weight::sum).reversed());
        // What is in no library moves them as the likeliest does.
        out.add(new Weight(UNKNOWN, base, calibration.evidence(unlisted, least), out.get(0).numbers()));
        return out;
    }

    /** Of every claim by the likeliest of its forms. */
    private Posterior posteriorOfAll() {
        Map<Claim, Double> strongest = new LinkedHashMap<>();
        weights.forEach(weight -> strongest.merge(weight.claim(), weight.sum(), Math::max));
        return Posterior.of(strongest.entrySet().stream().map(each -> new Posterior.Weighed(each.getKey(), 1, each.getValue())).toList(), 1)
                .but(Calibration.standard().lapse(), UNKNOWN);
    }

    /** How credible a hypothesis is by itself: what explains more is said first, whichever was added first. */
    int rankAlone(Hypothesis hypothesis) {
        return IntStream.range(0, leaders.size()).filter(i -> leaders.get(i).candidate().added().stream()
                .allMatch(alone -> alone.mechanism().equals(hypothesis.mechanism()) && alone.where().equals(hypothesis.where())))
                .findFirst().orElse(leaders.size());
    }
}

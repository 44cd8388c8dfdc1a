package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Calibration;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.OwnNumbers;
import wbv.diagnosis.search.Refinement;

/** How the best fit stands against the model without it and against others. */
final class Standing {

    private final Fits fits;
    private final Fitter.State base;
    private final Fitter.State best;
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

        int parts() {
            return fit.candidate().added().size();
        }

        Weight withNumbers(double own) {
            return new Weight(claim, fit, evidence, own);
        }
    }

    Standing(Fits fits) {
        // What was preferred to another that fits a little better is as likely.
        this(fits, fits.leaders().stream().mapToDouble(Fitter.State::reduced).reduce(fits.best().reduced(), Math::min));
    }

    /** @param left what the data see of what was found: its mean square [1] */
    private Standing(Fits fits, double left) {
        this.fits = fits;
        this.base = fits.base();
        this.best = fits.best();
        this.leaders = fits.leaders();
        this.weights = weights(left);
        this.posterior = posteriorOfAll();
    }

    /** With the likeliest as what was found, where the model's own numbers speak for another name than the best fit has. */
    static Standing of(Fits fits) {
        Standing asFitted = new Standing(fits);
        return asFitted.likelier().map(other -> new Standing(fits.with(other), other.reduced())).orElse(asFitted);
    }

    /**
     * What is likelier than what was found, with data not used as well, and stands at no bound that nothing real has. Several together give
     * way to as many others and to one of them alone, and to one that is none of them only where they are no part of the answer.
     */
    private Optional<Fitter.State> likelier() {
        int parts = best.candidate().added().size();
        if (parts == 0) {
            return Optional.empty();
        }
        DecisionRule.Reading reading = reading();
        boolean answered = reading.isUnknown() || reading.claims().contains(found());
        Predicate<Weight> open = weight -> weight.parts() == parts
                || weight.parts() == 1 && (!answered || isOwn(weight.fit().candidate().last()));
        return weights.stream().takeWhile(weight -> !weight.claim().equals(found())).filter(open)
                .filter(weight -> !Refinement.extreme(weight.fit()) && fits.isLikelier(weight.fit(), weight.numbers() - numbers()))
                .map(Weight::fit).findFirst();
    }

    /** What all this is about, with what was found as the best. */
    Fits fits() {
        return fits;
    }

    /** Part of the mismatch that the found mechanisms explain. */
    double explained() {
        return Refinement.explained(base, best);
    }

    /** How likely what was found is; nothing where nothing was. */
    double probability() {
        return best == base ? 0 : posterior.of(found());
    }

    /** How likely one of the mechanisms that were found is, whether the others are there or not. */
    double probability(Hypothesis hypothesis) {
        Set<Claim> with = weights.stream().filter(weight -> weight.fit().candidate().added().stream().anyMatch(own(hypothesis)))
                .map(Weight::claim).collect(Collectors.toSet());
        return posterior.mass(with::contains);
    }

    /** What is read off it: that a part of what was found is all there is does not contradict it. */
    DecisionRule.Reading reading() {
        Set<Claim> parts = best.candidate().added().stream().map(Standing::claim).collect(Collectors.toSet());
        Map<Claim, Double> merged = new LinkedHashMap<>();
        posterior.probabilities().forEach((claim, p) -> merged.merge(parts.contains(claim) ? found() : claim, p, Double::sum));
        return DecisionRule.read(new Posterior(merged));
    }

    /**
     * The likeliest other mechanisms, each once.
     *
     * @param most probability that they may have together
     */
    List<Diagnosis.Named> rivals(double most) {
        return names(Set.of(found()), most);
    }

    /** The same beside what is told otherwise. */
    List<Diagnosis.Named> names(Set<Claim> told, double most) {
        double sum = posterior.mass(claim -> claim.kind() == Claim.Kind.NAMED && !told.contains(claim));
        double scale = sum > most ? most / sum : 1;
        Set<Claim> seen = new HashSet<>(told);
        return weights.stream().filter(weight -> seen.add(weight.claim())).flatMap(weight -> weight.fit().candidate().added().stream()
                .filter(hypothesis -> !isOwn(hypothesis)).limit(1)
                .map(other -> named(other, weight.fit(), scale * posterior.of(weight.claim())).with(weight.numbers())))
                .limit(VerdictWords.RIVALS).toList();
    }

    /** How likely the model's own numbers are with what was found [nat], 0 or less. */
    double numbers() {
        return weights.stream().filter(weight -> weight.claim().equals(found())).mapToDouble(Weight::numbers).findFirst().orElse(0);
    }

    /**
     * Single mechanisms as names, each once, likeliest first.
     *
     * @param but that is not among them
     */
    static List<Diagnosis.Named> named(List<Fitter.State> fits, Posterior posterior, Claim but) {
        Set<Claim> seen = new HashSet<>(Set.of(but));
        return fits.stream().filter(fit -> seen.add(claim(fit)))
                .map(fit -> named(fit.candidate().last(), fit, posterior.of(claim(fit))))
                .sorted(Comparator.comparingDouble(Diagnosis.Named::probability).reversed()).limit(VerdictWords.RIVALS).toList();
    }

    private static Diagnosis.Named named(Hypothesis hypothesis, Fitter.State fit, double probability) {
        return new Diagnosis.Named(hypothesis.mechanism(), hypothesis.where(), probability, Map.of(), Map.of(), fit.reduced())
                .in(hypothesis.kind().form(hypothesis, Map.of(), () -> Double.NaN));
    }

    /** What a fit claims: all that it adds, together, in whatever order. */
    static Claim claim(Fitter.State fit) {
        return Claim.named(fit.candidate().added().stream().map(Standing::name).sorted().collect(Collectors.joining(" + ")));
    }

    private Claim found() {
        return claim(best);
    }

    private boolean isOwn(Hypothesis hypothesis) {
        return best.candidate().added().stream().anyMatch(own(hypothesis));
    }

    private static Predicate<Hypothesis> own(Hypothesis hypothesis) {
        return other -> name(other).equals(name(hypothesis));
    }

    private static Claim claim(Hypothesis hypothesis) {
        return Claim.named(name(hypothesis));
    }

    private static String name(Hypothesis hypothesis) {
        return hypothesis.mechanism() + " at " + hypothesis.where();
    }

    /**
     * What each fit leaves and how far it had to move the model's own numbers make its evidence; all that is the same for all is left out.
     * Likeliest first, last what is in no library, which is supposed to move them as the likeliest does.
     *
     * @param ofBest mean square that is left of what was found [1]
     */
    private List<Weight> weights(double ofBest) {
        Calibration calibration = Calibration.standard();
        double unlisted = 1 + Calibration.unlisted(base.reduced() - 1);
        double least = Stream.concat(leaders.stream(), Stream.of(base, best)).mapToDouble(Fitter.State::reduced)
                .reduce(unlisted, Math::min);
        List<Weight> all = new ArrayList<>(List.of(new Weight(Claim.VALUES, base, calibration.evidence(base.reduced(), least), 0)));
        leaders.forEach(fit -> all.add(new Weight(claim(fit), fit, calibration.evidence(fit.reduced(), least) - fits.price(fit), 0)));
        if (best != base) {
            all.add(new Weight(found(), best, calibration.evidence(ofBest, least) - fits.price(), 0));
        }
        // What stands for a simulation has numbers that nobody gave.
        List<Weight> out = fits.evidence().standsForSimulation() ? all : withNumbers(fits.evidence(), all);
        out.sort(Comparator.comparingDouble(Weight::sum).reversed());
        out.add(new Weight(Claim.UNKNOWN, base, calibration.evidence(unlisted, least), out.get(0).numbers()));
        return out;
    }

    /** Numbers are looked at from the best fit down, as far as they may matter. */
    private static List<Weight> withNumbers(Evidence evidence, List<Weight> all) {
        Fitter fitter = new Fitter(evidence);
        List<Weight> out = new ArrayList<>();
        double most = Double.NEGATIVE_INFINITY;
        for (Weight weight : all.stream().sorted(Comparator.comparingDouble(Weight::evidence).reversed()).toList()) {
            boolean matters = weight.evidence() > most - Effort.NEGLIGIBLE;
            out.add(matters ? weight.withNumbers(OwnNumbers.logPrior(fitter, weight.fit())) : weight);
            most = Math.max(most, out.get(out.size() - 1).sum());
        }
        return out;
    }

    /** Of every claim by the likeliest of its forms. */
    private Posterior posteriorOfAll() {
        Map<Claim, Double> strongest = new LinkedHashMap<>();
        weights.forEach(weight -> strongest.merge(weight.claim(), weight.sum(), Math::max));
        return Posterior.of(strongest.entrySet().stream().map(each -> new Posterior.Weighed(each.getKey(), 1, each.getValue())).toList())
                .but(Calibration.standard().lapse(), Claim.UNKNOWN);
    }

    /** How credible a hypothesis is by itself: what explains more is said first, whichever was added first. */
    int rankAlone(Hypothesis hypothesis) {
        return IntStream.range(0, leaders.size()).filter(i -> leaders.get(i).candidate().added().stream()
                .allMatch(alone -> alone.mechanism().equals(hypothesis.mechanism()) && alone.where().equals(hypothesis.where())))
                .findFirst().orElse(leaders.size());
    }
}

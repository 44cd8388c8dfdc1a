package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.Family;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;

/** Whether the mechanisms of the best hypothesis are named, and how surely. */
final class Naming {

    private final Grounds grounds;
    private final Standing standing;
    private final Fitter.State base;
    private final Fitter.State best;

    Naming(Grounds grounds) {
        this.grounds = grounds;
        this.standing = grounds.standing();
        this.base = grounds.base();
        this.best = grounds.best();
    }

    /**
     * Whether the best hypothesis is what the posterior says, and data not used say so too. So near to the noise only a name without a
     * rival is a finding.
     */
    boolean isWorth() {
        DecisionRule.Reading reading = standing.reading();
        return best != base && !reading.isUnknown() && grounds.foretells(best)
                && (grounds.heldBefore() > Priors.SILENT || reading.isName());
    }

    /**
     * The mechanisms of the best hypothesis; not by name alone where they leave too much, and not at all where all of it may as well be
     * nothing.
     *
     * @param locate finds the places that could carry the mismatch; asked only where the name is not good enough
     */
    Optional<Explanation> explanation(Supplier<List<Diagnosis.Latent>> locate) {
        boolean poor = isPoor();
        Values values = new Values(grounds.evidence(), best);
        Map<Hypothesis, Diagnosis.Named> claimed = claimed(values, poor ? Priors.MAJORITY : 1);
        boolean nothing = claimed.entrySet().stream().allMatch(each -> mayBeNothing(each.getKey(), each.getValue()));
        return nothing ? Optional.empty() : Optional.of(poor ? unsure(values, claimed, locate.get()) : sure(values, claimed));
    }

    /**
     * What comes nearest where no name is the answer, to predict with: empty where data not used do not surely go better with it, or where
     * it stands at a bound that nothing real has.
     */
    Optional<Explanation> nearest(List<Diagnosis.Latent> places) {
        boolean real = best != base && !Refinement.extreme(best) && grounds.foretells(best);
        List<Diagnosis.Proof> proofs = real ? grounds.shown().figures(best).channels() : List.of();
        boolean better = proofs.stream().anyMatch(proof -> proof.removed().low() > 0)
                && proofs.stream().noneMatch(proof -> proof.removed().high() < 0);
        if (!better) {
            return Optional.empty();
        }
        Values values = new Values(grounds.evidence(), best);
        return Optional.of(unsure(values, claimed(values, 1 - Priors.HELD), places));
    }

    private Explanation unsure(Values values, Map<Hypothesis, Diagnosis.Named> claimed, List<Diagnosis.Latent> places) {
        List<Diagnosis.Named> missing = List.copyOf(claimed.values());
        String nearest = grounds.words().nearest(missing, standing.explained(), grounds.heldAfter());
        return new Explanation(Diagnosis.Verdict.UNEXPLAINED, values.fit(), values.scale(), missing,
                standing.rivals(1 - standing.probability()), places, grounds.words().entering(places) + nearest);
    }

    private Explanation sure(Values values, Map<Hypothesis, Diagnosis.Named> claimed) {
        double p = standing.probability();
        List<Diagnosis.Named> missing = new ArrayList<>(claimed.values());
        new Pushes(grounds).beside(values.scale(), p).ifPresent(missing::add);
        List<Diagnosis.Named> rivals = standing.rivals(1 - p);
        return new Explanation(
                standing.reading().names() > 1 ? Diagnosis.Verdict.AMBIGUOUS : Diagnosis.Verdict.MISSING_PHYSICS, values.fit(),
                values.scale(), missing, rivals, List.of(),
                grounds.words().ending(standing.explained(), standing.numbers(), rivals));
    }

    /** Whether the best hypothesis is not good enough: what fits best at a bound that nothing real has is something else. */
    private boolean isPoor() {
        return !carriesOver() || Refinement.extreme(best);
    }

    /**
     * Whether data not used for the fit are explained about as well, where they show something: a wrong law with enough freedom follows
     * only what it has seen. What leaves no more than noise there, be it as loud as it may, explains all that they show.
     */
    private boolean carriesOver() {
        double floor = grounds.evidence().floor();
        double before = grounds.heldBefore();
        double explained = (base.reduced() - best.reduced()) / (base.reduced() - floor);
        return before < Priors.STRANGE * floor || grounds.heldAfter() < Priors.SILENT
                || (before - grounds.heldAfter()) / (before - floor) > (1 - Priors.UNLISTED) * explained;
    }

    /** @param most how sure a name may be */
    private Map<Hypothesis, Diagnosis.Named> claimed(Values values, double most) {
        Map<Hypothesis, Diagnosis.Named> out = new LinkedHashMap<>();
        best.candidate().added().stream().sorted(Comparator.comparingInt(standing::rankAlone))
                .forEach(hypothesis -> out.put(hypothesis,
                        values.named(hypothesis, Math.min(most, standing.probability(hypothesis))).with(standing.numbers())));
        return out;
    }

    /** Whether a sensor's fault may be none by all that is told of its size: what may be nothing is not named. */
    private static boolean mayBeNothing(Hypothesis hypothesis, Diagnosis.Named named) {
        List<Hypothesis.Number> told = hypothesis.numbers().stream().filter(number -> named.intervals().containsKey(number.key())).toList();
        return hypothesis.kind().family() == Family.SENSOR && !told.isEmpty()
                && told.stream().allMatch(number -> number.unit() > 0 && named.intervals().get(number.key()).contains(number.nothing()));
    }
}

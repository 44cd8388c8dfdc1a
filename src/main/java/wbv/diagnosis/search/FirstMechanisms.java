package wbv.diagnosis.search;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import wbv.diagnosis.fit.BodyForce;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * What is compared by itself before any pair is: mechanisms that were sought by themselves, or, where whatever enters at one place does
 * not explain what is missing, the parts of a pair at two places.
 */
final class FirstMechanisms {

    private final Evidence evidence;
    private final Refinement refinement;
    private final Fitter.State base;
    private final TwoPlaces places;

    /** @param base the model without any mechanism, fitted */
    FirstMechanisms(Evidence evidence, Refinement refinement, Fitter.State base, TwoPlaces places) {
        this.evidence = evidence;
        this.refinement = refinement;
        this.base = base;
        this.places = places;
    }

    /**
     * The first mechanisms by themselves, least first: the parts of a pair at two places where no one place will do, since then none that
     * is sought by itself will.
     *
     * @param sought those that are sought by themselves
     * @param isOneLaw whether one law at one place does what the best of them does not
     */
    List<Fitter.State> leaders(Supplier<List<Fitter.State>> sought, Predicate<Fitter.State> isOneLaw) {
        if (evidence.outputs().size() < Locator.FEWEST_OUTPUTS) {
            return sought.get();
        }
        Optional<List<Fitter.State>> first = places.mayBeOne() ? Optional.of(sought.get()) : Optional.empty();
        return first
                .filter(found -> atAny() <= PairSearch.QUIET || found.stream().anyMatch(fit -> leavesLess(fit) || leavesScatter(fit))
                        || found.stream().limit(1).anyMatch(isOneLaw))
                .or(this::parts).or(() -> first).orElseGet(sought);
    }

    /**
     * Whether two mechanisms at two places explain nearly all, or leave no more than places do, where no one place will do; or take what a
     * force that nobody measured might make beside one of them.
     */
    boolean isPair(Fitter.State single) {
        return atTwo().filter(pair -> Refinement.explainsNearlyAll(base, pair) || leavesScatter(pair)).isPresent()
                || measured(single).filter(pair -> Refinement.isTaken(single.reduced(), pair.reduced())).isPresent();
    }

    /**
     * The pair along what was measured that leaves less than a single mechanism; empty where none does, and where none is looked for:
     * beside whatever enters at one place there is nothing left for a second elsewhere.
     */
    Optional<Fitter.State> measured(Fitter.State single) {
        return evidence.outputs().size() == 1 || atAny() <= PairSearch.QUIET ? Optional.empty()
                : places.measured().map(MeasuredHeats.Found::fit).filter(pair -> pair.reduced() < single.reduced());
    }

    /**
     * Whether a fit leaves no more than what places leave scatters by: a second that is left shows beside it alone, not where places are
     * ignored.
     */
    boolean leavesScatter(Fitter.State fit) {
        return Refinement.excess(fit.reduced()) <= places.scatter();
    }

    private record AtTwo(Fitter.State base) implements Known.Question<Optional<Fitter.State>> {}

    /** The pair at two places that leaves far less than whatever enters at any one; empty where there is none. Kept with the evidence. */
    Optional<Fitter.State> atTwo() {
        return evidence.known().once(new AtTwo(base), this::soughtAtTwo);
    }

    private Optional<Fitter.State> soughtAtTwo() {
        // No pair leaves far less than a place that leaves little more than noise.
        if (evidence.outputs().size() == 1 || atAny() <= Effort.BEHIND * PairSearch.QUIET) {
            return Optional.empty();
        }
        Place first = places.likeliest();
        TwoPlaces.Looked looked = places.looked(first);
        double alone = Refinement.excess(Locator.left(looked.singles(), first));
        return alone > PairSearch.QUIET ? measured().or(() -> ignoring(first, alone, looked)).filter(this::leavesLess) : Optional.empty();
    }

    /** The pair along what was measured, if none can explain much more. */
    private Optional<Fitter.State> measured() {
        return places.measured().filter(pair -> leavesLess(pair.fit()) && (pair.fit().reduced() < Refinement.form(base)
                || places.explains(pair) || leavesOwnForce(pair.fit())))
                .map(MeasuredHeats.Found::fit);
    }

    /** Whether all that a pair leaves, but for the forms of its laws, is what a person does who sits still. */
    private boolean leavesOwnForce(Fitter.State pair) {
        return evidence.acting().own().isEmpty() && BodyForce.aboveBase(evidence, pair).filter(force -> force.ordinary(evidence))
                .filter(force -> new Refinement(evidence.with(force)).polish(pair).reduced()
                        < Math.max(Priors.SILENT, Refinement.form(base)))
                .isPresent();
    }

    /** The pair of which each part shows while whatever acts at the other's place is ignored. */
    private Optional<Fitter.State> ignoring(Place first, double alone, TwoPlaces.Looked looked) {
        List<Known.Ignoring> pairs = looked.locator().isBlindToTwo() ? List.of() : places.pairs(looked);
        return pairs.isEmpty() || TwoPlaces.needless(first, alone, pairs) ? Optional.empty() : places.pair(pairs);
    }

    private record Alone(Hypothesis hypothesis, Fitter.State pair) implements Known.Question<Fitter.State> {}

    /** A fit of one hypothesis of a pair without the other. Kept with the evidence. */
    Fitter.State alone(Hypothesis hypothesis, Fitter.State pair) {
        return evidence.known().once(new Alone(hypothesis, pair), () -> {
            Candidate one = base.candidate().with(hypothesis);
            return refinement.polish(one, base.candidate().alone(pair.candidate(), pair.x(), one, hypothesis));
        });
    }

    /** Whether a fit leaves far less than whatever enters at any one place seems to. */
    private boolean leavesLess(Fitter.State fit) {
        return Effort.BEHIND * Refinement.excess(fit.reduced()) < atAny();
    }

    /** The parts by themselves, least first, of a pair at two places where no one place will do. */
    private Optional<List<Fitter.State>> parts() {
        return atTwo().map(pair -> Trial.sorted(pair.candidate().added().stream().map(part -> alone(part, pair)).toList()));
    }

    /** Excess [1] that is left where whatever enters at any one place is ignored. */
    private double atAny() {
        return places.left(places.likeliest());
    }
}

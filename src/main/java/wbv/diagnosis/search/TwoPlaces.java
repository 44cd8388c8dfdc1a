package wbv.diagnosis.search;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Place;

/**
 * Whether what a model lacks enters at one place or at two, and what a pair of mechanisms at two of them explains. What was looked at is
 * kept with the evidence.
 */
final class TwoPlaces {

    private final Evidence evidence;
    private final Search search;
    private final Fitter.State base;
    private final BiConsumer<String, Double> progress;

    /**
     * Of what is missing beside a fit.
     *
     * @param base the model without any mechanism
     */
    TwoPlaces(Evidence evidence, Search search, Fitter.State base, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.search = search;
        this.base = base;
        this.progress = progress;
    }

    /** Places one by one, best first, as some data show them. */
    record Looked(Locator locator, List<Known.Ignoring> singles) {}

    private record Beside(List<Known.Ignoring> singles) implements Known.Question<List<Known.Ignoring>> {}

    private record At(List<Known.Ignoring> places) implements Known.Question<Optional<Fitter.State>> {}

    private record On(Fitter.State base) implements Known.Question<Optional<MeasuredHeats.Found>> {}

    /** Where all that is missing enters most likely, if it does at one place. */
    Place likeliest() {
        return seen().singles().get(0).places().get(0);
    }

    /**
     * On a part of the data where that shows beside a place as much as all of them do; else on all.
     *
     * @param own the place
     */
    Looked looked(Place own) {
        Locator whole = new Locator(evidence, base.candidate());
        return Optional.of(seen())
                .filter(part -> Refinement.excess(whole.left(own, base.x()))
                        < Effort.ALIKE * Refinement.excess(Locator.left(part.singles(), own)))
                .orElseGet(() -> new Looked(whole, whole.singles(base.x())));
    }

    /** On a part of the data where there is one. */
    private Looked seen() {
        Locator locator = new Locator(evidence.brief().orElse(evidence), base.candidate());
        return new Looked(locator, locator.singles(base.x()));
    }

    /** Pairs of places, best first. */
    List<Known.Ignoring> pairs(Looked looked) {
        return evidence.known().once(new Beside(looked.singles()), () -> looked.locator().pairs(looked.singles()));
    }

    /**
     * The pair of mechanisms that leaves least: along what was measured, or else as {@link PlacePairs} finds it.
     *
     * @param places pairs of them, best first
     */
    Optional<Fitter.State> pair(List<Known.Ignoring> places) {
        return evidence.known().once(new At(places), () -> soughtPair(places));
    }

    private Optional<Fitter.State> soughtPair(List<Known.Ignoring> places) {
        double good = Math.max(Locator.reach(places, Effort.BEHIND), Refinement.form(base));
        Optional<Fitter.State> known = measured().map(MeasuredHeats.Found::fit);
        return measured().filter(pair -> pair.fit().reduced() < good || explains(pair)).isPresent() ? known
                : new PlacePairs(evidence, search, base, progress).pair(NearPairs.of(evidence, base, places), known, good)
                        .map(pair -> pair.reduced() < good ? pair : rivals().formed(pair));
    }

    /** Whether a pair explains nearly all, where no other came near. */
    boolean explains(MeasuredHeats.Found pair) {
        return pair.isAlone() && Refinement.explainsNearlyAll(base, pair.fit());
    }

    /** The pair at any two places that fits best along what was measured. */
    Optional<MeasuredHeats.Found> measured() {
        return evidence.known().once(new On(base), () -> {
            progress.accept("pairs", 0.4);
            Motion motion = Motion.measured(evidence, base.candidate().at(base.x()));
            return new MeasuredHeats(evidence, base, motion, search.hypotheses(base))
                    .two(both -> true, Twins.of(evidence, base.candidate())).map(this::inTurn);
        });
    }

    private MeasuredHeats.Found inTurn(MeasuredHeats.Found pair) {
        return new MeasuredHeats.Found(rivals().inTurn(pair.fit()), pair.isAlone());
    }

    private PairRivals rivals() {
        return new PairRivals(evidence, search, base);
    }

    /**
     * Whether a second place explains little beside one.
     *
     * @param alone excess where the one is ignored
     * @param pairs on the same data
     */
    static boolean needless(Place own, double alone, List<Known.Ignoring> pairs) {
        List<Known.Ignoring> beside = pairs.stream().filter(pair -> pair.places().contains(own)).toList();
        return !beside.isEmpty() && beside.stream().allMatch(pair -> Refinement.excess(pair.reduced()) > Priors.MAJORITY * alone);
    }

    /** Whether nearly all that is missing enters at one place. */
    boolean mayBeOne() {
        return atOne(seen().singles().get(0));
    }

    /**
     * Whether nearly all that is missing enters at a place.
     *
     * @param best as a part of the data may show it
     */
    boolean atOne(Known.Ignoring best) {
        double most = scatter();
        return Refinement.excess(best.reduced()) <= most
                && left(best.places().get(0)) <= most;
    }

    /** Excess [1] that all data show while a place is ignored. */
    double left(Place place) {
        return Refinement.excess(new Locator(evidence, base.candidate()).left(place, base.x()));
    }

    /** Excess that a place leaves at most where all that is missing enters [1]. */
    double scatter() {
        return Refinement.excess(Locator.scatter(base, Effort.BEHIND));
    }
}

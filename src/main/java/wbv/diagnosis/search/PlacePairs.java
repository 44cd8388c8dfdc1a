package wbv.diagnosis.search;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;

/**
 * Two mechanisms at two places: one races while whatever enters at the other's place is ignored, the other beside it as that moves, then
 * both give way in turn. Where a model has bent far to make up for what is missing, or a sensor is so wrong that what it measured is no
 * motion, this begins nearer to the truth than what races along the motion as measured. Proposes, and decides nothing.
 */
final class PlacePairs {

    private final Evidence evidence;
    private final Search search;
    private final Fitter.State base;
    private final BiConsumer<String, Double> progress;

    /** @param base the model without any mechanism, fitted */
    PlacePairs(Evidence evidence, Search search, Fitter.State base, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.search = search;
        this.base = base;
        this.progress = progress;
    }

    /** The mechanism that leaves least while whatever enters at a place is ignored, as it was fitted then. */
    private record First(Place ignored, Fitter.State fit) {}

    /**
     * The pair that leaves least.
     *
     * @param near pairs of places where it may act
     * @param known found in another way, if any was
     * @param good what counts as next to nothing
     */
    Optional<Fitter.State> pair(NearPairs near, Optional<Fitter.State> known, double good) {
        progress.accept("pairs", 0.4);
        Optional<Fitter.State> best = known;
        for (First first : firsts(near)) {
            // Nothing where a place is ignored leaves less than is left so.
            double least = best.map(Fitter.State::reduced).orElse(Double.POSITIVE_INFINITY);
            if (least >= good && first.fit().reduced() < least) {
                best = Stream
                        .concat(best.stream(), second(first, near.twins()).map(new PairRivals(evidence, search, base)::inTurn).stream())
                        .min(Comparator.comparingDouble(Fitter.State::reduced));
            }
        }
        return best;
    }

    /** What shows beside the first places of the nearest pairs, least first. */
    private List<First> firsts(NearPairs near) {
        return Parallel.map(near.each().stream().limit(Effort.PLACES).toList(), one -> first(one, near.partners(one))).stream()
                .flatMap(Optional::stream).sorted(Comparator.comparingDouble(first -> first.fit().reduced())).limit(Effort.SECONDS)
                .toList();
    }

    /** @param places where it may act, likeliest first, with the base's numbers as they fit beside both */
    private Optional<First> first(Place ignored, Map<Place, double[]> places) {
        Search blind = new Search(evidence.ignoring(ignored), progress);
        double[] x = new VariableProjection(evidence, List.of(ignored)).base(base.candidate(), places.values().iterator().next()).fit().x();
        return blind.racedAsMeasured(base.candidate(), x, search.hypotheses(base, places::containsKey)).map(fit -> new First(ignored, fit));
    }

    /** What acts where a first was ignored, or at a place that no output tells apart, beside that as it moves. */
    private Optional<Fitter.State> second(First first, Twins twins) {
        return search.racedAsMoved(first.fit().candidate(), first.fit().x(), base.frame(),
                search.hypotheses(base, twins.of(first.ignored())::contains));
    }
}

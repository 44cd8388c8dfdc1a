package wbv.diagnosis.search;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Place;

/**
 * Pairs of places that leave about as little as the best.
 *
 * @param pairs best first
 * @param twins which of all places outputs do not tell apart
 */
record NearPairs(List<Known.Ignoring> pairs, Twins twins) {

    /**
     * Of some: those some times as far from the noise as the best, or as far as what they leave scatters.
     *
     * @param base the model alone, fitted
     * @param all best first
     */
    static NearPairs of(Evidence evidence, Fitter.State base, List<Known.Ignoring> all) {
        double reach = Math.max(Locator.reach(all, Effort.ALIKE), Locator.scatter(base, Effort.ALIKE));
        return new NearPairs(all.stream().filter(pair -> pair.reduced() < reach).toList(), Twins.of(evidence, base.candidate()));
    }

    /** The places of each pair, best first; of twins one, and none that makes a pair with its twins alone. */
    List<Place> each() {
        return pairs.stream().flatMap(pair -> pair.places().stream()).map(twins::first).distinct().filter(one -> !partners(one).isEmpty())
                .toList();
    }

    /** The places that make a pair with one or a twin of it, best first, with the base's numbers as they fit beside both. */
    Map<Place, double[]> partners(Place one) {
        List<Place> same = twins.of(one);
        Map<Place, double[]> out = new LinkedHashMap<>();
        pairs.stream().filter(pair -> pair.places().stream().anyMatch(same::contains)).forEach(pair -> pair.places().stream()
                .filter(place -> !same.contains(place)).forEach(place -> out.putIfAbsent(place, pair.x())));
        return out;
    }
}

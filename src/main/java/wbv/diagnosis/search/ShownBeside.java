package wbv.diagnosis.search;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Place;

/**
 * Which mechanisms show at a place while whatever enters at another is ignored. No mechanism at that other place can leave less than is
 * left so: what is far behind here is no rival beside any. What was sought is kept with the evidence.
 */
final class ShownBeside {

    private final Evidence evidence;
    private final BiConsumer<String, Double> progress;
    private final Fitter.State base;

    /** @param base the model without any mechanism, fitted */
    ShownBeside(Evidence evidence, Fitter.State base, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.base = base;
        this.progress = progress;
    }

    /** @param x told by being the same array */
    private record Asked(double[] x, Place ignored, Set<Place> places) {}

    /**
     * What was fitted while a place is ignored.
     *
     * @param without the model alone
     * @param fits with one mechanism each, least first; none where the model alone leaves noise
     */
    record Shown(Fitter.State without, List<Fitter.State> fits) {

        private Shown at(Place place) {
            return new Shown(without, fits.stream().filter(fit -> Place.ofLast(fit).equals(place)).toList());
        }
    }

    /**
     * At some places.
     *
     * @param places where it may act, likeliest first, with the base's numbers as they fit beside both
     */
    Shown among(Place ignored, Map<Place, double[]> places) {
        Shown shown = once(ignored, places.keySet(), () -> sought(ignored, places));
        places.keySet().forEach(place -> once(ignored, Set.of(place), () -> shown.at(place)));
        return shown;
    }

    /**
     * At one place.
     *
     * @param x the base's numbers as they fit beside both: coordinates [1], one a knob. Not modified.
     */
    Shown at(Place ignored, Place place, double[] x) {
        return once(ignored, Set.of(place), () -> sought(ignored, Map.of(place, x)));
    }

    private Shown once(Place ignored, Set<Place> places, Supplier<Shown> seek) {
        return evidence.known().once(new Asked(base.x(), ignored, Set.copyOf(places)), Shown.class, seek);
    }

    private Shown sought(Place ignored, Map<Place, double[]> places) {
        Candidate baseline = base.candidate();
        Search blind = new Search(evidence.ignoring(ignored), progress);
        Fitter.State without = blind.base(baseline, places.values().iterator().next());
        if (without.reduced() < Priors.SILENT) {
            return new Shown(without, List.of());
        }
        Map<Place, double[]> given = new LinkedHashMap<>();
        places.forEach((place, numbers) -> given.put(place, ignored.asGiven(baseline, numbers)));
        return new Shown(without, blind.leaders(without, Effort.LEADERS, Whereabouts.among(evidence, baseline, given)));
    }
}

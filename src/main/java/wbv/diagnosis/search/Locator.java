package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;

/**
 * Finds the place of a mismatch without naming a mechanism: for each place whatever enters there is ignored, and the model refitted.
 * What is left falls to noise only where it really enters.
 */
public final class Locator {

    /** Beside two places, be one a force on a body, fewer outputs have nothing left that could show whether they will do. */
    static final int FEWEST_OUTPUTS = 3;
    private static final int FIRST_STEPS = 3;
    private static final int STEPS = 8;
    /** How many times the excess of the best a place may leave after the first steps that is fitted further. */
    private static final double HOPELESS = 10;
    /** The same for a last round. */
    private static final double NEAR = 3;
    private static final Comparator<Known.Ignoring> BEST = Comparator.comparingDouble(Known.Ignoring::reduced);
    /** Of how many places a partner is sought. */
    private static final int FIRSTS = 4;

    private final Evidence evidence;
    private final Candidate baseline;
    /** What the model does where several fits begin, by the very numbers, as long as they are made: each takes some 10 MB. */
    private final Map<double[], Optional<Fitter.Ran>> begun = Collections.synchronizedMap(new IdentityHashMap<>());

    /**
     * Among the places of this evidence.
     *
     * @param baseline the model that is refitted
     */
    public Locator(Evidence evidence, Candidate baseline) {
        this.evidence = evidence;
        this.baseline = baseline;
    }

    /**
     * All places one by one, best first; none with a single output, where every place explains everything.
     *
     * @param x where fits start: coordinates [1], one a knob. Not modified.
     */
    public List<Known.Ignoring> singles(double[] x) {
        return evidence.known().places(baseline, x, () -> oneByOne(x));
    }

    private List<Known.Ignoring> oneByOne(double[] x) {
        List<double[]> starts = List.of(x, baseline.start());
        if (evidence.outputs().size() < 2) {
            return List.of();
        }
        List<Place> all = Place.andDevices(evidence);
        List<Known.Ignoring> plain = found(
                all.stream().filter(place -> place.equals(plain(place))).map(place -> new Asked(List.of(place), starts)).toList(), starts);
        List<Known.Ignoring> renamed = all.stream().filter(place -> !place.equals(plain(place))).flatMap(place -> plain.stream()
                .filter(found -> found.places().get(0).equals(plain(place)))
                .map(found -> new Known.Ignoring(List.of(place), found.x(), found.reduced()))).toList();
        return sorted(Stream.concat(plain.stream(), renamed.stream()).toList());
    }

    /**
     * Pairs of places, best first; none where there are too few outputs to show that a third would not do.
     *
     * @param all places one by one
     */
    List<Known.Ignoring> pairs(List<Known.Ignoring> all) {
        if (evidence.outputs().size() < FEWEST_OUTPUTS) {
            return List.of();
        }
        List<Known.Ignoring> singles = all.stream().filter(found -> found.places().get(0).equals(plain(found.places().get(0)))).toList();
        List<Asked> asked = new ArrayList<>();
        for (int i = 0; i < Math.min(FIRSTS, singles.size()); i++) {
            for (Known.Ignoring second : singles.subList(i + 1, singles.size())) {
                asked.add(new Asked(List.of(singles.get(i).places().get(0), second.places().get(0)),
                        List.of(singles.get(i).x(), second.x())));
            }
        }
        return found(asked, singles.stream().limit(FIRSTS).map(Known.Ignoring::x).toList());
    }

    /**
     * What is left where one place is ignored.
     *
     * @param x where fits start
     */
    double left(Place place, double[] x) {
        return found(List.of(new Asked(List.of(place), List.of(x, baseline.start()))), List.of()).get(0).reduced();
    }

    /**
     * The same as it was found among all places.
     *
     * @param place by its plain name
     */
    static double left(List<Known.Ignoring> singles, Place place) {
        return singles.stream().filter(found -> found.places().get(0).equals(place)).findFirst().orElseThrow().reduced();
    }

    private Place plain(Place place) {
        return place.plain(baseline.template());
    }

    /** Places to be ignored, and where fits start then. */
    private record Asked(List<Place> places, List<double[]> starts) {}

    /**
     * Fits all a little, and the whole way those that are not hopeless then.
     *
     * @param shared where many of them start
     */
    private List<Known.Ignoring> found(List<Asked> all, List<double[]> shared) {
        Parallel.each(shared.size(), i -> begun.put(shared.get(i), new Fitter(evidence).ran(baseline, shared.get(i))));
        List<Known.Ignoring> heat = sorted(
                Parallel.map(all, asked -> asked.starts().stream().map(x -> fitted(asked.places(), x, FIRST_STEPS))
                        .min(BEST).orElseThrow()));
        begun.clear();
        return further(further(heat, HOPELESS), NEAR);
    }

    /**
     * More steps for those that leave no more than some times the excess of the best.
     *
     * @param found best first
     */
    private List<Known.Ignoring> further(List<Known.Ignoring> found, double times) {
        double reach = reach(found, times);
        return sorted(Parallel.map(found, each -> each.reduced() > reach ? each
                : Stream.of(each, fitted(each.places(), each.x(), STEPS)).min(BEST).orElseThrow()));
    }

    /**
     * What a place may leave, as a mean square of the whitened residual, to be some times as far from the noise as the best; anything where
     * none was looked at.
     *
     * @param found best first
     * @param times factor on the excess of the best
     */
    public static double reach(List<Known.Ignoring> found, double times) {
        return found.isEmpty() ? Double.POSITIVE_INFINITY : 1 + times * Refinement.excess(found.get(0).reduced());
    }

    private static List<Known.Ignoring> sorted(List<Known.Ignoring> found) {
        List<Known.Ignoring> out = new ArrayList<>(found);
        out.sort(BEST);
        return out;
    }

    private Known.Ignoring fitted(List<Place> places, double[] start, int steps) {
        Evidence seen = evidence;
        for (Place place : places) {
            seen = seen.ignoring(place);
        }
        Fitter fitter = new Fitter(evidence).of(seen, begun.getOrDefault(start, Optional.empty()));
        Fitter.State state = fitter.glimpse(baseline, start, fitter.frame(baseline, start, seen.fit()), steps, 2e-3);
        return new Known.Ignoring(places, state.x(), state.reduced());
    }
}

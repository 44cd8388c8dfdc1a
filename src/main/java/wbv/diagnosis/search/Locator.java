package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import wbv.diagnosis.fit.BlindFit;
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
    static final int FEWEST_OUTPUTS = 2 + 1;
    /** Of one that starts anew, before the frame is made again where it stands. */
    private static final int OWN_STEPS = 3;
    /** Of those few that leave little then: what they leave is held against noise. */
    private static final int LAST_STEPS = 20;
    /** The same for a last round. */
    private static final double NEAR = 3;
    private static final Comparator<Known.Ignoring> BEST = Comparator.comparingDouble(Known.Ignoring::reduced);
    private static final Comparator<Begun> WARMEST = Comparator.comparing(Begun::found, BEST);

    private final Evidence evidence;
    private final Candidate baseline;

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
     * @param x where fits start: coordinates [1], one a knob, told by being the same array: kept and not modified.
     */
    public List<Known.Ignoring> singles(double[] x) {
        return evidence.known().once(new At(baseline, x), Singles.class, () -> new Singles(oneByOne(x))).found();
    }

    /** A model at coordinates [1], which are themselves and equal to no copy. */
    private record At(Candidate on, double[] x) {}

    private record Singles(List<Known.Ignoring> found) {}

    /**
     * Some places one by one, best first; none with a single output.
     *
     * @param places by their plain names
     * @param x where fits start: coordinates [1], one a knob. Not modified.
     */
    public List<Known.Ignoring> among(List<Place> places, double[] x) {
        return evidence.outputs().size() < 2 ? List.of() : found(places.stream().map(List::of).toList(), List.of(x, baseline.start()));
    }

    private List<Known.Ignoring> oneByOne(double[] x) {
        List<double[]> starts = List.of(x, baseline.start());
        if (evidence.outputs().size() < 2) {
            return List.of();
        }
        List<Place> all = Place.andDevices(evidence);
        List<Known.Ignoring> plain = found(all.stream().filter(place -> place.equals(plain(place))).map(List::of).toList(), starts);
        List<Known.Ignoring> renamed = all.stream().filter(place -> !place.equals(plain(place))).flatMap(place -> plain.stream()
                .filter(found -> found.places().get(0).equals(plain(place)))
                .map(found -> new Known.Ignoring(List.of(place), found.x(), found.reduced()))).toList();
        return sorted(Stream.concat(plain.stream(), renamed.stream()).toList());
    }

    /**
     * Pairs of places, best first; where outputs are too few to show what two leave, as the first of the two fits by itself.
     *
     * @param all places one by one
     */
    List<Known.Ignoring> pairs(List<Known.Ignoring> all) {
        List<Known.Ignoring> singles = all.stream().filter(found -> found.places().get(0).equals(plain(found.places().get(0)))).toList();
        List<List<Place>> asked = new ArrayList<>();
        for (int i = 0; i < Math.min(Effort.PLACES, singles.size()); i++) {
            for (Known.Ignoring second : singles.subList(i + 1, singles.size())) {
                asked.add(List.of(singles.get(i).places().get(0), second.places().get(0)));
            }
        }
        return isBlindToTwo() ? asked.stream().map(pair -> left(singles, pair)).toList()
                : found(asked, singles.stream().limit(Effort.PLACES).map(Known.Ignoring::x).toList());
    }

    /** Whether outputs are so few that two places explain anything. */
    boolean isBlindToTwo() {
        return evidence.outputs().size() < FEWEST_OUTPUTS;
    }

    private static Known.Ignoring left(List<Known.Ignoring> singles, List<Place> pair) {
        Known.Ignoring first = singles.stream().filter(found -> found.places().get(0).equals(pair.get(0))).findFirst().orElseThrow();
        return new Known.Ignoring(pair, first.x(), first.reduced());
    }

    /**
     * What is left where one place is ignored.
     *
     * @param x where fits start
     */
    double left(Place place, double[] x) {
        return found(List.of(List.of(place)), List.of(x, baseline.start())).get(0).reduced();
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

    /**
     * Fits all a little, and the whole way those that are not hopeless then.
     *
     * @param all places that are ignored together
     * @param starts of each of them
     */
    private List<Known.Ignoring> found(List<List<Place>> all, List<double[]> starts) {
        Fitter fitter = new Fitter(evidence);
        List<BlindFit> blind = Parallel.map(starts, x -> fitter.lookWithSlopes(baseline, x, fitter.frame(baseline, x, evidence.fit())))
                .stream().filter(state -> !state.failed()).map(state -> new BlindFit(evidence, fitter.about(state), state)).toList();
        if (blind.isEmpty()) {
            return all.stream().map(places -> new Known.Ignoring(places, baseline.start(), Double.POSITIVE_INFINITY)).toList();
        }
        List<List<Begun>> heat = Parallel.map(all, places -> blind.stream()
                .map(fit -> new Begun(fit.start(), fit.ignoring(places, Effort.FINAL_STEPS))).sorted(WARMEST).limit(Effort.SECONDS)
                .toList());
        List<Known.Ignoring> leading = sorted(heat.stream().map(begun -> begun.get(0).found()).toList());
        // Where all leave much, all are near the best, and the best of them is hardly the place either.
        double last = leading.stream().limit(Effort.CONTENDERS).mapToDouble(Known.Ignoring::reduced).max().orElse(Double.POSITIVE_INFINITY);
        double reach = Math.min(reach(leading, Effort.BEHIND), last);
        return again(sorted(Parallel.map(heat, begun -> begun.get(0).found().reduced() > reach ? begun.get(0).found() : near(begun))));
    }

    /** Where the best of the warmest and of what begins anew leads: steps with another fit's derivatives may go astray. */
    private Known.Ignoring near(List<Begun> begun) {
        Known.Ignoring warmest = begun.get(0).found();
        return further(Stream.concat(Stream.of(warmest), begun.stream()
                .map(each -> further(new Known.Ignoring(warmest.places(), each.start(), Double.POSITIVE_INFINITY), OWN_STEPS)))
                .min(BEST).orElseThrow(), Effort.HEAT_STEPS);
    }

    /**
     * A fit a little on.
     *
     * @param start where it began
     */
    private record Begun(double[] start, Known.Ignoring found) {}

    /**
     * More steps for those that leave little more than the best.
     *
     * @param found best first
     */
    private List<Known.Ignoring> again(List<Known.Ignoring> found) {
        double reach = reach(found, NEAR);
        return sorted(Parallel.map(found, each -> each.reduced() > reach ? each : further(each, LAST_STEPS)));
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

    /**
     * What the places at which a mismatch enters leave at most, as a mean square of the whitened residual.
     *
     * @param base with all of the mismatch
     * @param times of what places scatter by [1]
     */
    public static double scatter(Fitter.State base, double times) {
        return 1 + times * Priors.SCATTER * (base.reduced() - 1);
    }

    private static List<Known.Ignoring> sorted(List<Known.Ignoring> found) {
        List<Known.Ignoring> out = new ArrayList<>(found);
        out.sort(BEST);
        return out;
    }

    /** Fitted on, in a whitening that ignores the places. */
    private Known.Ignoring further(Known.Ignoring found, int steps) {
        Evidence seen = evidence;
        for (Place place : found.places()) {
            seen = seen.ignoring(place);
        }
        Fitter fitter = new Fitter(seen);
        Fitter.State state = fitter.glimpse(baseline, found.x(), fitter.frame(baseline, found.x(), seen.fit()), steps, Effort.ROUGH);
        return state.reduced() < found.reduced() ? new Known.Ignoring(found.places(), state.x(), state.reduced()) : found;
    }
}

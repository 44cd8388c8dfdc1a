package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Place;

/**
 * Finds the place of a mismatch without naming a mechanism: for each place whatever enters there is ignored, and the model refitted.
 * What is left falls to noise only where it really enters.
 */
public final class Locator {

    /** Beside two places, be one a force on a body, fewer outputs have nothing left that could show whether they will do. */
    static final int FEWEST_OUTPUTS = 2 + 1;

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
        return evidence.known().once(new At(baseline, x), () -> oneByOne(x));
    }

    /** A model at coordinates [1], which are themselves and equal to no copy. */
    private record At(Candidate on, double[] x) implements Known.Question<List<Known.Ignoring>> {}

    /**
     * Some places one by one, best first; none with a single output.
     *
     * @param places by their plain names
     * @param x where fits start: coordinates [1], one a knob, told by being the same array: kept and not modified.
     */
    public List<Known.Ignoring> among(List<Place> places, double[] x) {
        return evidence.outputs().size() < 2 ? List.of()
                : PlaceHeats.sorted(places.stream().flatMap(place -> at(place, x).stream()).toList());
    }

    private List<Known.Ignoring> oneByOne(double[] x) {
        List<double[]> starts = List.of(x, baseline.start());
        if (evidence.outputs().size() < 2) {
            return List.of();
        }
        List<Known.Ignoring> plain = heats().found(twins().firsts().stream().map(List::of).toList(), starts).stream().flatMap(this::alike)
                .toList();
        List<Known.Ignoring> renamed = Place.andDevices(evidence).stream().filter(place -> !place.equals(plain(place)))
                .flatMap(place -> plain.stream().filter(found -> found.places().get(0).equals(plain(place)))
                        .map(found -> new Known.Ignoring(List.of(place), found.x(), found.reduced())))
                .toList();
        return PlaceHeats.sorted(Stream.concat(plain.stream(), renamed.stream()).toList());
    }

    private PlaceHeats heats() {
        return new PlaceHeats(evidence, baseline);
    }

    private Twins twins() {
        return Twins.of(evidence, baseline);
    }

    /** The same of all places that no output tells from those. */
    private Stream<Known.Ignoring> alike(Known.Ignoring found) {
        return twins().alike(found.places()).map(places -> new Known.Ignoring(places, found.x(), found.reduced()));
    }

    /**
     * Pairs of places, best first; where outputs are too few to show what two leave, as the first of the two fits by itself.
     *
     * @param all places one by one
     */
    List<Known.Ignoring> pairs(List<Known.Ignoring> all) {
        List<Place> firsts = twins().firsts();
        List<Known.Ignoring> singles = all.stream().filter(found -> firsts.contains(found.places().get(0))).toList();
        List<List<Place>> asked = new ArrayList<>();
        for (int i = 0; i < Math.min(Effort.PLACES, singles.size()); i++) {
            for (Known.Ignoring second : singles.subList(i + 1, singles.size())) {
                asked.add(List.of(singles.get(i).places().get(0), second.places().get(0)));
            }
        }
        List<Known.Ignoring> found = isBlindToTwo() ? asked.stream().map(pair -> left(singles, pair)).toList()
                : heats().found(asked, singles.stream().limit(Effort.PLACES).map(Known.Ignoring::x).toList());
        return found.stream().flatMap(this::alike).toList();
    }

    /** Whether outputs are so few that two places explain anything. */
    boolean isBlindToTwo() {
        return evidence.outputs().size() < FEWEST_OUTPUTS;
    }

    private static Known.Ignoring left(List<Known.Ignoring> singles, List<Place> pair) {
        Known.Ignoring first = of(singles, pair.get(0)).orElseThrow();
        return new Known.Ignoring(pair, first.x(), first.reduced());
    }

    /**
     * What is left where one place is ignored.
     *
     * @param x where fits start, told as in {@link #singles}
     */
    double left(Place place, double[] x) {
        return at(place, x).orElseThrow().reduced();
    }

    private Optional<Known.Ignoring> at(Place place, double[] x) {
        Optional<Evidence> part = evidence.brief();
        return of(new Locator(part.orElse(evidence), baseline).singles(x), place)
                .map(found -> part.isEmpty() ? found : PlaceHeats.seen(found.places(), beside(found)));
    }

    /**
     * The fit beside a place.
     *
     * @param found where it starts: as a part of the data showed it, told as in {@link #singles}
     */
    VariableProjection.Turn beside(Known.Ignoring found) {
        return evidence.known().once(new Beside(baseline, found),
                () -> new VariableProjection(evidence, found.places()).base(baseline, found.x()));
    }

    private record Beside(Candidate on, Known.Ignoring found) implements Known.Question<VariableProjection.Turn> {}

    /**
     * The same as it was found among all places.
     *
     * @param place by its plain name
     */
    static double left(List<Known.Ignoring> singles, Place place) {
        return of(singles, place).orElseThrow().reduced();
    }

    /** What was found of a place by its plain name, if it was looked at. */
    static Optional<Known.Ignoring> of(List<Known.Ignoring> singles, Place place) {
        return singles.stream().filter(found -> found.places().get(0).equals(place)).findFirst();
    }

    private Place plain(Place place) {
        return place.plain(baseline.template());
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
}

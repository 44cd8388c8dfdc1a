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
    /** How many times as far from the noise as the best a place may be that is fitted to the end: what it leaves is held against noise. */
    private static final double NEAR = 3;
    private static final Comparator<Known.Ignoring> BEST = Comparator.comparingDouble(Known.Ignoring::reduced);
    private static final Comparator<Begun> WARMEST = Comparator.comparing(Begun::found, BEST);
    private static final Comparator<Looked> LEAST = Comparator.comparing(Looked::found, BEST);
    private static final Comparator<VariableProjection.Turn> COST = Comparator.comparingDouble(turn -> turn.fit().cost());

    private final Evidence evidence;
    private final Candidate baseline;
    /** The same, held where a place that is ignored leaves nothing to tell its numbers. */
    private final Candidate believed;

    /**
     * Among the places of this evidence.
     *
     * @param baseline the model that is refitted
     */
    public Locator(Evidence evidence, Candidate baseline) {
        this.evidence = evidence;
        this.baseline = baseline;
        this.believed = baseline.surer(Priors.NUMBER_DEVIATION);
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
        List<Known.Ignoring> plain = found(twins().firsts().stream().map(List::of).toList(), starts).stream().flatMap(this::alike).toList();
        List<Known.Ignoring> renamed = Place.andDevices(evidence).stream().filter(place -> !place.equals(plain(place)))
                .flatMap(place -> plain.stream().filter(found -> found.places().get(0).equals(plain(place)))
                        .map(found -> new Known.Ignoring(List.of(place), found.x(), found.reduced())))
                .toList();
        return sorted(Stream.concat(plain.stream(), renamed.stream()).toList());
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
                : found(asked, singles.stream().limit(Effort.PLACES).map(Known.Ignoring::x).toList());
        return found.stream().flatMap(this::alike).toList();
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
     * @param x where fits start, told as in {@link #singles}
     */
    double left(Place place, double[] x) {
        return evidence.known().once(new One(new At(baseline, x), place), Double.class,
                () -> found(List.of(List.of(place)), List.of(x, baseline.start())).get(0).reduced());
    }

    private record One(At at, Place place) {}

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
        List<BlindFit> blind = Parallel.map(starts, x -> fitter.lookWithSlopes(believed, x, fitter.frame(believed, x, evidence.fit())))
                .stream().filter(state -> !state.failed()).map(state -> new BlindFit(evidence, fitter.about(state), state)).toList();
        if (blind.isEmpty()) {
            return all.stream().map(places -> new Known.Ignoring(places, baseline.start(), Double.POSITIVE_INFINITY)).toList();
        }
        List<List<Begun>> heat = Parallel.map(all, places -> blind.stream()
                .map(fit -> new Begun(fit.start(), fit.ignoring(places, Effort.FINAL_STEPS))).sorted(WARMEST).limit(Effort.SECONDS)
                .toList());
        List<Looked> looked = new ArrayList<>(
                heat.stream().map(begun -> new Looked(begun, false, begun.get(0).found())).sorted(LEAST).toList());
        for (int round = 0; round < Effort.SECONDS; round++) {
            // What was begun is seen in the frame where it began: what is near so is fitted in its own.
            double reach = reach(looked.stream().map(Looked::found).toList(), Effort.BEHIND);
            List<Looked> first = looked.subList(0, Math.min(Effort.CONTENDERS, looked.size()));
            List<Looked> near = Parallel.map(first, each -> each.isNear() || each.found().reduced() > reach ? each : near(each.begun()));
            for (int i = 0; i < near.size(); i++) {
                looked.set(i, near.get(i));
            }
            looked.sort(LEAST);
        }
        return again(looked.stream().map(Looked::found).toList());
    }

    /**
     * Where the numbers as they were given lead, of which those that nothing tells stay; if less was promised, the best of where the
     * warmest leads and of what begins anew: steps with another fit's derivatives may go astray.
     */
    private Looked near(List<Begun> begun) {
        Known.Ignoring warmest = begun.get(0).found();
        VariableProjection beside = new VariableProjection(evidence, warmest.places());
        VariableProjection.Turn turn = beside.at(believed, believed.start()).on(Effort.ROUNDS);
        if (turn.fit().reduced() > (1 + Effort.ROUGH) * warmest.reduced()) {
            turn = Stream.concat(Stream.of(turn), Stream.concat(Stream.of(warmest.x()), begun.stream().map(Begun::start))
                    .map(x -> beside.at(believed, x).on(1))).min(COST).orElseThrow().on(Effort.ROUNDS);
        }
        return new Looked(begun, true, found(warmest.places(), turn));
    }

    private static Known.Ignoring found(List<Place> places, VariableProjection.Turn turn) {
        return new Known.Ignoring(places, turn.fit().x(), turn.fit().reduced());
    }

    /**
     * A fit a little on.
     *
     * @param start where it began
     */
    private record Begun(double[] start, Known.Ignoring found) {}

    /**
     * What some places leave.
     *
     * @param isNear whether that is seen in its own frame
     */
    private record Looked(List<Begun> begun, boolean isNear, Known.Ignoring found) {}

    /**
     * More steps for those that leave little more than the best.
     *
     * @param found best first
     */
    private List<Known.Ignoring> again(List<Known.Ignoring> found) {
        double reach = reach(found, NEAR);
        return sorted(Parallel.map(found, each -> each.reduced() > reach ? each
                : found(each.places(), new VariableProjection(evidence, each.places()).at(believed, each.x()).on(Effort.STEPS))));
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
}

package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Finds the place of a mismatch without naming a mechanism: for each place whatever enters there is ignored, and the model refitted.
 * What is left falls to noise only where it really enters.
 */
final class Locator {

    private static final int ROUNDS = 2;
    private static final int STEPS = 8;
    /** Of how many places a partner is sought. */
    private static final int FIRSTS = 4;

    private final Evidence evidence;
    private final Candidate baseline;

    Locator(Evidence evidence, Candidate baseline) {
        this.evidence = evidence;
        this.baseline = baseline;
    }

    /** @param places ignored @param x where the model fits then @param reduced what is left, of what still shows */
    record Found(List<Place> places, double[] x, double reduced) { }

    /** All places, best first. With a single output every place explains everything: then the list is empty. @param x where fits start */
    List<Diagnosis.Latent> places(double[] x) {
        return singles(x).stream().map(found -> new Diagnosis.Latent(found.places().get(0).kind().word(),
                found.places().get(0).name(evidence), found.reduced())).toList();
    }

    /** All places one by one, best first; none with a single output. */
    List<Found> singles(double[] x) {
        return evidence.outputs().size() < 2 ? List.of() : found(Place.all(evidence).stream().map(List::of).toList(), List.of(x, baseline.start()));
    }

    /** Pairs of places, best first; none where there are too few outputs to show that a third would not do. @param x where fits start */
    List<Found> pairs(double[] x) {
        if (evidence.outputs().size() < 3) {
            return List.of();
        }
        List<Found> singles = singles(x).stream().filter(found -> found.places().get(0).equals(plain(found.places().get(0)))).toList();
        List<Found> out = new ArrayList<>();
        for (int i = 0; i < Math.min(FIRSTS, singles.size()); i++) {
            Place first = singles.get(i).places().get(0);
            List<List<Place>> pairs = singles.subList(i + 1, singles.size()).stream().map(second -> List.of(first, second.places().get(0))).toList();
            out.addAll(found(pairs, List.of(singles.get(i).x())));
        }
        out.sort(Comparator.comparingDouble(Found::reduced));
        return out;
    }

    /** What is left where one place is ignored. @param x where fits start */
    double left(Place place, double[] x) {
        return look(List.of(place), List.of(x, baseline.start())).reduced();
    }

    private Place plain(Place place) {
        return place.plain(baseline.template());
    }

    private List<Found> found(List<List<Place>> all, List<double[]> starts) {
        List<Found> out = new ArrayList<>(IntStream.range(0, all.size()).parallel().mapToObj(i -> look(all.get(i), starts)).toList());
        out.sort(Comparator.comparingDouble(Found::reduced));
        return out;
    }

    private Found look(List<Place> places, List<double[]> starts) {
        Evidence seen = evidence;
        for (Place place : places) {
            seen = seen.ignoring(place);
        }
        Fitter fitter = new Fitter(seen);
        Found best = new Found(places, starts.get(0), Double.POSITIVE_INFINITY);
        for (double[] start : starts) {
            double[] x = start;
            for (int round = 0; round < ROUNDS; round++) {
                Fitter.State state = fitter.fit(baseline, x, fitter.frame(baseline, x, seen.fit()), STEPS, 2e-3);
                x = state.x();
                best = state.reduced() < best.reduced() ? new Found(places, x, state.reduced()) : best;
            }
        }
        return best;
    }
}

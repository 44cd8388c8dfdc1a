package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Simulator;

/**
 * Finds the place of a mismatch without naming a mechanism: for each place an arbitrary unknown signal (a force in a link or on a body,
 * an error of a sensor) is projected out of the residual, and the model refitted. What is left falls to noise only where the
 * signal really enters.
 */
final class Locator {

    private static final int ROUNDS = 2;

    private final Evidence evidence;
    private final Fitter fitter;

    Locator(Evidence evidence) {
        this.evidence = evidence;
        this.fitter = new Fitter(evidence);
    }

    /** A place and the unknown signal's way to the outputs. */
    private record Place(String kind, String name, int index) { }

    /** All places, best first. With a single output every place explains everything: then the list is empty. */
    List<Diagnosis.Latent> places(Candidate baseline, double[] x) {
        if (evidence.outputs().size() < 2) {
            return List.of();
        }
        List<Place> places = new ArrayList<>();
        evidence.model().bodies().forEach(body -> places.add(new Place("body", body.name(), places.size())));
        int bodies = places.size();
        evidence.model().links().forEach(link -> places.add(new Place("link", link.name(), places.size() - bodies)));
        for (int o = 0; o < evidence.outputs().size(); o++) {
            places.add(new Place("sensor", evidence.outputs().get(o).toString(), o));
        }
        List<Diagnosis.Latent> found = new ArrayList<>(places.parallelStream().map(place -> look(place, baseline, x)).toList());
        found.sort(Comparator.comparingDouble(Diagnosis.Latent::reduced));
        return found;
    }

    private Diagnosis.Latent look(Place place, Candidate baseline, double[] fitted) {
        double best = Double.POSITIVE_INFINITY;
        for (double[] start : List.of(fitted, baseline.start())) {
            double[] x = start;
            for (int round = 0; round < ROUNDS; round++) {
                Fitter.Frame frame = fitter.blind(fitter.frame(baseline, x, evidence.fit()), direction(place, baseline.at(x)));
                Fitter.State state = fitter.fit(baseline, x, frame, 8, 2e-3);
                x = state.x();
                best = Math.min(best, state.reduced());
            }
        }
        return new Diagnosis.Latent(place.kind(), place.name(), best);
    }

    private double[][] direction(Place place, Assembly assembly) {
        Simulator.Linearised linear = new Simulator(evidence.excitation()).linearised(assembly);
        if (place.kind().equals("body")) {
            return linear.ofBodyForce(place.index());
        }
        if (place.kind().equals("link")) {
            return linear.ofLinkForce(place.index());
        }
        int size = 2 * evidence.excitation().omega().length;
        return IntStream.range(0, evidence.outputs().size()).mapToObj(o -> {
            double[] unit = new double[size];
            for (int k = 0; o == place.index() && k < size; k += 2) {
                unit[k] = 1;
            }
            return unit;
        }).toArray(double[][]::new);
    }
}

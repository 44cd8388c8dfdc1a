package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Place;

/**
 * Places that no output tells apart, whatever the model's numbers: what enters at one reaches all outputs along the same direction at every
 * frequency as what enters at the other. So do a force on a body without a sensor that hangs on one other, one in their link, and one on
 * that other. What is ignored at one is ignored at all of them.
 */
final class Twins {

    /** Part of a direction's square beside another that is rounding. */
    private static final double SAME = 1e-12;

    private final List<List<Place>> sets = new ArrayList<>();

    /** Among the places of some evidence, by their plain names, kept with it. */
    static Twins of(Evidence evidence, Candidate model) {
        return evidence.known().once(new In(model), () -> new Twins(evidence, model, Place.andDevices(evidence).stream()
                .filter(place -> place.equals(place.plain(model.template()))).toList()));
    }

    private record In(Candidate model) implements Known.Question<Twins> {}

    /** Among some places. */
    Twins(Evidence evidence, Candidate model, List<Place> places) {
        Simulator simulator = new Simulator(evidence.excitation());
        Simulator.Linearised linear = simulator.linearised(simulator.equivalent(model.at(model.start())));
        List<double[][]> directions = new ArrayList<>();
        for (Place place : places) {
            double[][] direction = place.direction(() -> linear, evidence.outputs().size(), evidence.excitation().omega().length);
            int same = 0;
            while (same < sets.size() && !(isOne(sets.get(same).get(0), place) && isAlong(directions.get(same), direction))) {
                same++;
            }
            if (same == sets.size()) {
                sets.add(new ArrayList<>());
                directions.add(direction);
            }
            sets.get(same).add(place);
        }
    }

    /** The first of each set. */
    List<Place> firsts() {
        return sets.stream().map(set -> set.get(0)).toList();
    }

    /** Those that are told apart from none of each other, the place among them; in the order they were given. */
    List<Place> of(Place place) {
        return sets.stream().filter(set -> set.contains(place)).findFirst().orElse(List.of(place));
    }

    /** The first of them, which stands for all. */
    Place first(Place place) {
        return of(place).get(0);
    }

    /** Places as they are, or with any twin in the place of each. */
    Stream<List<Place>> alike(List<Place> places) {
        Stream<List<Place>> out = Stream.of(List.of());
        for (Place place : places) {
            out = out.flatMap(some -> of(place).stream().map(twin -> Stream.concat(some.stream(), Stream.of(twin)).toList()));
        }
        return out;
    }

    /** Whether what enters at two places has one direction each: at a device each channel has its own. */
    private static boolean isOne(Place one, Place other) {
        return one.kind() != Place.Kind.DEVICE && other.kind() != Place.Kind.DEVICE;
    }

    /** Whether two directions are one at every frequency but for rounding: both reach the outputs, and |a|²|b|² is |a·b|². */
    private static boolean isAlong(double[][] one, double[][] other) {
        double whole = 0;
        double across = 0;
        for (int k = 0; k < one[0].length; k += 2) {
            double square = 0;
            double otherSquare = 0;
            double real = 0;
            double imaginary = 0;
            for (int output = 0; output < one.length; output++) {
                double[] a = one[output];
                double[] b = other[output];
                square += a[k] * a[k] + a[k + 1] * a[k + 1];
                otherSquare += b[k] * b[k] + b[k + 1] * b[k + 1];
                real += a[k] * b[k] + a[k + 1] * b[k + 1];
                imaginary += a[k] * b[k + 1] - a[k + 1] * b[k];
            }
            whole += square * otherSquare;
            across += square * otherSquare - real * real - imaginary * imaginary;
        }
        return whole > 0 && across <= SAME * whole;
    }
}

package wbv.diagnosis;

import java.util.List;
import wbv.body.Assembly;

/**
 * A model with numbers that may move.
 *
 * @param template the assembly whose values the knobs replace
 * @param knobs    in the order of the coordinates x
 */
record Candidate(Assembly template, List<Knob> knobs) {

    Candidate {
        knobs = List.copyOf(knobs);
    }

    /** The assembly at coordinates x. Not modified. */
    Assembly at(double[] x) {
        double[] values = template.values();
        for (int i = 0; i < x.length; i++) {
            values[knobs.get(i).index()] = knobs.get(i).value(x[i]);
        }
        return template.with(values);
    }

    /** Coordinates at which every knob stands at its reference, or at the nearest bound. */
    double[] start() {
        return knobs.stream().mapToDouble(knob -> Math.max(knob.low(), Math.min(knob.high(), 0))).toArray();
    }
}

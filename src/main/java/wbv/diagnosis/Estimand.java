package wbv.diagnosis;

import java.util.List;
import java.util.stream.IntStream;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Told;

/**
 * A number of a mechanism as a reader expects it, as a function of a fit's coordinates x: {@code u = (b·x)} for most, u the root
 * of a sum of squares for an amplitude; the number itself is {@code reference e^u} or {@code reference + unit u}.
 *
 * @param key       with its unit
 * @param at        positions of the coordinates that it depends on
 * @param weights   b, one for each of them; not used by an amplitude
 * @param amplitude whether u is the root of the sum of squares
 * @param reference of the number
 * @param unit of the number; 0 for one that is found by factors
 */
record Estimand(String key, int[] at, double[] weights, boolean amplitude, double reference, double unit) {

    /** The numbers of a hypothesis in a candidate that contains it, as its mechanism tells them. */
    static List<Estimand> of(Hypothesis hypothesis, Candidate candidate) {
        int[] positions = candidate.positions(hypothesis);
        return hypothesis.kind().told(hypothesis).stream().map(told -> of(told, positions, candidate)).toList();
    }

    private static Estimand of(Told told, int[] positions, Candidate candidate) {
        int[] at = IntStream.of(told.of()).map(i -> positions[i]).toArray();
        Knob first = candidate.knobs().get(at[0]);
        if (told.kind() == Told.Kind.PRODUCT) {
            double reference = told.value()
                    .applyAsDouble(IntStream.of(at).mapToDouble(i -> candidate.knobs().get(i).reference()).toArray());
            return new Estimand(told.key(), at, told.weights(), false, reference, 0);
        }
        if (at.length == 1) {
            double factor = told.weights()[0];
            return new Estimand(told.key(), at, new double[] {1}, false, factor * first.reference(), factor * first.unit());
        }
        return new Estimand(told.key(), at, told.weights(), told.kind() == Told.Kind.AMPLITUDE, 0, first.unit());
    }

    /** Whether it is a coordinate itself. */
    boolean isPlain() {
        return at.length == 1;
    }

    double u(double[] x) {
        double sum = 0;
        for (int i = 0; i < at.length; i++) {
            sum += amplitude ? x[at[i]] * x[at[i]] : weights[i] * x[at[i]];
        }
        return amplitude ? Math.sqrt(sum) : sum;
    }

    /** d u / d x, over all coordinates. */
    double[] slope(double[] x) {
        double[] out = new double[x.length];
        double size = amplitude ? Math.max(u(x), 1e-300) : 1;
        for (int i = 0; i < at.length; i++) {
            out[at[i]] = amplitude ? x[at[i]] / size : weights[i];
        }
        return out;
    }

    double value(double u) {
        return unit == 0 ? reference * Math.exp(u) : reference + unit * u;
    }

    /** d value / d u. */
    double rate(double u) {
        return unit == 0 ? value(u) : unit;
    }
}

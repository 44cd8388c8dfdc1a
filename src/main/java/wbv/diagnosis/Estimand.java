package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;

/**
 * A number of a mechanism as a reader expects it, as a function of a fit's coordinates x: {@code u = (b·x)} for most, u the root
 * of a sum of squares for an amplitude; the number itself is {@code reference e^u} or {@code reference + unit u}.
 *
 * @param key       with its unit
 * @param at        positions of the coordinates that it depends on
 * @param weights   b, one for each of them; not used by an amplitude
 * @param amplitude whether u is the root of the sum of squares
 * @param reference of the number @param unit of the number; 0 for one that is found by factors
 */
record Estimand(String key, int[] at, double[] weights, boolean amplitude, double reference, double unit) {

    /**
     * The numbers of a hypothesis in a candidate that contains it: a hidden mass by frequency and damping ratio, a tone by its
     * amplitude.
     */
    static List<Estimand> of(Hypothesis hypothesis, Candidate candidate) {
        int[] at = hypothesis.positions(candidate);
        List<Estimand> out = new ArrayList<>();
        List<String> keys = hypothesis.numbers().stream().map(Hypothesis.Number::key).toList();
        if (hypothesis.mechanism().equals("mode.hidden")) {
            double m = candidate.knobs().get(at[0]).reference();
            double k = candidate.knobs().get(at[1]).reference();
            double c = candidate.knobs().get(at[2]).reference();
            out.add(plain(keys.get(0), at[0], candidate));
            out.add(new Estimand("frequency_hz", new int[] {at[0], at[1]}, new double[] {-0.5, 0.5}, false,
                    Math.sqrt(k / m) / (2 * Math.PI), 0));
            out.add(new Estimand("damping_ratio", new int[] {at[0], at[1], at[2]}, new double[] {-0.5, -0.5, 1}, false,
                    c / (2 * Math.sqrt(k * m)), 0));
            return out;
        }
        if (keys.contains("second_share")) {
            out.add(new Estimand("share", new int[] {at[0], at[2]}, new double[] {1, 1}, false, 0, candidate.knobs().get(at[0]).unit()));
        }
        for (int i = 0; i < at.length; i++) {
            if (!keys.get(i).equals("cosine_N") && !keys.get(i).equals("sine_N")) {
                out.add(plain(keys.get(i), at[i], candidate));
            }
        }
        if (keys.contains("cosine_N")) {
            int[] parts = {at[keys.indexOf("cosine_N")], at[keys.indexOf("sine_N")]};
            out.add(new Estimand("amplitude_N", parts, new double[] {1, 1}, true, 0, candidate.knobs().get(parts[0]).unit()));
        }
        return out;
    }

    private static Estimand plain(String key, int at, Candidate candidate) {
        Knob knob = candidate.knobs().get(at);
        return new Estimand(key, new int[] {at}, new double[] {1}, false, knob.reference(), knob.unit());
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

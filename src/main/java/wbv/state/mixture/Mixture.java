package wbv.state.mixture;

import java.io.Serializable;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.signal.LogSum;

/**
 * A mixture of normal densities, Σ w_m N(x; μ_m, C_m).
 *
 * @param weights    shares, one for each component, &gt;= 0, summing to one. Not copied; do not change them.
 * @param components at least one, all of one dimension
 */
public record Mixture(double[] weights, List<Gaussian> components) implements Serializable {

    private static final double ROUNDING = 1e-9;

    public Mixture {
        components = List.copyOf(components);
        if (components.isEmpty() || components.size() != weights.length) {
            throw new IllegalArgumentException("a mixture needs as many components as weights, at least one: "
                    + components.size() + ", " + weights.length);
        }
        double sum = 0;
        for (int m = 0; m < weights.length; m++) {
            if (!(weights[m] >= 0)) {
                throw new IllegalArgumentException("a weight must be >= 0: " + weights[m]);
            }
            if (components.get(m).dimensions() != components.get(0).dimensions()) {
                throw new IllegalArgumentException("all components must have " + components.get(0).dimensions()
                        + " dimensions: " + components.get(m).dimensions());
            }
            sum += weights[m];
        }
        if (!(Math.abs(sum - 1) < ROUNDING * weights.length)) {
            throw new IllegalArgumentException("weights must sum to 1: " + sum);
        }
    }

    /** One component. */
    public static Mixture of(Gaussian gaussian) {
        return new Mixture(new double[] {1}, List.of(gaussian));
    }

    /** Number of components. */
    public int size() {
        return weights.length;
    }

    /** Length d of a row. */
    public int dimensions() {
        return components.get(0).dimensions();
    }

    /**
     * ln p(x) [nat].
     * Thesis: Eq. 7-1.
     *
     * @param x length d, each number in its own unit. Not modified.
     * @param logs ln w_m N(x; μ_m, C_m) [nat] of every component, at least {@link #size} long. Modified.
     * @param scratch room of no unit, at least d long. Modified.
     */
    public double logDensity(double[] x, double[] logs, double[] scratch) {
        if (weights.length == 1) {
            logs[0] = components.get(0).logDensity(x, scratch);
            return logs[0];
        }
        for (int m = 0; m < weights.length; m++) {
            logs[m] = Math.log(weights[m]) + components.get(m).logDensity(x, scratch);
        }
        return LogSum.of(logs, weights.length);
    }

    /**
     * ln p of all rows [nat].
     *
     * @param rows n by d, each column in its own unit. Not modified.
     */
    public double logLikelihood(double[][] rows) {
        double[] logs = new double[size()];
        double[] scratch = new double[dimensions()];
        double sum = 0;
        for (double[] row : rows) {
            sum += logDensity(row, logs, scratch);
        }
        return sum;
    }

    /**
     * The likeliest component of every row.
     *
     * @param rows n by d, each column in its own unit. Not modified.
     * @return n
     */
    public int[] labels(double[][] rows) {
        double[] logs = new double[size()];
        double[] scratch = new double[dimensions()];
        int[] labels = new int[rows.length];
        for (int i = 0; i < rows.length; i++) {
            logDensity(rows[i], logs, scratch);
            for (int m = 1; m < logs.length; m++) {
                labels[i] = logs[m] > logs[labels[i]] ? m : labels[i];
            }
        }
        return labels;
    }

    /**
     * A random point; returns its component.
     *
     * @param into length d, each number in its own unit. Modified.
     */
    public int sample(RandomGenerator random, double[] into) {
        double u = random.nextDouble();
        int m = 0;
        while (m + 1 < weights.length && u >= weights[m]) {
            u -= weights[m];
            m++;
        }
        components.get(m).sample(random, into);
        return m;
    }
}

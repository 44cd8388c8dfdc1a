package wbv.diagnosis.surrogate;

import java.util.Arrays;

/** What one series misses of another. */
final class Missed {

    /** Of what a simulation did before that nothing is known [s]. */
    private static final double SETTLING = 3;

    private Missed() {}

    /**
     * The first less the second, by sample, in their unit.
     *
     * @param x by sample. Not modified.
     * @param y likewise, in the same unit. Not modified.
     */
    static double[] of(double[] x, double[] y) {
        double[] out = new double[x.length];
        Arrays.setAll(out, i -> x[i] - y[i]);
        return out;
    }

    /**
     * Root mean square of a difference over that of the first, means left out, where both are known [1].
     *
     * @param x    by sample, NaN where nothing is known. Not modified.
     * @param y    likewise, in the same unit
     * @param from first sample that counts
     */
    static double share(double[] x, double[] y, int from) {
        return deviation(of(x, y), from) / deviation(x, from);
    }

    /**
     * The same where what a simulation did at first does not count.
     *
     * @param x    by sample, NaN where nothing is known. Not modified.
     * @param y    likewise, in the same unit
     * @param rate of samples [Hz]
     */
    static double settledShare(double[] x, double[] y, double rate) {
        return share(x, y, (int) (SETTLING * rate));
    }

    /**
     * Root mean square about the mean, of what is known, in its own unit.
     *
     * @param x    by sample, NaN where nothing is known. Not modified.
     * @param from first sample that counts
     */
    static double deviation(double[] x, int from) {
        double sum = 0;
        double squares = 0;
        int count = 0;
        for (int i = from; i < x.length; i++) {
            if (!Double.isNaN(x[i])) {
                sum += x[i];
                squares += x[i] * x[i];
                count++;
            }
        }
        return Math.sqrt(Math.max(0, squares / count - sum / count * (sum / count)));
    }
}

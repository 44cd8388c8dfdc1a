package wbv.diagnosis;

import java.util.Arrays;

/** Sums of probabilities that are known by their logarithms. */
final class LogSum {

    private LogSum() { }

    /** log Σ exp x; negative infinity for none. */
    static double of(double... x) {
        double most = Arrays.stream(x).max().orElse(Double.NEGATIVE_INFINITY);
        return most == Double.NEGATIVE_INFINITY ? most : most + Math.log(Arrays.stream(x).map(v -> Math.exp(v - most)).sum());
    }

    /** Where the greatest stands. */
    static int greatest(double[] x) {
        int best = 0;
        for (int i = 1; i < x.length; i++) {
            best = x[i] > x[best] ? i : best;
        }
        return best;
    }
}

package wbv.signal;

/** Sums of numbers that are given as logarithms. */
public final class LogSum {

    private LogSum() {}

    /**
     * ln Σ exp(a_i) of the first so many [nat]; -∞ if all are.
     *
     * @param a logarithms, at least so long. Not modified.
     */
    public static double of(double[] a, int count) {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            most = Math.max(most, a[i]);
        }
        if (most == Double.NEGATIVE_INFINITY) {
            return most;
        }
        double sum = 0;
        for (int i = 0; i < count; i++) {
            sum += Math.exp(a[i] - most);
        }
        return most + Math.log(sum);
    }

    /**
     * Replaces logarithms by shares that sum to one, and returns ln Σ exp [nat].
     *
     * @param a logarithms, at least so long. Modified.
     */
    public static double share(double[] a, int count) {
        double whole = of(a, count);
        for (int i = 0; i < count; i++) {
            a[i] = whole == Double.NEGATIVE_INFINITY ? 1.0 / count : Math.exp(a[i] - whole);
        }
        return whole;
    }
}

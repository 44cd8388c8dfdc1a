package wbv.signal;

/** Scalar products of long series: four sums side by side, since one would wait for itself at every sample. */
public final class ScalarProduct {

    private ScalarProduct() {}

    /**
     * The scalar product, in the product of both units.
     *
     * @param a of any length and unit
     * @param b as long as a, at least, of any unit. Neither is modified.
     */
    public static double of(double[] a, double[] b) {
        return of(a, b, 0, a.length);
    }

    /**
     * The scalar product from an index to before another, in the product of both units. Neither array is modified.
     *
     * @param a of any length and unit
     * @param b likewise
     */
    public static double of(double[] a, double[] b, int from, int to) {
        double s0 = 0;
        double s1 = 0;
        double s2 = 0;
        double s3 = 0;
        int i = from;
        for (; i + 3 < to; i += 4) {
            s0 += a[i] * b[i];
            s1 += a[i + 1] * b[i + 1];
            s2 += a[i + 2] * b[i + 2];
            s3 += a[i + 3] * b[i + 3];
        }
        for (; i < to; i++) {
            s0 += a[i] * b[i];
        }
        return s0 + s1 + s2 + s3;
    }
}

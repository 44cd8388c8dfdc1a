package wbv.diagnosis.fit;

import java.util.stream.IntStream;

/** Products of all pairs of long vectors: what least squares spend much of their time on. */
public final class Gram {

    /** Numbers of each vector that are multiplied before the next ones are fetched: so many of all vectors stay near the processor. */
    private static final int BLOCK = 64;

    private Gram() {}

    /**
     * The product of each pair.
     *
     * @param vectors of the same length each, in one unit. Not modified.
     * @return symmetric, n by n, in the square of that unit
     */
    public static double[][] of(double[][] vectors) {
        int n = vectors.length;
        double[][] out = new double[n][n];
        addProducts(vectors, vectors, true, out);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < i; j++) {
                out[j][i] = out[i][j];
            }
        }
        return out;
    }

    /**
     * Products of vectors with each of some others, in the product of the units, by number of the other, then by vector.
     *
     * @param vectors of the same length each, in one unit
     * @param others as long each, in one unit. Neither is modified.
     */
    public static double[][] products(double[][] vectors, double[][] others) {
        double[][] out = new double[others.length][vectors.length];
        addProducts(vectors, others, false, out);
        return out;
    }

    /**
     * A block of all vectors is turned, so that the sums of one row run side by side: no sum waits for itself, and the machine adds several
     * at once.
     *
     * @param half whether of a row only what is left of the diagonal is asked @param out others by vectors, from 0. Modified.
     */
    private static void addProducts(double[][] vectors, double[][] others, boolean half, double[][] out) {
        int n = vectors.length;
        int length = n == 0 ? 0 : vectors[0].length;
        double[][] turned = new double[BLOCK][n];
        for (int from = 0; from < length; from += BLOCK) {
            int count = Math.min(BLOCK, length - from);
            for (int j = 0; j < n; j++) {
                double[] vector = vectors[j];
                for (int k = 0; k < count; k++) {
                    turned[k][j] = vector[from + k];
                }
            }
            for (int i = 0; i < others.length; i++) {
                addRow(turned, others[i], from, count, half ? i + 1 : n, out[i]);
            }
        }
    }

    /** @param row of sums, of which the first few are asked. Modified. */
    private static void addRow(double[][] turned, double[] other, int from, int count, int asked, double[] row) {
        int k = 0;
        for (; k + 3 < count; k += 4) {
            addFour(turned[k], turned[k + 1], turned[k + 2], turned[k + 3], other, from + k, asked, row);
        }
        for (; k < count; k++) {
            double[] all = turned[k];
            double x = other[from + k];
            for (int j = 0; j < asked; j++) {
                row[j] += x * all[j];
            }
        }
    }

    private static void addFour(double[] all0, double[] all1, double[] all2, double[] all3, double[] other, int at, int asked,
            double[] row) {
        double x0 = other[at];
        double x1 = other[at + 1];
        double x2 = other[at + 2];
        double x3 = other[at + 3];
        for (int j = 0; j < asked; j++) {
            row[j] = row[j] + x0 * all0[j] + x1 * all1[j] + x2 * all2[j] + x3 * all3[j];
        }
    }

    /**
     * Products of vectors with another, in the product of the units, by vector.
     *
     * @param vectors of its length each, in one unit. Not modified.
     * @param other as long, of any unit. Not modified.
     */
    public static double[] products(double[][] vectors, double[] other) {
        double[] out = new double[vectors.length];
        int i = 0;
        for (; i + 1 < out.length; i += 2) {
            two(vectors[i], vectors[i + 1], other, out, i);
        }
        if (i < out.length) {
            out[i] = Fitter.dot(vectors[i], other);
        }
        return out;
    }

    /** Two as {@link Fitter#dot} sums them, since each number of the other then is fetched once for both. */
    private static void two(double[] a, double[] b, double[] other, double[] out, int at) {
        double a0 = 0;
        double a1 = 0;
        double a2 = 0;
        double a3 = 0;
        double b0 = 0;
        double b1 = 0;
        double b2 = 0;
        double b3 = 0;
        int k = 0;
        for (; k + 3 < other.length; k += 4) {
            double x0 = other[k];
            double x1 = other[k + 1];
            double x2 = other[k + 2];
            double x3 = other[k + 3];
            a0 += a[k] * x0;
            b0 += b[k] * x0;
            a1 += a[k + 1] * x1;
            b1 += b[k + 1] * x1;
            a2 += a[k + 2] * x2;
            b2 += b[k + 2] * x2;
            a3 += a[k + 3] * x3;
            b3 += b[k + 3] * x3;
        }
        for (; k < other.length; k++) {
            a0 += a[k] * other[k];
            b0 += b[k] * other[k];
        }
        out[at] = a0 + a1 + a2 + a3;
        out[at + 1] = b0 + b1 + b2 + b3;
    }

    /** Subtracts multiples of vectors, one after the other. @param factors those that are 0 take nothing @param from Modified. */
    static void subtract(double[][] vectors, double[] factors, double[] from) {
        int[] some = IntStream.range(0, factors.length).filter(i -> factors[i] != 0).toArray();
        int i = 0;
        for (; i + 3 < some.length; i += 4) {
            subtractFour(vectors, factors, some, i, from);
        }
        for (; i < some.length; i++) {
            double[] v = vectors[some[i]];
            double f = factors[some[i]];
            for (int k = 0; k < from.length; k++) {
                from[k] -= v[k] * f;
            }
        }
    }

    private static void subtractFour(double[][] vectors, double[] factors, int[] some, int i, double[] from) {
        double[] v0 = vectors[some[i]];
        double[] v1 = vectors[some[i + 1]];
        double[] v2 = vectors[some[i + 2]];
        double[] v3 = vectors[some[i + 3]];
        double f0 = factors[some[i]];
        double f1 = factors[some[i + 1]];
        double f2 = factors[some[i + 2]];
        double f3 = factors[some[i + 3]];
        for (int k = 0; k < from.length; k++) {
            from[k] = from[k] - v0[k] * f0 - v1[k] * f1 - v2[k] * f2 - v3[k] * f3;
        }
    }
}

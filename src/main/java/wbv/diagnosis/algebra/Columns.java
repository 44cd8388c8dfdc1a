package wbv.diagnosis.algebra;

import java.util.Arrays;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.signal.ScalarProduct;

/**
 * Long vectors of one length, to be multiplied with each other and with more: what least squares spend much of their time on. Many are zero
 * at their ends, such as what one sensor's error does to a whitened residual, which shows in the outputs from that sensor's on and in no
 * earlier one. Zeros are passed over.
 */
public final class Columns {

    /**
     * So many others pay for turning the vectors, an effort: 89 of 33 600 numbers take 1.2 ms with one other by themselves, and turned 5.0,
     * 2.2, 1.3, 0.8 and 0.6 ms with each of 1, 2, 4, 8 and 16.
     */
    private static final int FEW = 4;

    private final double[][] vectors;
    /** Where each vector's first number stands that is not zero, and what comes after its last; the same where it has none. */
    private final int[] from;
    private final int[] to;

    /**
     * Vectors to be multiplied.
     *
     * @param vectors by vector, of the same length each, in any unit. Not copied, not modified.
     */
    public Columns(double[][] vectors) {
        this(vectors, Arrays.stream(vectors).mapToInt(Columns::first).toArray(),
                Arrays.stream(vectors).mapToInt(Columns::afterLast).toArray());
    }

    private Columns(double[][] vectors, int[] from, int[] to) {
        this.vectors = vectors;
        this.from = from;
        this.to = to;
    }

    private static int first(double[] vector) {
        int i = 0;
        while (i < vector.length && vector[i] == 0) {
            i++;
        }
        return i == vector.length ? 0 : i;
    }

    private static int afterLast(double[] vector) {
        int i = vector.length;
        while (i > 0 && vector[i - 1] == 0) {
            i--;
        }
        return i;
    }

    /**
     * Some of them.
     *
     * @param which indices. Not modified.
     */
    public Columns only(int[] which) {
        return new Columns(IntStream.of(which).mapToObj(i -> vectors[i]).toArray(double[][]::new),
                IntStream.of(which).map(i -> from[i]).toArray(), IntStream.of(which).map(i -> to[i]).toArray());
    }

    /** How many they are. */
    public int count() {
        return vectors.length;
    }

    /** One of them, as long as each, in its unit. Not a copy. */
    public double[] get(int i) {
        return vectors[i];
    }

    /** The product of each pair: by vector and vector, symmetric, in their units multiplied. */
    public double[][] gram() {
        double[][] out = products(this, true);
        for (int i = 0; i < out.length; i++) {
            for (int j = 0; j < i; j++) {
                out[j][i] = out[i][j];
            }
        }
        return out;
    }

    /**
     * Products with each of some others, in their units multiplied: by other and by vector.
     *
     * @param others as long
     */
    public double[][] products(Columns others) {
        return others.count() < FEW ? Arrays.stream(others.vectors).map(this::products).toArray(double[][]::new)
                : products(others, false);
    }

    /** @param half whether of a row only what is left of the diagonal is asked */
    private double[][] products(Columns others, boolean half) {
        double[][] out = new double[others.count()][count()];
        // Between two of these no vector begins or ends.
        int[] cuts = Stream.of(from, to, others.from, others.to).flatMapToInt(IntStream::of).sorted().distinct().toArray();
        TurnedBlock block = new TurnedBlock(count());
        for (int cut = 0; cut + 1 < cuts.length; cut++) {
            addProducts(others, half, cuts[cut], cuts[cut + 1], block, out);
        }
        return out;
    }

    /** Those that are not zero from one number up to another. */
    private int[] within(int begin, int end) {
        int[] out = new int[count()];
        int found = 0;
        for (int i = 0; i < out.length; i++) {
            if (from[i] <= begin && end <= to[i]) {
                out[found++] = i;
            }
        }
        return Arrays.copyOf(out, found);
    }

    /**
     * @param block as wide as these. Modified.
     * @param out others by vectors. Modified.
     */
    private void addProducts(Columns others, boolean half, int begin, int end, TurnedBlock block, double[][] out) {
        int[] mine = within(begin, end);
        int[] theirs = half ? mine : others.within(begin, end);
        double[][] sums = new double[theirs.length][mine.length];
        for (int at = begin; at < end && sums.length > 0; at += TurnedBlock.LENGTH) {
            block.fill(vectors, mine, at, Math.min(TurnedBlock.LENGTH, end - at));
            for (int i = 0; i < theirs.length; i++) {
                block.addProducts(others.vectors[theirs[i]], half ? i + 1 : mine.length, sums[i]);
            }
        }
        for (int i = 0; i < theirs.length; i++) {
            for (int j = 0; j < mine.length; j++) {
                out[theirs[i]][mine[j]] += sums[i][j];
            }
        }
    }

    /**
     * Products with another vector: by vector, in their units multiplied.
     *
     * @param other as long as each, in any unit. Not modified.
     */
    public double[] products(double[] other) {
        double[] out = new double[count()];
        int i = 0;
        for (; i + 1 < out.length; i += 2) {
            two(i, other, out);
        }
        if (i < out.length) {
            out[i] = ScalarProduct.of(vectors[i], other, from[i], to[i]);
        }
        return out;
    }

    /** Two as {@link wbv.signal.ScalarProduct#of} sums them, since each number of the other then is fetched once for both. */
    private void two(int i, double[] other, double[] out) {
        double[] a = vectors[i];
        double[] b = vectors[i + 1];
        int end = Math.max(to[i], to[i + 1]);
        double a0 = 0;
        double a1 = 0;
        double a2 = 0;
        double a3 = 0;
        double b0 = 0;
        double b1 = 0;
        double b2 = 0;
        double b3 = 0;
        int k = Math.min(from[i], from[i + 1]);
        for (; k + 3 < end; k += 4) {
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
        for (; k < end; k++) {
            a0 += a[k] * other[k];
            b0 += b[k] * other[k];
        }
        out[i] = a0 + a1 + a2 + a3;
        out[i + 1] = b0 + b1 + b2 + b3;
    }

    /**
     * Subtracts multiples of them.
     *
     * @param factors [1], one a vector; those that are 0 take nothing. Not modified.
     * @param target as long as each, in the vectors' unit. Modified.
     */
    public void subtract(double[] factors, double[] target) {
        int[] some = IntStream.range(0, factors.length).filter(i -> factors[i] != 0).toArray();
        int i = 0;
        for (; i + 3 < some.length; i += 4) {
            subtractFour(factors, Arrays.copyOfRange(some, i, i + 4), target);
        }
        for (; i < some.length; i++) {
            double[] v = vectors[some[i]];
            double f = factors[some[i]];
            for (int k = from[some[i]]; k < to[some[i]]; k++) {
                target[k] -= v[k] * f;
            }
        }
    }

    private void subtractFour(double[] factors, int[] four, double[] target) {
        double[] v0 = vectors[four[0]];
        double[] v1 = vectors[four[1]];
        double[] v2 = vectors[four[2]];
        double[] v3 = vectors[four[3]];
        double f0 = factors[four[0]];
        double f1 = factors[four[1]];
        double f2 = factors[four[2]];
        double f3 = factors[four[3]];
        int end = IntStream.of(four).map(i -> to[i]).max().orElseThrow();
        for (int k = IntStream.of(four).map(i -> from[i]).min().orElseThrow(); k < end; k++) {
            target[k] = target[k] - v0[k] * f0 - v1[k] * f1 - v2[k] * f2 - v3[k] * f3;
        }
    }
}

package wbv.diagnosis.algebra;

/**
 * A stretch of several vectors, turned so that the products of all of them with one other run side by side: no sum waits for itself, and
 * the machine adds several at once.
 */
final class TurnedBlock {

    /** Numbers of each vector that are multiplied before the next ones are fetched: so many of all vectors stay near the processor. */
    static final int LENGTH = 64;

    /** By number and vector. */
    private final double[][] turned;
    private int from;
    private int count;

    TurnedBlock(int vectors) {
        turned = new double[LENGTH][vectors];
    }

    /**
     * Takes the next stretch.
     *
     * @param vectors of which some are taken. Not modified.
     * @param which no more than the block holds. Not modified.
     * @param at its first number in each
     * @param length of it, {@link #LENGTH} at most
     */
    void fill(double[][] vectors, int[] which, int at, int length) {
        from = at;
        count = length;
        for (int j = 0; j < which.length; j++) {
            double[] vector = vectors[which[j]];
            for (int k = 0; k < length; k++) {
                turned[k][j] = vector[at + k];
            }
        }
    }

    /**
     * Adds the stretch's part of products with another vector.
     *
     * @param other as long as the vectors. Not modified.
     * @param asked how many of the vectors, the first
     * @param row of sums, by vector. Modified.
     */
    void addProducts(double[] other, int asked, double[] row) {
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
}

package wbv.diagnosis.algebra;

import java.util.Arrays;

/**
 * How strong some directions are together where they leave least of a residual. One that those before it nearly make has no strength of its
 * own.
 *
 * @param strengths one a direction that was asked for [1]. Not copied, not to be modified
 * @param gain      by how much less the sum of squares is that they leave [1]
 */
public record JointStrengths(double[] strengths, double gain) {

    /**
     * Part of the square of a direction [1] that another, or what follows it, cannot make itself, below which its strength means nothing: a
     * hundredth of the direction, by which a sensor's gain errs (one standard deviation), makes as much seem new.
     */
    public static final double LEAST_NEW = 1e-4;

    /**
     * By Cholesky's factors of the products of those that are free: few, and asked for so often that they are not copied for a library.
     *
     * @param products of each two of all directions [1], n by n
     * @param left     of each of all with the residual [1], n long
     * @param which    those that are asked for
     * @param held     how strong those are that are held [1], as many; no number for one that is free. No array is modified
     */
    public static JointStrengths of(double[][] products, double[] left, int[] which, double[] held) {
        int[] free = free(held);
        double[][] factor = new double[free.length][free.length];
        double[] forward = new double[free.length];
        for (int i = 0; i < free.length; i++) {
            double[] row = products[which[free[i]]];
            double gradient = left[which[free[i]]];
            for (int k = 0; k < held.length; k++) {
                gradient += Double.isNaN(held[k]) ? 0 : row[which[k]] * held[k];
            }
            for (int j = 0; j <= i; j++) {
                double rest = row[which[free[j]]];
                for (int k = 0; k < j; k++) {
                    rest -= factor[i][k] * factor[j][k];
                }
                factor[i][j] = j < i ? factor[j][j] > 0 ? rest / factor[j][j] : 0
                        : rest > LEAST_NEW * row[which[free[i]]] ? Math.sqrt(rest) : 0;
                gradient -= j < i ? factor[i][j] * forward[j] : 0;
            }
            forward[i] = factor[i][i] > 0 ? gradient / factor[i][i] : 0;
        }
        double[] out = held.clone();
        for (int i = free.length - 1; i >= 0; i--) {
            double sum = -forward[i];
            for (int k = i + 1; k < free.length; k++) {
                sum -= factor[k][i] * out[free[k]];
            }
            out[free[i]] = factor[i][i] > 0 ? sum / factor[i][i] : 0;
        }
        return new JointStrengths(out, gain(products, left, which, out));
    }

    private static int[] free(double[] held) {
        int[] out = new int[held.length];
        int count = 0;
        for (int i = 0; i < held.length; i++) {
            if (Double.isNaN(held[i])) {
                out[count++] = i;
            }
        }
        return Arrays.copyOf(out, count);
    }

    private static double gain(double[][] products, double[] left, int[] which, double[] strengths) {
        double gain = 0;
        for (int i = 0; i < which.length; i++) {
            double product = 2 * left[which[i]];
            for (int j = 0; j < which.length; j++) {
                product += products[which[i]][which[j]] * strengths[j];
            }
            gain -= strengths[i] * product;
        }
        return gain;
    }
}

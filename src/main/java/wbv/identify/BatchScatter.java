package wbv.identify;

import org.apache.commons.math3.distribution.TDistribution;
import org.ejml.data.DMatrixRMaj;

/**
 * What a least-squares fit would scatter, were it done again on as long a stretch: {@code V = A⁻¹ B A⁻¹}, A the normal matrix and
 * B from the scatter of {@code Σ ψ e} over batches of the stretch (White, Econometrica 50, 1982; batch means). It holds where
 * errors follow each other and know the input as well, as they do where the model is not the truth.
 *
 * <p>The covariance is that of a normal variable whose ±2σ hold 95 %: Student's quantile for so few batches is in it.
 */
final class BatchScatter {

    /** Of which the scatter is made: 16 leave Student's quantile within 8 % of the normal one. */
    private static final int BATCHES = 16;

    /** Hears the rows of a least-squares problem. */
    interface Sink {
        Sink NONE = (k, row, error) -> {};

        /**
         * @param k number of the sample
         * @param row slopes ψ. Not modified.
         * @param error e
         */
        void add(int k, double[] row, double error);
    }

    private final int unknowns;
    private final int samples;
    private final double[][] sums;

    BatchScatter(int unknowns, int samples) {
        this.unknowns = unknowns;
        this.samples = samples;
        this.sums = new double[BATCHES][unknowns];
    }

    void add(int k, double[] row, double error) {
        double[] sum = sums[(int) ((long) k * BATCHES / samples)];
        for (int i = 0; i < unknowns; i++) {
            sum[i] += row[i] * error;
        }
    }

    /**
     * Covariance of the first unknowns.
     *
     * @param inverse A⁻¹. Not modified.
     */
    double[][] covariance(DMatrixRMaj inverse, int first) {
        double quantile = new TDistribution(BATCHES - 1).inverseCumulativeProbability(0.975) / 2;
        double factor = quantile * quantile * BATCHES / (BATCHES - 1);
        double[][] covariance = new double[first][first];
        double[] moved = new double[first];
        for (double[] sum : sums) {
            for (int i = 0; i < first; i++) {
                moved[i] = 0;
                for (int j = 0; j < unknowns; j++) {
                    moved[i] += inverse.get(i, j) * sum[j];
                }
            }
            for (int i = 0; i < first; i++) {
                for (int j = 0; j < first; j++) {
                    covariance[i][j] += factor * moved[i] * moved[j];
                }
            }
        }
        return covariance;
    }
}

package wbv.identify;

import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.decomposition.chol.CholeskyDecompositionInner_DDRM;

/**
 * Other motions of the base as an output may know them: each through a series of discrete Laguerre functions (Wahlberg, IEEE
 * Trans. Automatic Control 1991), whose sums stand for any response that fades like a seated body's.
 */
final class CrossMotions {

    static final int TERMS = 12;
    /** Decay of the functions [1/s]: about that of a seated body's slow modes. */
    private static final double DECAY = 17;
    /** Ridge, as a share of a column's square: keeps two motions that are nearly one apart by rounding. */
    private static final double RIDGE = 1e-9;

    private final double[][] columns;
    private final int samples;

    /**
     * @param inputs without offset, no gaps, all of one length. Not modified.
     * @param samples their length
     */
    CrossMotions(double rate, double[][] inputs, int samples) {
        this.samples = samples;
        this.columns = new double[TERMS * inputs.length][];
        double pole = Math.exp(-DECAY / rate);
        double gain = Math.sqrt(1 - pole * pole);
        for (int i = 0; i < inputs.length; i++) {
            double[] from = inputs[i];
            for (int k = 0; k < TERMS; k++) {
                from = k == 0 ? lowPassed(from, pole, gain) : allPassed(from, pole);
                columns[i * TERMS + k] = from;
            }
        }
    }

    private static double[] lowPassed(double[] x, double pole, double gain) {
        double[] out = new double[x.length];
        double state = 0;
        for (int t = 0; t < x.length; t++) {
            state = pole * state + gain * x[t];
            out[t] = state;
        }
        return out;
    }

    /** (z⁻¹ - p)/(1 - p z⁻¹). */
    private static double[] allPassed(double[] x, double pole) {
        double[] out = new double[x.length];
        double state = 0;
        double before = 0;
        for (int t = 0; t < x.length; t++) {
            state = pole * state + before - pole * x[t];
            before = x[t];
            out[t] = state;
        }
        return out;
    }

    /**
     * On samples of some weight.
     *
     * @param weight 0 or 1 for each sample. Kept.
     */
    On on(double[] weight) {
        return new On(weight);
    }

    /** What they can explain of samples of some weight. */
    final class On {

        private final double[] weight;
        private final DMatrixRMaj gram;

        private On(double[] weight) {
            this.weight = weight;
            int k = columns.length;
            gram = new DMatrixRMaj(k, k);
            double[] weighted = new double[samples];
            for (int i = 0; i < k; i++) {
                for (int t = 0; t < samples; t++) {
                    weighted[t] = weight[t] * columns[i][t];
                }
                for (int j = 0; j <= i; j++) {
                    double sum = dot(weighted, columns[j]);
                    gram.set(i, j, sum);
                    gram.set(j, i, sum);
                }
            }
        }

        double[] weight() {
            return weight;
        }

        /**
         * Some of them.
         *
         * @param chosen indices of inputs
         */
        Explaining by(List<Integer> chosen) {
            return new Explaining(this, chosen);
        }
    }

    private double dot(double[] a, double[] b) {
        double sum = 0;
        for (int t = 0; t < samples; t++) {
            sum += a[t] * b[t];
        }
        return sum;
    }

    /** Least squares on some of the motions. */
    final class Explaining {

        private final double[] weight;
        private final int[] index;
        private final DMatrixRMaj factor;

        private Explaining(On on, List<Integer> chosen) {
            weight = on.weight;
            index = new int[TERMS * chosen.size()];
            for (int i = 0; i < index.length; i++) {
                index[i] = TERMS * chosen.get(i / TERMS) + i % TERMS;
            }
            DMatrixRMaj part = new DMatrixRMaj(index.length, index.length);
            for (int i = 0; i < index.length; i++) {
                for (int j = 0; j < index.length; j++) {
                    double value = on.gram.get(index[i], index[j]);
                    part.set(i, j, i == j ? value * (1 + RIDGE) + Double.MIN_NORMAL : value);
                }
            }
            CholeskyDecompositionInner_DDRM cholesky = new CholeskyDecompositionInner_DDRM(true);
            boolean sound = index.length > 0 && cholesky.decompose(part);
            factor = sound ? cholesky.getT(null) : new DMatrixRMaj(0, 0);
        }

        /** Whether they are told apart by their motion. */
        boolean sound() {
            return factor.numRows == index.length;
        }

        /**
         * x less what a combination of them explains.
         *
         * @param x weighted, at least as long as the samples. Modified.
         */
        void takeOut(double[] x) {
            if (index.length > 0) {
                takeOut(x, coefficients(x));
            }
        }

        /**
         * The combination nearest to x.
         *
         * @param x weighted
         */
        double[] coefficients(double[] x) {
            int k = index.length;
            double[] c = new double[k];
            for (int i = 0; i < k; i++) {
                c[i] = dot(columns[index[i]], x);
            }
            for (int i = 0; i < k; i++) {
                for (int j = 0; j < i; j++) {
                    c[i] -= factor.get(i, j) * c[j];
                }
                c[i] /= factor.get(i, i);
            }
            for (int i = k - 1; i >= 0; i--) {
                for (int j = i + 1; j < k; j++) {
                    c[i] -= factor.get(j, i) * c[j];
                }
                c[i] /= factor.get(i, i);
            }
            return c;
        }

        /** x less a combination learned elsewhere. */
        void takeOut(double[] x, double[] c) {
            for (int i = 0; i < index.length; i++) {
                double[] column = columns[index[i]];
                for (int t = 0; t < samples; t++) {
                    x[t] -= weight[t] * c[i] * column[t];
                }
            }
        }
    }
}

package wbv.identify;

import java.util.Arrays;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.decomposition.chol.CholeskyDecompositionInner_DDRM;
import wbv.signal.ScalarProduct;

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
        On on = new On(weight);
        double[] weighted = new double[samples];
        for (int i = 0; i < columns.length; i++) {
            for (int t = on.from; t < on.to; t++) {
                weighted[t] = weight[t] * columns[i][t];
            }
            for (int j = 0; j <= i; j++) {
                on.add(i, j, ScalarProduct.of(weighted, columns[j], on.from, on.to));
            }
        }
        return on;
    }

    /** What they can explain of samples of some weight. */
    final class On {

        private final double[] weight;
        /** First sample that counts, and that behind the last. */
        private final int from;
        private final int to;
        private final DMatrixRMaj gram;

        private On(double[] weight) {
            this.weight = weight;
            int first = 0;
            while (first < samples && weight[first] == 0) {
                first++;
            }
            int end = samples;
            while (end > first && weight[end - 1] == 0) {
                end--;
            }
            this.from = first;
            this.to = end;
            gram = new DMatrixRMaj(columns.length, columns.length);
        }

        private void add(int i, int j, double sum) {
            gram.add(i, j, sum);
            if (i != j) {
                gram.add(j, i, sum);
            }
        }

        double[] weight() {
            return weight;
        }

        /**
         * On these samples without some of them, which costs as much as those are.
         *
         * @param staying weight of those that stay, 0 or 1 for each sample, 0 wherever it is 0 here. Kept.
         */
        On only(double[] staying) {
            On on = new On(staying);
            on.gram.setTo(gram);
            for (int t = from; t < to; t++) {
                if (weight[t] != staying[t]) {
                    for (int i = 0; i < columns.length; i++) {
                        for (int j = 0; j <= i; j++) {
                            on.add(i, j, -columns[i][t] * columns[j][t]);
                        }
                    }
                }
            }
            return on;
        }

        /**
         * On these samples and on others.
         *
         * @param other with weight on none of these
         */
        On and(On other) {
            double[] both = new double[samples];
            Arrays.setAll(both, t -> weight[t] + other.weight[t]);
            On on = new On(both);
            CommonOps_DDRM.add(gram, other.gram, on.gram);
            return on;
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

    /** Least squares on some of the motions. */
    final class Explaining {

        private final On on;
        private final int[] index;
        private final DMatrixRMaj factor;

        private Explaining(On on, List<Integer> chosen) {
            this.on = on;
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
                c[i] = ScalarProduct.of(columns[index[i]], x, on.from, on.to);
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
                for (int t = on.from; t < on.to; t++) {
                    x[t] -= on.weight[t] * c[i] * column[t];
                }
            }
        }
    }
}

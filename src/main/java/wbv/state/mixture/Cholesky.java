package wbv.state.mixture;

/** Lower triangular factors of small matrices, by rows without zeros: element (i, j) is at i (i + 1) / 2 + j. */
final class Cholesky {

    /** A pivot below this share of its diagonal element is rounding. */
    private static final double ROUNDING = 1e-13;

    private Cholesky() {}

    /** Place of an element of the lower triangle. */
    static int at(int i, int j) {
        return i * (i + 1) / 2 + j;
    }

    /**
     * C = L Lᵀ.
     *
     * @param c d by d, by rows. Not modified.
     * @param floor squares of pivots below a millionth of these fail
     * @param into L. Modified.
     * @return false if the matrix is not positive definite
     */
    static boolean factor(double[] c, int d, double[] floor, double[] into) {
        for (int i = 0; i < d; i++) {
            for (int j = 0; j <= i; j++) {
                double sum = c[i * d + j];
                for (int k = 0; k < j; k++) {
                    sum -= into[at(i, k)] * into[at(j, k)];
                }
                if (i != j) {
                    into[at(i, j)] = sum / into[at(j, j)];
                } else if (sum > 1e-6 * floor[i] && sum > ROUNDING * c[i * d + i]) {
                    into[at(i, i)] = Math.sqrt(sum);
                } else {
                    return false;
                }
            }
        }
        return true;
    }

    /** L⁻¹, lower triangular too. */
    static double[] inverse(double[] factor, int d) {
        double[] inverse = new double[factor.length];
        for (int j = 0; j < d; j++) {
            inverse[at(j, j)] = 1 / factor[at(j, j)];
            for (int i = j + 1; i < d; i++) {
                double sum = 0;
                for (int k = j; k < i; k++) {
                    sum -= factor[at(i, k)] * inverse[at(k, j)];
                }
                inverse[at(i, j)] = sum / factor[at(i, i)];
            }
        }
        return inverse;
    }

    /**
     * L of L Lᵀ + sign · x xᵀ.
     *
     * @param factor L. Modified.
     * @param x modified
     * @param sign 1 or -1
     * @return false if the result is not positive definite; then L is worth nothing
     */
    static boolean update(double[] factor, double[] x, int d, int sign) {
        for (int k = 0; k < d; k++) {
            double old = factor[at(k, k)];
            double square = old * old + sign * x[k] * x[k];
            if (!(square > 0)) {
                return false;
            }
            double fresh = Math.sqrt(square);
            double c = fresh / old;
            double s = x[k] / old;
            factor[at(k, k)] = fresh;
            for (int i = k + 1; i < d; i++) {
                factor[at(i, k)] = (factor[at(i, k)] + sign * s * x[i]) / c;
                x[i] = c * x[i] - s * factor[at(i, k)];
            }
        }
        return true;
    }
}

package wbv.identify;

import org.ejml.data.Complex_F64;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;

/** Monic polynomials {@code x^n + p_1 x^(n-1) + … + p_n}, held as {@code p_1 … p_n}. */
final class Polynomial {

    private Polynomial() {}

    /**
     * All roots, as eigenvalues of the companion matrix.
     *
     * @param p coefficients after the leading 1. Not modified.
     */
    static Complex_F64[] roots(double[] p) {
        int n = p.length;
        if (n == 0) {
            return new Complex_F64[0];
        }
        DMatrixRMaj companion = new DMatrixRMaj(n, n);
        for (int i = 0; i < n; i++) {
            companion.set(0, i, -p[i]);
            if (i > 0) {
                companion.set(i, i - 1, 1);
            }
        }
        EigenDecomposition_F64<DMatrixRMaj> eigen = DecompositionFactory_DDRM.eig(n, false);
        if (!eigen.decompose(companion)) {
            throw new ArithmeticException("roots of a polynomial of degree " + n + " were not found");
        }
        Complex_F64[] roots = new Complex_F64[n];
        for (int i = 0; i < n; i++) {
            roots[i] = eigen.getEigenvalue(i);
        }
        return roots;
    }

    /**
     * Whether all roots lie inside the circle of a radius, by the step-down recursion (Jury; Levinson backwards). Allocates
     * nothing.
     *
     * @param p      coefficients after the leading 1. Not modified.
     * @param radius &gt; 0
     * @param work   as long as p. Modified.
     */
    static boolean inside(double[] p, double radius, double[] work) {
        double power = 1;
        for (int i = 0; i < p.length; i++) {
            power /= radius;
            work[i] = p[i] * power;
        }
        for (int m = p.length; m > 0; m--) {
            double k = work[m - 1];
            if (!(Math.abs(k) < 1)) {
                return false;
            }
            double scale = 1 / (1 - k * k);
            int last = m - 2;
            for (int i = 0; i <= last - i; i++) {
                double front = work[i];
                double back = work[last - i];
                work[i] = (front - k * back) * scale;
                work[last - i] = (back - k * front) * scale;
            }
        }
        return true;
    }
}

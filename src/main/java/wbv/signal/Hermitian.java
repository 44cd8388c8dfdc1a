package wbv.signal;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * A Hermitian matrix G = A + jB of n by n, as the real symmetric matrix {@code [A -B; B A]} of 2n by 2n, which has the same
 * eigenvalues, each twice, and whose inverse is that of G in the same form.
 */
final class Hermitian {

    private final int n;
    private final DMatrixRMaj real;
    private final DMatrixRMaj work;
    private final DMatrixRMaj inverse;
    private final LinearSolverDense<DMatrixRMaj> solver;
    private final EigenDecomposition_F64<DMatrixRMaj> eigen;

    Hermitian(int n) {
        this.n = n;
        real = new DMatrixRMaj(2 * n, 2 * n);
        work = new DMatrixRMaj(2 * n, 2 * n);
        inverse = new DMatrixRMaj(2 * n, 2 * n);
        solver = LinearSolverFactory_DDRM.symmPosDef(2 * n);
        eigen = DecompositionFactory_DDRM.eig(2 * n, true, true);
    }

    /** Sets entry (i, j) and its mirror (j, i). */
    void set(int i, int j, double re, double im) {
        place(i, j, re, i == j ? 0 : im);
        place(j, i, re, i == j ? 0 : -im);
    }

    private void place(int i, int j, double re, double im) {
        real.set(i, j, re);
        real.set(n + i, n + j, re);
        real.set(i, n + j, -im);
        real.set(n + i, j, im);
    }

    /**
     * Inverts the matrix.
     *
     * @return false if it is singular, or not positive
     */
    boolean invert() {
        work.setTo(real);
        if (!solver.setA(work)) {
            return false;
        }
        solver.invert(inverse);
        for (int i = 0; i < n; i++) {
            if (!(inverse.get(i, i) > 0) || Double.isInfinite(inverse.get(i, i))) {
                return false;
            }
        }
        return true;
    }

    /** Real part of entry (i, j) of the inverse. */
    double inverseRe(int i, int j) {
        return inverse.get(i, j);
    }

    /** Imaginary part of entry (i, j) of the inverse. */
    double inverseIm(int i, int j) {
        return inverse.get(n + i, j);
    }

    /**
     * The eigenvector of the smallest eigenvalue, of length 1 and any phase.
     *
     * @param v real parts, then imaginary parts, 2n in all. Modified.
     * @return whether one was found
     */
    boolean smallest(double[] v) {
        work.setTo(real);
        if (!eigen.decompose(work)) {
            return false;
        }
        int least = 0;
        for (int i = 1; i < 2 * n; i++) {
            if (eigen.getEigenvalue(i).real < eigen.getEigenvalue(least).real) {
                least = i;
            }
        }
        DMatrixRMaj vector = eigen.getEigenVector(least);
        for (int i = 0; i < 2 * n; i++) {
            v[i] = vector.get(i, 0);
        }
        return true;
    }
}

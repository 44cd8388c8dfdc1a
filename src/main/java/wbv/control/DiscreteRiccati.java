package wbv.control;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.NormOps_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * The stabilising solution of the discrete algebraic Riccati equation {@code X = Aᵀ X (I + G X)⁻¹ A + H}, with G = B R⁻¹ Bᵀ, by
 * structure-preserving doubling (Chu, Fan, Lin and Wang 2004):
 *
 * <pre>
 * W = I + G H,  A ← A W⁻¹ A,  G ← G + A W⁻¹ G Aᵀ,  H ← H + Aᵀ H W⁻¹ A
 * </pre>
 *
 * H converges to X quadratically. One doubling is one call of {@link #advance}, so that a controller can go on with its samples in
 * between; after the first of them nothing is allocated.
 */
public final class DiscreteRiccati {

    /** Doublings after which an equation without a stabilising solution is given up; 2⁶⁰ samples are enough for any that has one. */
    private static final int MOST = 60;
    /** Share of a solution that the last doubling may change. */
    private static final double CONVERGED = 1e-13;

    private final int n;
    private final DMatrixRMaj a;
    private final DMatrixRMaj g;
    private final DMatrixRMaj h;
    private final DMatrixRMaj w;
    private final DMatrixRMaj inverse;
    private final DMatrixRMaj p;
    private final DMatrixRMaj q;
    private final DMatrixRMaj r;
    private final LinearSolverDense<DMatrixRMaj> solver;
    private int doublings;
    private boolean solved;
    private boolean failed;

    /**
     * Room for equations of one order.
     *
     * @param n order, &gt;= 1
     */
    public DiscreteRiccati(int n) {
        this.n = n;
        a = new DMatrixRMaj(n, n);
        g = new DMatrixRMaj(n, n);
        h = new DMatrixRMaj(n, n);
        w = new DMatrixRMaj(n, n);
        inverse = new DMatrixRMaj(n, n);
        p = new DMatrixRMaj(n, n);
        q = new DMatrixRMaj(n, n);
        r = new DMatrixRMaj(n, n);
        solver = LinearSolverFactory_DDRM.lu(n);
    }

    /**
     * A new equation.
     *
     * @param a0 A, n by n. Not modified.
     * @param g0 G, n by n, symmetric, &gt;= 0 but in a game against what shakes. Not modified.
     * @param h0 H, n by n, symmetric, &gt;= 0. Not modified.
     */
    public void begin(DMatrixRMaj a0, DMatrixRMaj g0, DMatrixRMaj h0) {
        a.setTo(a0);
        g.setTo(g0);
        h.setTo(h0);
        doublings = 0;
        solved = false;
        failed = false;
    }

    /**
     * One doubling.
     *
     * @return whether the work is over, with a solution or without one
     */
    public boolean advance() {
        if (solved || failed) {
            return true;
        }
        CommonOps_DDRM.mult(g, h, w);
        for (int i = 0; i < n; i++) {
            w.add(i, i, 1);
        }
        if (!solver.setA(w) || ++doublings > MOST) {
            failed = true;
            return true;
        }
        solver.invert(inverse);
        CommonOps_DDRM.mult(inverse, a, p);       // W⁻¹ A
        CommonOps_DDRM.mult(h, p, q);             // H W⁻¹ A
        CommonOps_DDRM.multTransA(a, q, r);       // Aᵀ H W⁻¹ A
        symmetrise(r);
        double step = NormOps_DDRM.fastNormF(r);
        CommonOps_DDRM.addEquals(h, r);
        failed = !Double.isFinite(step);
        solved = !failed && step <= CONVERGED * NormOps_DDRM.fastNormF(h);
        CommonOps_DDRM.mult(inverse, g, q);       // W⁻¹ G
        CommonOps_DDRM.multTransB(q, a, r);       // W⁻¹ G Aᵀ
        CommonOps_DDRM.mult(a, r, q);
        symmetrise(q);
        CommonOps_DDRM.addEquals(g, q);
        CommonOps_DDRM.mult(a, p, q);             // A W⁻¹ A
        a.setTo(q);
        return solved || failed;
    }

    /** Whether there is a stabilising solution and it is found. */
    public boolean solved() {
        return solved;
    }

    /**
     * X, symmetric. The object is the solver's and changes with the next equation.
     *
     * @throws IllegalStateException if it is not {@link #solved()}
     */
    public DMatrixRMaj solution() {
        if (!solved) {
            throw new IllegalStateException(
                    "the Riccati equation has no stabilising solution, or not yet (after " + doublings + " doublings)");
        }
        return h;
    }

    /** Frobenius norm of {@code Aᵀ X (I + G X)⁻¹ A + H - X} over that of X [1]: what a solution leaves. Allocates. */
    public static double residual(DMatrixRMaj a, DMatrixRMaj g, DMatrixRMaj h, DMatrixRMaj x) {
        int n = a.numRows;
        DMatrixRMaj w = CommonOps_DDRM.identity(n);
        CommonOps_DDRM.multAdd(g, x, w);
        DMatrixRMaj wa = new DMatrixRMaj(n, n);
        if (!CommonOps_DDRM.solve(w, a, wa)) {
            return Double.POSITIVE_INFINITY;
        }
        DMatrixRMaj xwa = new DMatrixRMaj(n, n);
        CommonOps_DDRM.mult(x, wa, xwa);
        DMatrixRMaj left = new DMatrixRMaj(n, n);
        CommonOps_DDRM.multTransA(a, xwa, left);
        CommonOps_DDRM.addEquals(left, h);
        CommonOps_DDRM.subtractEquals(left, x);
        return NormOps_DDRM.normF(left) / NormOps_DDRM.normF(x);
    }

    private static void symmetrise(DMatrixRMaj m) {
        for (int i = 0; i < m.numRows; i++) {
            for (int j = 0; j < i; j++) {
                double mean = (m.get(i, j) + m.get(j, i)) / 2;
                m.set(i, j, mean);
                m.set(j, i, mean);
            }
        }
    }
}

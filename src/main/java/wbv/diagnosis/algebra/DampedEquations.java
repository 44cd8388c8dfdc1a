package wbv.diagnosis.algebra;

import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * Symmetric equations as a step of least squares has them, {@code (C + λ diag C) s = g} (Marquardt 1963), of which some coordinates may be
 * held. They are scaled to a unit diagonal, so that coordinates of any unit are solved with the same care.
 */
public final class DampedEquations {

    /** What the unit diagonal is raised by, so that rounding leaves it positive. */
    private static final double RIDGE = 1e-12;
    /** The least that a diagonal is divided by. */
    private static final double LEAST = 1e-300;

    private DampedEquations() {}

    /**
     * s where nothing is held and nothing damped, n long, in whatever unit.
     *
     * @param c n by n, in whatever unit
     * @param g n long, likewise. Neither is modified.
     */
    public static double[] solve(double[][] c, double[] g) {
        return solve(c, g, new boolean[g.length], 0);
    }

    /**
     * s over the coordinates that are not held, n long, in whatever unit; 0 for those that are.
     *
     * @param c n by n, in whatever unit
     * @param g n long, likewise
     * @param held n
     * @param damping λ [1]. None is modified.
     */
    public static double[] solve(double[][] c, double[] g, boolean[] held, double damping) {
        int n = g.length;
        int[] free = IntStream.range(0, n).filter(i -> !held[i]).toArray();
        double[] out = new double[n];
        if (free.length == 0) {
            return out;
        }
        double[] size = new double[free.length];
        DMatrixRMaj a = new DMatrixRMaj(free.length, free.length);
        DMatrixRMaj b = new DMatrixRMaj(free.length, 1);
        for (int i = 0; i < free.length; i++) {
            size[i] = Math.sqrt(Math.max(c[free[i]][free[i]], LEAST));
        }
        for (int i = 0; i < free.length; i++) {
            for (int j = 0; j < free.length; j++) {
                a.set(i, j, c[free[i]][free[j]] / size[i] / size[j] + (i == j ? damping + RIDGE : 0));
            }
            b.set(i, g[free[i]] / size[i]);
        }
        DMatrixRMaj x = solved(a, b);
        for (int i = 0; i < free.length; i++) {
            out[free[i]] = x.get(i) / size[i];
        }
        return out;
    }

    /** By Cholesky's factors, or by the pseudoinverse where there are none. */
    private static DMatrixRMaj solved(DMatrixRMaj a, DMatrixRMaj b) {
        LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.symmPosDef(a.numRows);
        if (!solver.setA(a)) {
            solver = LinearSolverFactory_DDRM.pseudoInverse(true);
            solver.setA(a);
        }
        DMatrixRMaj out = new DMatrixRMaj(a.numRows, 1);
        solver.solve(b, out);
        return out;
    }
}

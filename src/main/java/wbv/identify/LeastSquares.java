package wbv.identify;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/** Normal equations of a linear least-squares problem, gathered row by row and solved with columns scaled to one length. */
final class LeastSquares {

    /** Part of the squared length of a column that keeps a direction without information at rest. */
    private static final double RIDGE = 1e-13;

    private final int n;
    private final double[] normal;
    private final double[] right;
    private final DMatrixRMaj scaled;

    /** @param n unknowns */
    LeastSquares(int n) {
        this.n = n;
        this.normal = new double[n * n];
        this.right = new double[n];
        this.scaled = new DMatrixRMaj(n, n);
    }

    void clear() {
        java.util.Arrays.fill(normal, 0);
        java.util.Arrays.fill(right, 0);
    }

    /**
     * Adds the equation {@code row · x = value}.
     *
     * @param row n long. Not modified.
     */
    void add(double[] row, double value) {
        for (int i = 0; i < n; i++) {
            double r = row[i];
            if (r != 0) {
                right[i] += r * value;
                int at = i * n;
                for (int j = 0; j <= i; j++) {
                    normal[at + j] += r * row[j];
                }
            }
        }
    }

    /**
     * Solves.
     *
     * @param damping added to the diagonal, as a share of it (Marquardt 1963), &gt;= 0
     * @return n numbers; 0 for columns that were all 0
     */
    double[] solve(double damping) {
        double[] x = new double[n];
        LinearSolverDense<DMatrixRMaj> solver = decomposed(damping);
        DMatrixRMaj b = new DMatrixRMaj(n, 1);
        for (int i = 0; i < n; i++) {
            b.set(i, 0, right[i] * scale(i));
        }
        DMatrixRMaj solution = new DMatrixRMaj(n, 1);
        solver.solve(b, solution);
        for (int i = 0; i < n; i++) {
            x[i] = solution.get(i, 0) * scale(i);
        }
        return x;
    }

    /** Inverse of the normal matrix; 0 in rows and columns of what was all 0. */
    DMatrixRMaj inverse() {
        LinearSolverDense<DMatrixRMaj> solver = decomposed(0);
        DMatrixRMaj inverse = new DMatrixRMaj(n, n);
        solver.invert(inverse);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                inverse.set(i, j, inverse.get(i, j) * scale(i) * scale(j));
            }
        }
        return inverse;
    }

    /** Diagonal of the inverse of the normal matrix. */
    double[] inverseDiagonal() {
        DMatrixRMaj inverse = inverse();
        double[] diagonal = new double[n];
        for (int i = 0; i < n; i++) {
            diagonal[i] = inverse.get(i, i);
        }
        return diagonal;
    }

    private double scale(int i) {
        double length = normal[i * n + i];
        return length > 0 ? 1 / Math.sqrt(length) : 0;
    }

    private LinearSolverDense<DMatrixRMaj> decomposed(double damping) {
        for (double ridge = RIDGE; ridge < 1; ridge *= 100) {
            for (int i = 0; i < n; i++) {
                for (int j = 0; j <= i; j++) {
                    double value = i == j ? 1 + damping + ridge : normal[i * n + j] * scale(i) * scale(j);
                    scaled.set(i, j, value);
                    scaled.set(j, i, value);
                }
            }
            LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.chol(n);
            if (solver.setA(scaled)) {
                return solver;
            }
        }
        throw new ArithmeticException("normal equations of " + n + " unknowns hold numbers that are not finite");
    }
}

package wbv.diagnosis.algebra;

import java.util.Optional;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.decomposition.TriangularSolver_DDRM;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.CholeskyDecomposition_F64;

/** Cholesky's factor of a symmetric positive definite matrix. Unlike EJML's solvers it holds no scratch, so that threads may share it. */
public final class SymmetricFactor {

    private final DMatrixRMaj lower;

    private SymmetricFactor(DMatrixRMaj lower) {
        this.lower = lower;
    }

    /**
     * The factor of a matrix; empty where it is not positive definite.
     *
     * @param matrix square. Not modified.
     */
    public static Optional<SymmetricFactor> of(DMatrixRMaj matrix) {
        CholeskyDecomposition_F64<DMatrixRMaj> cholesky = DecompositionFactory_DDRM.chol(matrix.numRows, true);
        return cholesky.decompose(matrix.copy()) ? Optional.of(new SymmetricFactor(cholesky.getT(null))) : Optional.empty();
    }

    /** The natural logarithm of the matrix' determinant, in that of its unit. */
    public double logDeterminant() {
        double sum = 0;
        for (int i = 0; i < lower.numRows; i++) {
            sum += 2 * Math.log(lower.get(i, i));
        }
        return sum;
    }

    /**
     * A⁻¹ b, as long as b, in its unit over that of A. A new array.
     *
     * @param b n long, of any unit. Not modified.
     */
    public double[] solve(double[] b) {
        double[] x = b.clone();
        TriangularSolver_DDRM.solveL(lower.data, x, x.length);
        TriangularSolver_DDRM.solveTranL(lower.data, x, x.length);
        return x;
    }
}

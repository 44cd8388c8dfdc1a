package wbv.body.simulate;

import org.apache.commons.math3.exception.MathRuntimeException;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Coordinates in which the step of a linear system is a turn and a decay of each mode by itself, x = V y: the modes of A where
 * they are distinct, the states themselves where two fall together.
 */
final class ModalBasis {

    /** V is refused where products with it and its inverse would lose more than half of all digits. */
    private static final double MOST_CONDITION = 1e7;

    /** x to y. */
    final DMatrixRMaj inverse;
    /** y to x. */
    final DMatrixRMaj vectors;

    private ModalBasis(DMatrixRMaj vectors, DMatrixRMaj inverse) {
        this.vectors = vectors;
        this.inverse = inverse;
    }

    /** @param a a state matrix. Not modified. */
    static ModalBasis of(DMatrixRMaj a) {
        int n = a.numRows;
        DMatrixRMaj v = new DMatrixRMaj(n, n);
        DMatrixRMaj inverse = new DMatrixRMaj(n, n);
        try {
            double[][] rows = new double[n][n];
            for (int i = 0; i < n; i++) {
                System.arraycopy(a.data, i * n, rows[i], 0, n);
            }
            v = new DMatrixRMaj(new EigenDecomposition(new Array2DRowRealMatrix(rows)).getV().getData());
        } catch (MathRuntimeException unsolved) {
            CommonOps_DDRM.setIdentity(v);
        }
        if (!CommonOps_DDRM.invert(v, inverse) || !(Math.sqrt(squares(v) * squares(inverse)) < MOST_CONDITION)) {
            return new ModalBasis(CommonOps_DDRM.identity(n), CommonOps_DDRM.identity(n));
        }
        return new ModalBasis(v, inverse);
    }

    private static double squares(DMatrixRMaj m) {
        double sum = 0;
        for (double value : m.data) {
            sum += value * value;
        }
        return sum;
    }

    /**
     * V⁻¹ M V.
     *
     * @param m Not modified.
     */
    DMatrixRMaj within(DMatrixRMaj m) {
        return product(inverse, product(m, vectors));
    }

    /**
     * V⁻¹ M, what inputs do to y.
     *
     * @param m Not modified.
     */
    DMatrixRMaj into(DMatrixRMaj m) {
        return product(inverse, m);
    }

    private static DMatrixRMaj product(DMatrixRMaj a, DMatrixRMaj b) {
        DMatrixRMaj out = new DMatrixRMaj(a.numRows, b.numCols);
        CommonOps_DDRM.mult(a, b, out);
        return out;
    }
}

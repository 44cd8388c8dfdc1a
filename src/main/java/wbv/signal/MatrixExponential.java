package wbv.signal;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/** exp(A) by Taylor's series after halving A until its norm is below one half, then squaring back. */
public final class MatrixExponential {

    private static final int TERMS = 24;

    private MatrixExponential() {}

    /**
     * The exponential of a matrix.
     *
     * @param a square. Not modified.
     * @return a new matrix
     * @throws IllegalArgumentException if it is not finite
     */
    public static DMatrixRMaj of(DMatrixRMaj a) {
        int halvings = 0;
        double norm = CommonOps_DDRM.elementMaxAbs(a) * a.numRows;
        if (!Double.isFinite(norm)) {
            throw new IllegalArgumentException("a matrix must be finite to have an exponential: its norm is " + norm);
        }
        while (norm > 0.5) {
            norm /= 2;
            halvings++;
        }
        DMatrixRMaj scaled = a.copy();
        CommonOps_DDRM.scale(Math.pow(2, -halvings), scaled);
        DMatrixRMaj sum = CommonOps_DDRM.identity(a.numRows);
        DMatrixRMaj term = CommonOps_DDRM.identity(a.numRows);
        DMatrixRMaj next = new DMatrixRMaj(a.numRows, a.numRows);
        for (int k = 1; k <= TERMS; k++) {
            CommonOps_DDRM.mult(1.0 / k, term, scaled, next);
            term.setTo(next);
            CommonOps_DDRM.addEquals(sum, term);
        }
        for (int k = 0; k < halvings; k++) {
            CommonOps_DDRM.mult(sum, sum, next);
            sum.setTo(next);
        }
        return sum;
    }
}

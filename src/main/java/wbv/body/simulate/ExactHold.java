package wbv.body.simulate;

import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The exact step of x' = A x + B u over time h, with u linear within the step (first-order hold), and its derivative to a
 * parameter on which A and B depend:
 *
 * <pre>  x(h) = E x(0) + B0 u(0) + B1 u(h),    E = φ0(Ah),  B0 = h (φ1 - φ2)(Ah) B,  B1 = h φ2(Ah) B</pre>
 *
 * with φ0 the exponential, φ1(z) = (e^z - 1)/z and φ2(z) = (e^z - 1 - z)/z². The functions come from their Taylor series at
 * A h / 2^s and s doublings (Higham 2008, ch. 10); each derivative is the same recursion differentiated.
 * Thesis: Eq. 2-42.
 */
final class ExactHold {

    private static final double SMALL = 0.5;
    /** Of the series at matrices no larger than that: the next would be below rounding, 0.5¹⁷/17! = 2e-20. */
    private static final int TERMS = 17;

    final DMatrixRMaj transition;
    final DMatrixRMaj before;
    final DMatrixRMaj after;

    private ExactHold(DMatrixRMaj transition, DMatrixRMaj before, DMatrixRMaj after) {
        this.transition = transition;
        this.before = before;
        this.after = after;
    }

    /**
     * The step and its derivatives.
     *
     * @param a  n by n. Not modified.
     * @param b n by m. Not modified.
     * @param h length of the step [s], &gt; 0
     * @param da derivative of A to each parameter, n by n each. Not modified.
     * @param db derivative of B likewise, n by m each
     * @return element 0 is the step, element 1 + i its derivative to parameter i
     */
    static ExactHold[] of(DMatrixRMaj a, DMatrixRMaj b, double h, DMatrixRMaj[] da, DMatrixRMaj[] db) {
        int n = a.numRows;
        int parameters = da.length;
        int doublings = Math.max(0, (int) Math.ceil(Math.log(norm(a) * h / SMALL) / Math.log(2)));
        double scale = h / Math.pow(2, doublings);
        Phi value = new Phi(n);
        DMatrixRMaj m = scaled(a, scale);
        DMatrixRMaj[] terms = terms(m);
        value.series(terms);
        Phi[] slopes = new Phi[parameters];
        for (int i = 0; i < parameters; i++) {
            slopes[i] = new Phi(n);
            slopes[i].seriesSlope(terms, m, scaled(da[i], scale));
        }
        for (int d = 0; d < doublings; d++) {
            for (Phi slope : slopes) {
                slope.doubleSlope(value);
            }
            value.doubleUp();
        }
        ExactHold[] out = new ExactHold[1 + parameters];
        out[0] = value.hold(b, h);
        for (int i = 0; i < parameters; i++) {
            ExactHold viaState = slopes[i].hold(b, h);
            ExactHold viaInput = value.hold(db[i], h);
            CommonOps_DDRM.addEquals(viaState.before, viaInput.before);
            CommonOps_DDRM.addEquals(viaState.after, viaInput.after);
            out[1 + i] = viaState;
        }
        return out;
    }

    /** M^k / k!, by k. */
    private static DMatrixRMaj[] terms(DMatrixRMaj m) {
        DMatrixRMaj[] out = new DMatrixRMaj[TERMS];
        out[0] = CommonOps_DDRM.identity(m.numRows);
        for (int k = 1; k < TERMS; k++) {
            out[k] = new DMatrixRMaj(m.numRows, m.numCols);
            CommonOps_DDRM.mult(1.0 / k, out[k - 1], m, out[k]);
        }
        return out;
    }

    private static double norm(DMatrixRMaj a) {
        double largest = 1e-300;
        for (int i = 0; i < a.numRows; i++) {
            double sum = 0;
            for (int j = 0; j < a.numCols; j++) {
                sum += Math.abs(a.get(i, j));
            }
            largest = Math.max(largest, sum);
        }
        return largest;
    }

    private static DMatrixRMaj scaled(DMatrixRMaj a, double factor) {
        DMatrixRMaj out = a.copy();
        CommonOps_DDRM.scale(factor, out);
        return out;
    }

    /** φ0, φ1, φ2 of one matrix, or their derivatives. */
    private static final class Phi {
        private final DMatrixRMaj e;
        private final DMatrixRMaj one;
        private final DMatrixRMaj two;

        Phi(int n) {
            e = new DMatrixRMaj(n, n);
            one = new DMatrixRMaj(n, n);
            two = new DMatrixRMaj(n, n);
        }

        /**
         * φ_j(M) = Σ_k M^k / (k+j)!.
         *
         * @param terms M^k / k!
         */
        void series(DMatrixRMaj[] terms) {
            for (int k = 0; k < TERMS; k++) {
                add(terms[k], k);
            }
        }

        /**
         * The derivative of the series along dM: dT_{k+1} = (dT_k M + T_k dM)/(k+1).
         *
         * @param terms T_k = M^k / k!
         */
        void seriesSlope(DMatrixRMaj[] terms, DMatrixRMaj m, DMatrixRMaj dm) {
            int n = m.numRows;
            int[] rows = filled(dm);
            DMatrixRMaj slope = new DMatrixRMaj(n, n);
            DMatrixRMaj next = new DMatrixRMaj(n, n);
            for (int k = 0; k < TERMS; k++) {
                add(slope, k);
                CommonOps_DDRM.mult(1.0 / (k + 1), slope, m, next);
                addProduct(1.0 / (k + 1), terms[k], dm, rows, next);
                slope.setTo(next);
            }
        }

        /** Rows that are not all zero: a parameter moves the forces on few bodies. */
        private static int[] filled(DMatrixRMaj dm) {
            return IntStream.range(0, dm.numRows).filter(row -> IntStream.range(0, dm.numCols).anyMatch(j -> dm.get(row, j) != 0))
                    .toArray();
        }

        /**
         * Adds a multiple of a product.
         *
         * @param rows of the second factor that are not zero
         * @param out Modified.
         */
        private static void addProduct(double factor, DMatrixRMaj left, DMatrixRMaj right, int[] rows, DMatrixRMaj out) {
            int n = out.numCols;
            for (int i = 0; i < out.numRows; i++) {
                for (int row : rows) {
                    double by = factor * left.data[i * left.numCols + row];
                    for (int j = 0; j < n; j++) {
                        out.data[i * n + j] += by * right.data[row * n + j];
                    }
                }
            }
        }

        private void add(DMatrixRMaj term, int k) {
            CommonOps_DDRM.addEquals(e, term);
            CommonOps_DDRM.addEquals(one, 1.0 / (k + 1), term);
            CommonOps_DDRM.addEquals(two, 1.0 / ((k + 1.0) * (k + 2.0)), term);
        }

        /** φ2(2M) = (φ1² + 2 φ2)/4, φ1(2M) = (E φ1 + φ1)/2, E(2M) = E². */
        void doubleUp() {
            DMatrixRMaj work = new DMatrixRMaj(e.numRows, e.numRows);
            CommonOps_DDRM.mult(0.25, one, one, work);
            CommonOps_DDRM.add(0.5, two, 1, work, two);
            CommonOps_DDRM.mult(0.5, e, one, work);
            CommonOps_DDRM.add(0.5, one, 1, work, one);
            CommonOps_DDRM.mult(e, e, work);
            e.setTo(work);
        }

        /** The derivative of {@link #doubleUp}, taken before the values themselves are doubled. */
        void doubleSlope(Phi value) {
            DMatrixRMaj work = new DMatrixRMaj(e.numRows, e.numRows);
            CommonOps_DDRM.mult(0.25, one, value.one, work);
            CommonOps_DDRM.multAdd(0.25, value.one, one, work);
            CommonOps_DDRM.add(0.5, two, 1, work, two);
            CommonOps_DDRM.mult(0.5, e, value.one, work);
            CommonOps_DDRM.multAdd(0.5, value.e, one, work);
            CommonOps_DDRM.add(0.5, one, 1, work, one);
            CommonOps_DDRM.mult(e, value.e, work);
            CommonOps_DDRM.multAdd(value.e, e, work);
            e.setTo(work);
        }

        ExactHold hold(DMatrixRMaj b, double h) {
            DMatrixRMaj after = new DMatrixRMaj(b.numRows, b.numCols);
            DMatrixRMaj before = new DMatrixRMaj(b.numRows, b.numCols);
            CommonOps_DDRM.mult(h, two, b, after);
            CommonOps_DDRM.mult(h, one, b, before);
            CommonOps_DDRM.subtractEquals(before, after);
            return new ExactHold(e.copy(), before, after);
        }
    }
}

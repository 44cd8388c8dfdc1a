package wbv.filter;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/** Moments of the extended Kalman filter: exact derivatives at the mean. */
final class Linearised implements Moments {

    private static final long serialVersionUID = 1;

    private final BodyModel model;
    private final double decay;
    private final double[] row;
    private final DMatrixRMaj f;
    private final DMatrixRMaj h;
    private final DMatrixRMaj keep;
    private final DMatrixRMaj work;
    private double variance;

    /** @param model the filter's own, with slopes, set at the mean when called  @param decay of the offset over one sample */
    Linearised(BodyModel model, double decay) {
        int n = model.size();
        this.model = model;
        this.decay = decay;
        this.row = new double[model.states()];
        this.f = new DMatrixRMaj(n, n);
        this.h = new DMatrixRMaj(1, n);
        this.keep = new DMatrixRMaj(n, n);
        this.work = new DMatrixRMaj(n, n);
    }

    @Override
    public void advance(double[] c, double[] xi, DMatrixRMaj p) {
        fillTransition(c, xi);
        model.advance(c, xi);
        xi[model.offset()] *= decay;
        CommonOps_DDRM.mult(f, p, work);
        CommonOps_DDRM.multTransB(work, f, p);
    }

    /** F = ∂g/∂ξ before ξ moves. */
    private void fillTransition(double[] c, double[] xi) {
        int states = model.states();
        for (int m = 0; m < model.modes(); m++) {
            double[] e = model.step(m).transition();
            for (int r = 0; r < 2; r++) {
                for (int k = 0; k < 2; k++) {
                    f.set(2 * m + r, 2 * m + k, e[2 * r + k]);
                    f.set(2 * m + r, states + 2 * m + k, model.forced(2 * m + r, k, c, xi));
                }
            }
        }
        for (int i = states; i < model.offset(); i++) {
            f.set(i, i, 1);
        }
        f.set(model.offset(), model.offset(), decay);
    }

    @Override
    public double measure(double[] xi, DMatrixRMaj p, DMatrixRMaj cross) {
        model.outputRow(row);
        for (int i = 0; i < row.length; i++) {
            h.set(0, i, row[i]);
        }
        for (int i = 0; i < model.parameters(); i++) {
            h.set(0, row.length + i, model.outputSlope(i, xi));
        }
        h.set(0, model.offset(), 1);
        CommonOps_DDRM.multTransB(p, h, cross);
        variance = Math.max(0, CommonOps_DDRM.dot(h, cross));
        return model.output(xi) + xi[model.offset()];
    }

    @Override
    public double variance() {
        return variance;
    }

    /** P = (I - KH) P (I - KH)ᵀ + K R Kᵀ (Joseph). */
    @Override
    public void reduce(DMatrixRMaj gain, double r, DMatrixRMaj p) {
        CommonOps_DDRM.mult(-1, gain, h, keep);
        for (int i = 0; i < keep.numRows; i++) {
            keep.add(i, i, 1);
        }
        CommonOps_DDRM.mult(keep, p, work);
        CommonOps_DDRM.multTransB(work, keep, p);
        CommonOps_DDRM.multAddTransB(r, gain, gain, p);
    }
}

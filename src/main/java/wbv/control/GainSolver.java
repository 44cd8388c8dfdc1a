package wbv.control;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/** Gains out of solutions of Riccati's equations. */
final class GainSolver {

    private static final int N = SeatModel.N;
    private static final int SENSORS = SeatModel.SENSORS;

    private final LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.lu(N);
    private final DMatrixRMaj w = new DMatrixRMaj(N, N);
    private final DMatrixRMaj inverse = new DMatrixRMaj(N, N);
    private final DMatrixRMaj product = new DMatrixRMaj(N, N);
    private final DMatrixRMaj bx = new DMatrixRMaj(1, N);
    private final DMatrixRMaj pc = new DMatrixRMaj(N, SENSORS);
    private final DMatrixRMaj s = new DMatrixRMaj(SENSORS, SENSORS);

    /**
     * {@code k = F² bᵀ X (I + G X)⁻¹ a}: the force is minus k times the states.
     *
     * @param k 1 by N. Modified.
     */
    void control(SeatModel model, DMatrixRMaj x, DMatrixRMaj g, DMatrixRMaj k) {
        CommonOps_DDRM.mult(g, x, w);
        invert();
        CommonOps_DDRM.mult(inverse, model.a(), product);
        CommonOps_DDRM.multTransA(model.b(), x, bx);
        CommonOps_DDRM.mult(model.force() * model.force(), bx, product, k);
    }

    /**
     * {@code l = P cᵀ (c P cᵀ + R)⁻¹}: how states are corrected by what the sensors read.
     *
     * @param l N by {@value SeatModel#SENSORS}. Modified.
     */
    void observe(SeatModel model, DMatrixRMaj p, DMatrixRMaj l) {
        CommonOps_DDRM.multTransB(p, model.c(), pc);
        CommonOps_DDRM.mult(model.c(), pc, s);
        for (int i = 0; i < SENSORS; i++) {
            s.add(i, i, SeatModel.SENSOR_NOISE[i] * SeatModel.SENSOR_NOISE[i]);
        }
        CommonOps_DDRM.invert(s);
        CommonOps_DDRM.mult(pc, s, l);
    }

    /**
     * {@code m (I - share p q)⁻¹}.
     *
     * @param m rows by N. Modified.
     * @param into likewise. Modified.
     */
    void divide(DMatrixRMaj m, double share, DMatrixRMaj p, DMatrixRMaj q, DMatrixRMaj into) {
        CommonOps_DDRM.mult(-share, p, q, w);
        invert();
        CommonOps_DDRM.mult(m, inverse, into);
    }

    private void invert() {
        for (int i = 0; i < N; i++) {
            w.add(i, i, 1);
        }
        solver.setA(w);
        solver.invert(inverse);
    }
}

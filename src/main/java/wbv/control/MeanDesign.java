package wbv.control;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/** The force that costs least in the mean, by the linear quadratic Gaussian design: two Riccati equations, one after the other. */
final class MeanDesign implements SeatDesign {

    private static final int N = SeatModel.N;

    private enum Phase { GAIN, OBSERVER, OVER }

    private final SeatModel model;
    private final double damping;
    private final DiscreteRiccati riccati = new DiscreteRiccati(N);
    private final GainSolver solver = new GainSolver();
    private final DMatrixRMaj transposed = new DMatrixRMaj(N, N);
    private final DMatrixRMaj k = new DMatrixRMaj(1, N);
    private final DMatrixRMaj l = new DMatrixRMaj(N, SeatModel.SENSORS);
    private Phase phase = Phase.OVER;

    /** @param damping that is always there, which the force comes on top of [N·s/m] */
    MeanDesign(SeatModel model, double damping) {
        this.model = model;
        this.damping = damping;
    }

    @Override
    public void begin(SitterSource sitter) {
        model.seat(sitter);
        model.damp(damping);
        riccati.begin(model.a(), model.pull(), model.cost());
        phase = Phase.GAIN;
    }

    @Override
    public boolean advance() {
        if (phase == Phase.OVER || !riccati.advance()) {
            return phase == Phase.OVER;
        }
        if (phase == Phase.GAIN && riccati.solved()) {
            solver.control(model, riccati.solution(), model.pull(), k);
            CommonOps_DDRM.transpose(model.a(), transposed);
            riccati.begin(transposed, model.sight(), model.noise());
            phase = Phase.OBSERVER;
            return false;
        }
        if (riccati.solved()) {
            solver.observe(model, riccati.solution(), l);
        }
        phase = Phase.OVER;
        return true;
    }

    @Override
    public boolean ready() {
        return phase == Phase.OVER && riccati.solved();
    }

    @Override
    public DMatrixRMaj foresight() {
        return model.a();
    }

    @Override
    public DMatrixRMaj gain() {
        return k;
    }

    @Override
    public DMatrixRMaj correction() {
        return l;
    }
}

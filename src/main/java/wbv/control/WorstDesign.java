package wbv.control;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The force that costs least where floor, friction and sensors do their worst: the H∞ design. Of all controllers it has nearly the
 * least γ, where {@code Σ cost <= γ² Σ (disturbance over its deviation)²} whatever the disturbances do. For one γ that takes two
 * Riccati equations, one for what lies ahead and one for what was observed, and a bound on both together (Doyle, Glover, Khargonekar
 * and Francis 1989; sampled, as a game: Whittle 1990, Başar and Bernhard 1995):
 *
 * <pre>
 * X = aᵀ X (I + (pull - noise/γ²) X)⁻¹ a + cost,           noise X &lt; γ²
 * P = a P (I + (sight - cost/γ²) P)⁻¹ aᵀ + noise,          P' X &lt; γ²,  P' = (P⁻¹ + sight)⁻¹
 * </pre>
 *
 * with {@code <} of the greatest eigenvalue. The force is that of X for the states that would be worst, {@code (I - P' X/γ²)⁻¹} times
 * the observed ones, and the observer foresees {@code (I - P' cost/γ²)⁻¹} times them. γ² is found by bisection.
 */
final class WorstDesign implements SeatDesign {

    private static final int N = SeatModel.N;
    /** Ratio of a γ² that is to be had to one that is not at which the search ends. */
    private static final double NEAR = 1.1;
    /** Times the least γ² found, since gains at the least itself are without bounds; assumed. */
    private static final double BACK = 1.2;
    /** Ratio of one γ² to the next until there is one of either kind. */
    private static final double STRIDE = 4;
    /** Trials after which a search is given up; bisection from a stride to {@link #NEAR} takes four. */
    private static final int MOST = 60;

    private enum Phase { AHEAD, OBSERVED, OVER }

    private final SeatModel model;
    private final double damping;
    private final DiscreteRiccati riccati = new DiscreteRiccati(N);
    private final GainSolver solver = new GainSolver();
    private final DMatrixRMaj transposed = new DMatrixRMaj(N, N);
    private final DMatrixRMaj game = new DMatrixRMaj(N, N);
    private final DMatrixRMaj x = new DMatrixRMaj(N, N);
    private final DMatrixRMaj p = new DMatrixRMaj(N, N);
    private final DMatrixRMaj seen = new DMatrixRMaj(SeatModel.SENSORS, N);
    private final DMatrixRMaj root = new DMatrixRMaj(N, N);
    private final DMatrixRMaj half = new DMatrixRMaj(N, N);
    private final DMatrixRMaj foreseen = new DMatrixRMaj(N, N);
    private final DMatrixRMaj certain = new DMatrixRMaj(1, N);
    private final DMatrixRMaj k = new DMatrixRMaj(1, N);
    private final DMatrixRMaj l = new DMatrixRMaj(N, SeatModel.SENSORS);
    private Phase phase = Phase.OVER;
    private boolean last;
    private boolean ready;
    private int trials;
    private double square = 1;
    private double possible;
    private double impossible;

    /** @param damping that is always there, which the force comes on top of [N·s/m] */
    WorstDesign(SeatModel model, double damping) {
        this.model = model;
        this.damping = damping;
    }

    @Override
    public void begin(SitterSource sitter) {
        model.seat(sitter);
        model.damp(damping);
        CommonOps_DDRM.transpose(model.a(), transposed);
        possible = Double.POSITIVE_INFINITY;
        impossible = 0;
        trials = 0;
        last = false;
        ready = false;
        attempt(square);
    }

    /** γ² of the last design. */
    double square() {
        return square;
    }

    private void attempt(double next) {
        square = next;
        trials++;
        CommonOps_DDRM.add(1, model.pull(), -1 / square, model.noise(), game);
        riccati.begin(model.a(), game, model.cost());
        phase = Phase.AHEAD;
    }

    @Override
    public boolean advance() {
        if (phase == Phase.OVER || !riccati.advance()) {
            return phase == Phase.OVER;
        }
        if (phase == Phase.AHEAD) {
            if (riccati.solved() && bounded(riccati.solution(), model.noise())) {
                x.setTo(riccati.solution());
                CommonOps_DDRM.add(1, model.sight(), -1 / square, model.cost(), game);
                riccati.begin(transposed, game, model.noise());
                phase = Phase.OBSERVED;
            } else {
                judge(false);
            }
        } else {
            judge(riccati.solved() && observed(riccati.solution()));
        }
        return phase == Phase.OVER;
    }

    private boolean observed(DMatrixRMaj solution) {
        if (!factor(solution)) {
            return false;
        }
        solver.observe(model, solution, l);
        CommonOps_DDRM.mult(model.c(), solution, seen);
        CommonOps_DDRM.mult(-1, l, seen, p);
        CommonOps_DDRM.addEquals(p, solution);
        return bounded(p, x);
    }

    private void judge(boolean found) {
        if (last || trials > MOST) {
            ready = found;
            phase = Phase.OVER;
            if (found) {
                finish();
            }
            return;
        }
        if (found) {
            possible = square;
        } else {
            impossible = square;
        }
        if (impossible == 0) {
            attempt(square / STRIDE);
        } else if (Double.isInfinite(possible)) {
            attempt(square * STRIDE);
        } else if (possible / impossible > NEAR) {
            attempt(Math.sqrt(possible * impossible));
        } else {
            last = true;
            attempt(BACK * possible);
        }
    }

    private void finish() {
        CommonOps_DDRM.add(1, model.pull(), -1 / square, model.noise(), game);
        solver.control(model, x, game, certain);
        solver.divide(certain, 1 / square, p, x, k);
        solver.divide(model.a(), 1 / square, p, model.cost(), foreseen);
    }

    /** Whether both are &gt; 0 and {@code first second < γ²}: I - rootᵀ second root/γ² has a root too, if first = root rootᵀ. */
    private boolean bounded(DMatrixRMaj first, DMatrixRMaj second) {
        if (!factor(first)) {
            return false;
        }
        CommonOps_DDRM.mult(second, root, half);
        CommonOps_DDRM.multTransA(-1 / square, root, half, game);
        for (int i = 0; i < N; i++) {
            game.add(i, i, 1);
        }
        return factor(game);
    }

    /**
     * Cholesky's lower triangle, in {@link #root}.
     *
     * @return whether there is one
     */
    private boolean factor(DMatrixRMaj m) {
        root.zero();
        for (int j = 0; j < N; j++) {
            for (int i = j; i < N; i++) {
                double sum = m.get(i, j);
                for (int n = 0; n < j; n++) {
                    sum -= root.get(i, n) * root.get(j, n);
                }
                if (i == j && !(sum > 0)) {
                    return false;
                }
                root.set(i, j, i == j ? Math.sqrt(sum) : sum / root.get(j, j));
            }
        }
        return true;
    }

    @Override
    public boolean ready() {
        return phase == Phase.OVER && ready;
    }

    @Override
    public DMatrixRMaj foresight() {
        return foreseen;
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

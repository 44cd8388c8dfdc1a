package wbv.body;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;

/**
 * A structure with laws set free on a base acceleration: the linear part steps exactly ({@link ExactHold}), each law is solved
 * implicitly at the end of its step, so that stiff stops and almost rigid friction stay stable. With sensitivities, the
 * derivative of every law force to every parameter is carried along: those of the structure ({@link Structure#parameters}),
 * then those of the laws in their order.
 *
 * <p>Not for several threads at once.
 */
public final class FreeRun {

    private static final double TOLERANCE = 1e-9;
    private static final int ITERATIONS = 60;
    private static final int FRESH = 3;
    private static final double LEAST_GRADIENT = 0.05;
    private static final int SWEEPS = 40;
    private static final double LIMIT = 1e4;

    private final Structure structure;
    private final LawSlopes[] laws;
    private final double step;
    private final int states;
    private final int parameters;
    private final int[] ownOffset;
    private final double omega;
    private final double[] transition;
    private final double[][] before;
    private final double[][] after;
    private final ExactHold[] slopes;
    /** Displacement and velocity of the link of law i that a unit force of law j gives at the end of the step. */
    private final double[][] give;
    private final double[][] giveVelocity;

    private double[][] displacement;
    private double[][] velocity;
    private final LinkMotion[] motions;
    private final double[][] modulation;

    /**
     * @param step time between samples [s], &gt; 0
     * @param sensitivities whether to prepare for {@link #run} with sensitivities
     */
    public FreeRun(Structure structure, List<LawAt> laws, double step, boolean sensitivities) {
        this(structure, laws, step, sensitivities, new double[laws.size()][0]);
    }

    /** @param modulation what each law is multiplied by, by law and sample; empty where nothing modulates it. Not modified. */
    FreeRun(Structure structure, List<LawAt> laws, double step, boolean sensitivities, double[][] modulation) {
        this.structure = structure;
        this.modulation = modulation;
        this.laws = laws.stream().map(LawSlopes::new).toArray(LawSlopes[]::new);
        this.step = step;
        this.states = 2 * structure.bodies();
        this.omega = structure.balance();
        this.ownOffset = new int[this.laws.length];
        int count = structure.parameters();
        for (int i = 0; i < this.laws.length; i++) {
            ownOffset[i] = count;
            count += this.laws[i].parameters;
        }
        this.parameters = count;
        int linear = sensitivities ? structure.parameters() : 0;
        DMatrixRMaj[] da = new DMatrixRMaj[linear];
        DMatrixRMaj[] db = new DMatrixRMaj[linear];
        for (int p = 0; p < linear; p++) {
            da[p] = structure.stateSlope(p, omega);
            db[p] = structure.inputSlope(p);
        }
        this.slopes = ExactHold.of(structure.stateMatrix(omega), structure.inputMatrix(), step, da, db);
        this.transition = slopes[0].transition.data;
        this.before = columns(slopes[0].before);
        this.after = columns(slopes[0].after);
        int m = this.laws.length;
        give = new double[m][m];
        giveVelocity = new double[m][m];
        motions = new LinkMotion[m];
        for (int i = 0; i < m; i++) {
            for (int j = 0; j < m; j++) {
                double[] effect = after[structure.linkInput(this.laws[j].link)];
                give[i][j] = stretch(effect, this.laws[i].link);
                giveVelocity[i][j] = stretchRate(effect, this.laws[i].link);
            }
            motions[i] = new LinkMotion();
            motions[i].stiffness = structure.stiffness()[this.laws[i].link];
            motions[i].damping = structure.damping()[this.laws[i].link];
            motions[i].step = step;
        }
    }

    /**
     * What a run gave.
     *
     * @param force        force of each law [N], by law and sample
     * @param displacement of each law's link [m], by law and sample
     * @param velocity     of each law's link [m/s], by law and sample
     * @param slope        derivative of each law force, by law, parameter and sample; empty without sensitivities
     * @param diverged     first sample at which the motion left all bounds, -1 if it never did; from there everything is 0
     */
    public record Run(double[][] force, double[][] displacement, double[][] velocity, double[][][] slope, int diverged) { }

    /** Number of parameters that sensitivities are taken to: the structure's, then the laws'. */
    public int parameters() {
        return parameters;
    }

    /**
     * Runs from rest.
     *
     * @param acceleration of the base [m/s²], by axis and sample. Not modified.
     * @param bodyForce    known force on each body [N], by body and sample; an empty array for none. Not modified.
     */
    public Run run(double[][] acceleration, double[][] bodyForce, boolean sensitivities) {
        return run(acceleration, bodyForce, sensitivities, new double[parameters][0][]);
    }

    /** Runs from rest on a base that moves along one axis. @param acceleration [m/s²], by sample. Not modified. */
    public Run run(double[] acceleration, double[][] bodyForce, boolean sensitivities) {
        return run(new double[][] {acceleration}, bodyForce, sensitivities);
    }

    /**
     * Runs from rest, with the known forces depending on parameters too.
     *
     * @param forceSlope derivative of the known force to each parameter, by parameter, body and sample; no bodies where there is
     *                   none. May be longer than {@link #parameters}: the rest are parameters that act through the known force
     *                   alone. Not modified.
     */
    public Run run(double[][] acceleration, double[][] bodyForce, boolean sensitivities, double[][][] forceSlope) {
        int n = acceleration[0].length;
        int m = laws.length;
        displacement = new double[m][n];
        velocity = new double[m][n];
        double[][] force = new double[m][n];
        double[][][] slope = new double[sensitivities ? m : 0][forceSlope.length][n];
        double[] x = new double[states];
        double[] free = new double[states];
        double[] old = new double[states];
        double[] now = new double[m];
        double[] last = new double[m];
        double[] memory = new double[m];
        Optional<CarriedSlopes> carried = sensitivities
                ? Optional.of(new CarriedSlopes(this, slopes, slope, forceSlope, bodyForce.length > 0, n)) : Optional.empty();
        int diverged = -1;
        for (int j = 0; j + 1 < n && diverged < 0; j++) {
            System.arraycopy(x, 0, free, 0, states);
            advance(x, free, acceleration, j);
            for (int i = 0; i < m; i++) {
                add(free, before[structure.linkInput(laws[i].link)], now[i]);
            }
            for (int b = 0; b < bodyForce.length; b++) {
                int column = structure.bodyInput(b);
                add(free, before[column], bodyForce[b][j]);
                add(free, after[column], bodyForce[b][j + 1]);
            }
            for (int i = 0; i < m; i++) {
                double ahead = 2 * now[i] - last[i];   // where a force that goes on as it went would be: a good guess
                last[i] = now[i];
                now[i] = ahead;
            }
            solve(free, now, memory, j);
            System.arraycopy(x, 0, old, 0, states);
            System.arraycopy(free, 0, x, 0, states);
            for (int i = 0; i < m; i++) {
                add(x, after[structure.linkInput(laws[i].link)], now[i]);
            }
            for (int i = 0; i < m; i++) {
                place(motions[i], i, free, now, memory[i], j);
                displacement[i][j + 1] = motions[i].displacement;
                velocity[i][j + 1] = motions[i].velocity;
                force[i][j + 1] = now[i];
            }
            if (carried.isPresent()) {
                carried.get().step(old, last, now, acceleration, bodyForce, j);
            }
            for (int i = 0; i < m; i++) {
                memory[i] = laws[i].law.remember(motions[i]);
            }
            for (double value : x) {
                if (!(Math.abs(value) < LIMIT)) {
                    diverged = j + 1;
                }
            }
        }
        if (diverged >= 0) {
            for (int i = 0; i < m; i++) {
                java.util.Arrays.fill(force[i], diverged, n, 0);
                for (double[] row : sensitivities ? slope[i] : new double[0][]) {
                    java.util.Arrays.fill(row, diverged, n, 0);
                }
            }
        }
        return new Run(force, displacement, velocity, slope, diverged);
    }

    /** Solves every law at the end of the step, one after the other until nothing moves. */
    private void solve(double[] free, double[] now, double[] memory, int j) {
        int m = laws.length;
        for (int sweep = 0; sweep < (m == 1 ? 1 : SWEEPS); sweep++) {
            double moved = 0;
            for (int i = 0; i < m; i++) {
                place(motions[i], i, free, now, memory[i], j);
                double kept = now[i];
                now[i] = root(i, kept);
                moved = Math.max(moved, Math.abs(now[i] - kept) / (1 + Math.abs(now[i])));
            }
            if (moved < TOLERANCE) {
                return;
            }
        }
    }

    /** f = φ(r + g (f - f0), v + h (f - f0)) by secants, now and then a Newton step, kept within a bracket. */
    private double root(int i, double start) {
        LinkMotion motion = motions[i];
        Law law = laws[i].law;
        double r = motion.displacement - give[i][i] * start;
        double v = motion.velocity - giveVelocity[i][i] * start;
        double f = start;
        double low = Double.NEGATIVE_INFINITY;
        double high = Double.POSITIVE_INFINITY;
        double excess = excess(law, motion, i, r, v, f);
        double gradient = Double.NaN;
        for (int k = 0; k < ITERATIONS && !(Math.abs(excess) <= TOLERANCE * (1 + Math.abs(f))); k++) {
            if (excess > 0) {
                high = f;
            } else {
                low = f;
            }
            if (k % FRESH == 0) {
                double h = 1e-6 * (1 + Math.abs(f));
                gradient = (excess(law, motion, i, r, v, f + h) - excess) / h;
            }
            double next = gradient > LEAST_GRADIENT ? f - excess / gradient : f - excess;
            boolean bracketed = low > Double.NEGATIVE_INFINITY && high < Double.POSITIVE_INFINITY;
            if (bracketed && !(next > low && next < high)) {
                next = (low + high) / 2;
            }
            double there = excess(law, motion, i, r, v, next);
            gradient = next == f ? gradient : (there - excess) / (next - f);
            f = next;
            excess = there;
        }
        motion.displacement = r + give[i][i] * f;
        motion.velocity = v + giveVelocity[i][i] * f;
        return f;
    }

    private double excess(Law law, LinkMotion motion, int i, double r, double v, double f) {
        motion.displacement = r + give[i][i] * f;
        motion.velocity = v + giveVelocity[i][i] * f;
        return f - law.force(motion);
    }

    /** The motion of a law's link at the end of step j, given all law forces. */
    private void place(LinkMotion motion, int i, double[] free, double[] now, double memory, int j) {
        int link = laws[i].link;
        motion.time = (j + 1) * step;
        motion.before = displacement[i][j];
        motion.memory = memory;
        motion.modulation = modulation[i].length == 0 ? 1 : modulation[i][j + 1];
        motion.displacement = stretch(free, link);
        motion.velocity = stretchRate(free, link);
        for (int k = 0; k < now.length; k++) {
            motion.displacement += give[i][k] * now[k];
            motion.velocity += giveVelocity[i][k] * now[k];
        }
        if (laws[i].late()) {
            recall(motion, i, j + 1, laws[i].law.lateness());
        }
    }

    /** Fills in the motion of law i some time before sample index; at rest before the start. At least one sample ago. */
    void recall(LinkMotion motion, int i, int index, double ago) {
        motion.lateDisplacement = earlier(displacement[i], index, ago);
        motion.lateVelocity = earlier(velocity[i], index, ago);
    }

    private void advance(double[] x, double[] out, double[][] acceleration, int j) {
        for (int i = 0; i < states; i++) {
            double sum = 0;
            for (int axis = 0; axis < acceleration.length; axis++) {
                sum += before[axis][i] * acceleration[axis][j] + after[axis][i] * acceleration[axis][j + 1];
            }
            for (int k = 0; k < states; k++) {
                sum += transition[i * states + k] * x[k];
            }
            out[i] = sum;
        }
    }

    private static void add(double[] x, double[] column, double amount) {
        for (int i = 0; i < x.length; i++) {
            x[i] += column[i] * amount;
        }
    }

    Structure structure() {
        return structure;
    }

    /** Not a copy. */
    LawSlopes[] laws() {
        return laws;
    }

    /** Motion of law i's link at the end of the last step. Not a copy. */
    LinkMotion motion(int i) {
        return motions[i];
    }

    /** Displacement of law i's link at the end of a step by a unit of law k's force. */
    double give(int i, int k) {
        return give[i][k];
    }

    /** Velocity likewise. */
    double giveVelocity(int i, int k) {
        return giveVelocity[i][k];
    }

    /** Index of the first of law i's own parameters. */
    int ownOffset(int i) {
        return ownOffset[i];
    }

    /** A series as law i sees it at a sample, late. */
    double past(double[] series, int i, int index) {
        return earlier(series, index, laws[i].law.lateness());
    }

    /** A series some time before a sample, by a straight line between samples; 0 before the start. At least one sample ago. */
    private double earlier(double[] series, int index, double ago) {
        double at = index - Math.max(1, ago / step);
        int floor = (int) Math.floor(at);
        double share = at - floor;
        return floor < 0 ? 0 : series[floor] * (1 - share) + (floor + 1 < index ? series[floor + 1] * share : 0);
    }

    double stretch(double[] x, int link) {
        return structure.stretch(link).of(x, 0) / omega;
    }

    double stretchRate(double[] x, int link) {
        return structure.stretch(link).of(x, structure.bodies());
    }

    static double[][] columns(DMatrixRMaj matrix) {
        return IntStream.range(0, matrix.numCols)
                .mapToObj(j -> IntStream.range(0, matrix.numRows).mapToDouble(i -> matrix.get(i, j)).toArray())
                .toArray(double[][]::new);
    }
}

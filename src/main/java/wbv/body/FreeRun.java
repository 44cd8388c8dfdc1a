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

    /**
     * @param step time between samples [s], &gt; 0
     * @param sensitivities whether to prepare for {@link #run} with sensitivities
     */
    public FreeRun(Structure structure, List<LawAt> laws, double step, boolean sensitivities) {
        this.structure = structure;
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
                double[] effect = after[1 + this.laws[j].link];
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
     * @param acceleration of the base [m/s²], by sample. Not modified.
     * @param bodyForce    known force on each body [N], by body and sample; an empty array for none. Not modified.
     */
    public Run run(double[] acceleration, double[][] bodyForce, boolean sensitivities) {
        return run(acceleration, bodyForce, sensitivities, new double[parameters][0][]);
    }

    /**
     * Runs from rest, with the known forces depending on parameters too.
     *
     * @param forceSlope derivative of the known force to each parameter, by parameter, body and sample; no bodies where there is
     *                   none. May be longer than {@link #parameters}: the rest are parameters that act through the known force
     *                   alone. Not modified.
     */
    public Run run(double[] acceleration, double[][] bodyForce, boolean sensitivities, double[][][] forceSlope) {
        int n = acceleration.length;
        int m = laws.length;
        displacement = new double[m][n];
        velocity = new double[m][n];
        double[][] force = new double[m][n];
        double[][][] slope = new double[sensitivities ? m : 0][forceSlope.length][n];
        double[] x = new double[states];
        double[] free = new double[states];
        double[] now = new double[m];
        double[] memory = new double[m];
        Optional<Carried> carried = sensitivities ? Optional.of(new Carried(slope, forceSlope, n)) : Optional.empty();
        int diverged = -1;
        for (int j = 0; j + 1 < n && diverged < 0; j++) {
            System.arraycopy(x, 0, free, 0, states);
            advance(x, free, acceleration[j], acceleration[j + 1]);
            for (int i = 0; i < m; i++) {
                add(free, before[1 + laws[i].link], now[i]);
            }
            for (int b = 0; b < bodyForce.length; b++) {
                int column = 1 + structure.links() + b;
                add(free, before[column], bodyForce[b][j]);
                add(free, after[column], bodyForce[b][j + 1]);
            }
            double[] last = now.clone();
            solve(free, now, memory, j);
            double[] old = x.clone();
            System.arraycopy(free, 0, x, 0, states);
            for (int i = 0; i < m; i++) {
                add(x, after[1 + laws[i].link], now[i]);
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

    /** f = φ(r + g (f - f0), v + h (f - f0)) by Newton steps kept within a bracket. */
    private double root(int i, double start) {
        LinkMotion motion = motions[i];
        Law law = laws[i].law;
        double r = motion.displacement - give[i][i] * start;
        double v = motion.velocity - giveVelocity[i][i] * start;
        double f = start;
        double low = Double.NEGATIVE_INFINITY;
        double high = Double.POSITIVE_INFINITY;
        for (int k = 0; k < ITERATIONS; k++) {
            double excess = excess(law, motion, i, r, v, f);
            if (Math.abs(excess) <= TOLERANCE * (1 + Math.abs(f))) {
                break;
            }
            if (excess > 0) {
                high = f;
            } else {
                low = f;
            }
            double h = 1e-6 * (1 + Math.abs(f));
            double gradient = (excess(law, motion, i, r, v, f + h) - excess) / h;
            double next = gradient > 0.05 ? f - excess / gradient : f - excess;
            boolean bracketed = low > Double.NEGATIVE_INFINITY && high < Double.POSITIVE_INFINITY;
            if (bracketed && !(next > low && next < high)) {
                next = (low + high) / 2;
            }
            f = next;
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
        double at = index - Math.max(1, ago / step);
        int floor = (int) Math.floor(at);
        double share = at - floor;
        motion.lateDisplacement = floor < 0 ? 0 : displacement[i][floor] * (1 - share)
                + (floor + 1 < index ? displacement[i][floor + 1] * share : 0);
        motion.lateVelocity = floor < 0 ? 0 : velocity[i][floor] * (1 - share)
                + (floor + 1 < index ? velocity[i][floor + 1] * share : 0);
    }

    private void advance(double[] x, double[] out, double first, double second) {
        for (int i = 0; i < states; i++) {
            double sum = before[0][i] * first + after[0][i] * second;
            for (int k = 0; k < states; k++) {
                sum += transition[i * states + k] * x[k];
            }
            out[i] = sum;
        }
    }

    private static void multiply(double[] matrix, double[] x, double[] out) {
        int n = x.length;
        for (int i = 0; i < n; i++) {
            double sum = 0;
            for (int k = 0, at = i * n; k < n; k++) {
                sum += matrix[at + k] * x[k];
            }
            out[i] = sum;
        }
    }

    private static void add(double[] x, double[] column, double amount) {
        for (int i = 0; i < x.length; i++) {
            x[i] += column[i] * amount;
        }
    }

    private double stretch(double[] x, int link) {
        int a = structure.from()[link];
        return (x[structure.to()[link]] - (a < 0 ? 0 : x[a])) / omega;
    }

    private double stretchRate(double[] x, int link) {
        int a = structure.from()[link];
        int n = structure.bodies();
        return x[n + structure.to()[link]] - (a < 0 ? 0 : x[n + a]);
    }

    private static double[][] columns(DMatrixRMaj matrix) {
        return IntStream.range(0, matrix.numCols)
                .mapToObj(j -> IntStream.range(0, matrix.numRows).mapToDouble(i -> matrix.get(i, j)).toArray())
                .toArray(double[][]::new);
    }

    /** The derivatives of state, law forces and memories to every parameter, carried from step to step. */
    private final class Carried {
        private final LawSlopes.Past past = FreeRun.this::recall;
        private final double[][][] slope;
        private final double[][][] forceSlope;
        private final double[][] state;
        private final double[][] memory;
        private final double[][][] displacementSlope;
        private final double[][][] velocitySlope;
        private final double[] free = new double[states];
        private final double[] right = new double[laws.length];
        private final double[] stretched = new double[laws.length];
        private final double[] rate = new double[laws.length];
        private final double[][] matrix = new double[laws.length][laws.length];
        private final double[] beforeStretch = new double[laws.length];
        private final double[][][] beforeColumns = new double[structure.parameters()][][];
        private final double[][][] afterColumns = new double[structure.parameters()][][];

        Carried(double[][][] slope, double[][][] forceSlope, int n) {
            this.slope = slope;
            this.forceSlope = forceSlope;
            int count = forceSlope.length;
            state = new double[count][states];
            memory = new double[laws.length][count];
            boolean late = IntStream.range(0, laws.length).anyMatch(i -> laws[i].late());
            displacementSlope = new double[laws.length][count][late ? n : 0];
            velocitySlope = new double[laws.length][count][late ? n : 0];
            for (int p = 0; p < structure.parameters(); p++) {
                beforeColumns[p] = columns(slopes[1 + p].before);
                afterColumns[p] = columns(slopes[1 + p].after);
            }
        }

        void step(double[] old, double[] last, double[] now, double[] acceleration, double[][] bodyForce, int j) {
            int m = laws.length;
            for (int i = 0; i < m; i++) {
                laws[i].take(motions[i], past, i, j + 1);
            }
            for (int i = 0; i < m; i++) {
                for (int k = 0; k < m; k++) {
                    matrix[i][k] = (i == k ? 1 : 0) - laws[i].force[LawSlopes.DISPLACEMENT_NOW] * give[i][k]
                            - laws[i].force[LawSlopes.VELOCITY_NOW] * giveVelocity[i][k];
                }
            }
            for (int p = 0; p < forceSlope.length; p++) {
                parameter(p, old, last, now, acceleration, bodyForce, j);
            }
        }

        private void parameter(int p, double[] old, double[] last, double[] now, double[] acceleration, double[][] bodyForce, int j) {
            int m = laws.length;
            double[] s = state[p];
            multiply(transition, s, free);
            for (int i = 0; i < m; i++) {
                add(free, before[1 + laws[i].link], slope[i][p][j]);
                beforeStretch[i] = stretch(s, laws[i].link);
            }
            if (p < structure.parameters()) {
                addLinear(p, old, last, now, acceleration, bodyForce, j);
            }
            for (int b = 0; b < forceSlope[p].length; b++) {
                int column = 1 + structure.links() + b;
                add(free, before[column], forceSlope[p][b][j]);
                add(free, after[column], forceSlope[p][b][j + 1]);
            }
            for (int i = 0; i < m; i++) {
                double[] f = laws[i].force;
                stretched[i] = stretch(free, laws[i].link);
                rate[i] = stretchRate(free, laws[i].link);
                right[i] = f[LawSlopes.DISPLACEMENT_NOW] * stretched[i] + f[LawSlopes.VELOCITY_NOW] * rate[i]
                        + f[LawSlopes.DISPLACEMENT_BEFORE] * beforeStretch[i] + f[LawSlopes.MEMORY_BEFORE] * memory[i][p]
                        + direct(f, i, p);
                if (laws[i].late()) {
                    right[i] += f[LawSlopes.LATE_DISPLACEMENT] * past(displacementSlope[i][p], i, j + 1)
                            + f[LawSlopes.LATE_VELOCITY] * past(velocitySlope[i][p], i, j + 1);
                }
            }
            eliminate();
            for (int i = 0; i < m; i++) {
                slope[i][p][j + 1] = right[i];
                add(free, after[1 + laws[i].link], right[i]);
            }
            System.arraycopy(free, 0, s, 0, states);
            for (int i = 0; i < m; i++) {
                double[] z = laws[i].memory;
                double r = stretch(s, laws[i].link);
                double v = stretchRate(s, laws[i].link);
                memory[i][p] = z[LawSlopes.DISPLACEMENT_NOW] * r + z[LawSlopes.VELOCITY_NOW] * v
                        + z[LawSlopes.DISPLACEMENT_BEFORE] * beforeStretch[i] + z[LawSlopes.MEMORY_BEFORE] * memory[i][p]
                        + direct(z, i, p);
                if (laws[i].late()) {
                    displacementSlope[i][p][j + 1] = r;
                    velocitySlope[i][p][j + 1] = v;
                }
            }
        }

        /** What a parameter of the structure does through the step's own matrices. */
        private void addLinear(int p, double[] old, double[] last, double[] now, double[] acceleration, double[][] bodyForce, int j) {
            double[] de = slopes[1 + p].transition.data;
            double[] first = beforeColumns[p][0];
            double[] second = afterColumns[p][0];
            double u = acceleration[j];
            double v = acceleration[j + 1];
            int n = states;
            for (int i = 0; i < n; i++) {
                double sum = first[i] * u + second[i] * v;
                for (int k = 0, at = i * n; k < n; k++) {
                    sum += de[at + k] * old[k];
                }
                free[i] += sum;
            }
            for (int i = 0; i < laws.length; i++) {
                add(free, beforeColumns[p][1 + laws[i].link], last[i]);
                add(free, afterColumns[p][1 + laws[i].link], now[i]);
            }
            for (int b = 0; b < bodyForce.length; b++) {
                int column = 1 + structure.links() + b;
                add(free, beforeColumns[p][column], bodyForce[b][j]);
                add(free, afterColumns[p][column], bodyForce[b][j + 1]);
            }
        }

        /** The slope of law i to parameter p at unchanged motion. */
        private double direct(double[] of, int i, int p) {
            if (p == laws[i].link) {
                return of[LawSlopes.STIFFNESS];
            }
            if (p == structure.links() + laws[i].link) {
                return of[LawSlopes.DAMPING];
            }
            int own = p - ownOffset[i];
            return own >= 0 && own < laws[i].parameters ? of[LawSlopes.OWN + own] : 0;
        }

        private double past(double[] series, int i, int index) {
            double at = index - Math.max(1, laws[i].law.lateness() / step);
            int floor = (int) Math.floor(at);
            double share = at - floor;
            return floor < 0 ? 0 : series[floor] * (1 - share) + (floor + 1 < index ? series[floor + 1] * share : 0);
        }

        /** Solves the few coupled laws: right becomes the force slopes. */
        private void eliminate() {
            int m = laws.length;
            if (m == 1) {
                right[0] /= matrix[0][0];
                return;
            }
            double[][] a = new double[m][];
            for (int i = 0; i < m; i++) {
                a[i] = matrix[i].clone();
            }
            for (int c = 0; c < m; c++) {
                for (int i = c + 1; i < m; i++) {
                    double q = a[i][c] / a[c][c];
                    for (int k = c; k < m; k++) {
                        a[i][k] -= q * a[c][k];
                    }
                    right[i] -= q * right[c];
                }
            }
            for (int i = m - 1; i >= 0; i--) {
                for (int k = i + 1; k < m; k++) {
                    right[i] -= a[i][k] * right[k];
                }
                right[i] /= a[i][i];
            }
        }
    }
}

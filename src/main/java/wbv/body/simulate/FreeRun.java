package wbv.body.simulate;

import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import wbv.body.LawAt;
import wbv.body.Structure;
import wbv.body.law.Law;
import wbv.body.law.LinkMotion;

/**
 * A structure with laws set free on a base acceleration: the linear part steps exactly ({@link ExactHold}), each law is solved
 * implicitly at the end of its step, so that stiff stops and almost rigid friction stay stable. With sensitivities, the
 * derivative of every law force to every parameter is carried along: those of the structure ({@link Structure#parameters}) where
 * they are asked for, then those of the laws in their order.
 *
 * <p>A force is straight within a step, which one that jumps is not: where friction turns round, half a step of it is an impulse that a
 * mass on a spring forgets and a mass that only friction holds carries along. In parts, a step in which a force jumps is gone through again
 * in many short ones, and what is told of the force at its two ends is what has the same impulse at the same time.
 *
 * <p>Not for several threads at once.
 */
public final class FreeRun {

    /** What may be left of a force's balance, in parts of 1 N and the force. */
    private static final double TOLERANCE = 1e-10;
    private static final int ITERATIONS = 60;
    private static final int FRESH = 3;
    private static final double LEAST_GRADIENT = 0.05;
    private static final int SWEEPS = 40;
    /** Bound of velocities [m/s], and of displacements times the structure's balance; of bodies it is looked at every so many samples. */
    private static final double LIMIT = 1e4;
    private static final int OFTEN = 64;
    /** Parts of a step in which a force jumps. */
    private static final int PARTS = 8;
    /**
     * How often such a step, and the part of it in which the force still jumps, is divided: where springs hold all masses, and where they
     * do not and a jump has to be timed to a 512th of a step.
     */
    private static final int DIVISIONS = 1;
    private static final int DIVISIONS_OF_FREE = 3;
    /** What is a jump: a part of the greatest force so far by which a force is off the straight line through the two before. */
    private static final double JUMP = 0.1;

    private final Structure structure;
    private final LawSlopes[] laws;
    private final double step;
    private final int states;
    private final int parameters;
    private final int[] ownOffset;
    private final ModalStep linear;
    /** What makes displacements of a size with velocities, see {@link Structure#balance} [rad/s]. */
    private final double omega;
    private final ExactHold[] slopes;
    /** Displacement and velocity of a link at the end of the step but for the laws' forces then, by the first of its laws. */
    private final double[] reached;
    private final double[] passing;
    /** By law, how its balance changed with its force when it was found last; NaN before. */
    private final double[] gradients;
    /** By law: the other link by which it goes. */
    private final FollowedLink[] followed;
    /** Laws that have one motion, those of one link: they are found together. One that goes by another link is alone. */
    private final int[][] together;

    private double[][] displacement;
    private double[][] velocity;
    /** Time of sample 0 [s]. */
    private double since;
    /** How much later a sample is than its number says [s]. */
    private IntToDoubleFunction later = sample -> 0;
    private final LinkMotion[] motions;
    private double[][] modulation;
    private Lift lift;
    /** The same in short steps, by which one in which a force jumps is gone through. */
    private final Optional<FreeRun> parted;

    /**
     * A run in which no law is modulated.
     *
     * @param step time between samples [s], &gt; 0
     * @param sensitivities whether to prepare for {@link #run} with sensitivities
     */
    public FreeRun(Structure structure, List<LawAt> laws, double step, boolean sensitivities) {
        this(structure, laws, step, Sensitivities.all(sensitivities), new double[laws.size()][0]);
    }

    /**
     * @param modulation what each law is multiplied by, by law and sample; empty where nothing modulates it, or another link does. Not
     *                   modified.
     */
    FreeRun(Structure structure, List<LawAt> laws, double step, Sensitivities sensitivities, double[][] modulation) {
        this(structure, laws, step, sensitivities, modulation, 0, ModalBasis.of(structure.stateMatrix(structure.balance())));
    }

    /** One that goes in parts through every step in which a force jumps; not for laws that answer late. */
    static FreeRun inParts(Structure structure, List<LawAt> laws, double step, Sensitivities sensitivities, double[][] modulation) {
        boolean late = laws.stream().anyMatch(at -> at.law().lateness() > 0);
        boolean free = IntStream.range(0, structure.bodies()).anyMatch(body -> structure.unheld()[body]);
        return new FreeRun(structure, laws, step, sensitivities, modulation, late ? 0 : free ? DIVISIONS_OF_FREE : DIVISIONS,
                ModalBasis.of(structure.stateMatrix(structure.balance())));
    }

    /**
     * The same where time leaps ahead.
     *
     * @param ahead how much later a sample is than its number says [s]
     */
    FreeRun leaping(IntToDoubleFunction ahead) {
        later = ahead;
        return this;
    }

    /** The same where the lower ends of links are lifted. */
    FreeRun lifted(Lift by) {
        lift = by;
        parted.ifPresent(finer -> finer.lifted(by.ofLength(PARTS + 1)));
        return this;
    }

    private FreeRun(Structure structure, List<LawAt> laws, double step, Sensitivities sensitivities, double[][] modulation, int divisions,
            ModalBasis basis) {
        this.parted = divisions > 0
                ? Optional.of(new FreeRun(structure, laws, step / PARTS, sensitivities, modulation, divisions - 1, basis))
                : Optional.empty();
        this.structure = structure;
        this.modulation = modulation;
        this.laws = laws.stream().map(LawSlopes::new).toArray(LawSlopes[]::new);
        this.step = step;
        this.states = 2 * structure.bodies();
        this.omega = structure.balance();
        this.ownOffset = new int[this.laws.length];
        int count = structure.parameters() - sensitivities.from(structure.parameters());
        for (int i = 0; i < this.laws.length; i++) {
            ownOffset[i] = count;
            count += this.laws[i].parameters;
        }
        this.parameters = count;
        this.lift = Lift.none(structure.links(), 0);
        int own = sensitivities == Sensitivities.ALL ? structure.parameters() : 0;
        DMatrixRMaj[] da = new DMatrixRMaj[own];
        DMatrixRMaj[] db = new DMatrixRMaj[own];
        for (int p = 0; p < own; p++) {
            da[p] = structure.stateSlope(p, omega);
            db[p] = structure.inputSlope(p);
        }
        this.slopes = ExactHold.of(structure.stateMatrix(omega), structure.inputMatrix(), step, da, db);
        int m = this.laws.length;
        int[] links = laws.stream().mapToInt(LawAt::link).toArray();
        linear = new ModalStep(structure, basis, slopes[0], links);
        followed = laws.stream().map(at -> FollowedLink.of(at.law().modulator(), structure, linear, links)).toArray(FollowedLink[]::new);
        together = IntStream.range(0, m).filter(i -> first(i, links) == i)
                .mapToObj(i -> IntStream.range(i, m).filter(k -> first(k, links) == i).toArray()).toArray(int[][]::new);
        reached = new double[m];
        passing = new double[m];
        gradients = new double[m];
        motions = new LinkMotion[m];
        for (int i = 0; i < m; i++) {
            motions[i] = new LinkMotion();
            motions[i].stiffness = structure.stiffness()[this.laws[i].link];
            motions[i].damping = structure.damping()[this.laws[i].link];
            motions[i].step = step;
        }
    }

    /** The first law that a law is found together with. */
    private int first(int law, int[] links) {
        return followed[law].follows() ? law
                : IntStream.rangeClosed(0, law).filter(i -> links[i] == links[law] && !followed[i].follows()).findFirst().orElseThrow();
    }

    /**
     * What a run gave.
     *
     * @param force        force of each law [N], by law and sample
     * @param displacement of each law's link as the law sees it [m], by law and sample
     * @param velocity     likewise [m/s]
     * @param slope        derivative of each law force [N per the parameter's unit], by law, parameter and sample; empty without
     *                     sensitivities
     * @param diverged     first sample at which the motion left all bounds, -1 if it never did; from there everything is 0
     */
    public record Run(double[][] force, double[][] displacement, double[][] velocity, double[][][] slope, int diverged) {}

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

    /**
     * Runs from rest on a base that moves along one axis.
     *
     * @param acceleration [m/s²], by sample. Not modified.
     * @param bodyForce [N], by body and sample; an empty array for none. Not modified.
     */
    public Run run(double[] acceleration, double[][] bodyForce, boolean sensitivities) {
        return run(new double[][] {acceleration}, bodyForce, sensitivities);
    }

    /**
     * Runs from rest, with the known forces depending on parameters too.
     *
     * @param acceleration of the base [m/s²], by axis and sample. Not modified.
     * @param bodyForce known force on each body [N], by body and sample; an empty array for none. Not modified.
     * @param forceSlope derivative of the known force to each parameter [N per the parameter's unit], by parameter, body and sample; no
     *                   bodies where there is none. May be longer than {@link #parameters}: the rest are parameters that act through the
     *                   known force alone. Not modified.
     */
    public Run run(double[][] acceleration, double[][] bodyForce, boolean sensitivities, double[][][] forceSlope) {
        int n = acceleration[0].length;
        int m = laws.length;
        Way way = new Way(this, n, sensitivities, bodyForce.length, forceSlope, true);
        java.util.Arrays.fill(gradients, Double.NaN);
        int diverged = -1;
        for (int j = 0; j + 1 < n && diverged < 0; j++) {
            way.go(acceleration, bodyForce, modulation, j, later.applyAsDouble(j + 1));
            if (leavesBounds() || j % OFTEN == 0 && !(linear.largest(way.y) < LIMIT)) {
                diverged = j + 1;
            }
        }
        if (diverged >= 0) {
            for (int i = 0; i < m; i++) {
                java.util.Arrays.fill(way.force[i], diverged, n, 0);
                for (double[] row : sensitivities ? way.slope[i] : new double[0][]) {
                    java.util.Arrays.fill(row, diverged, n, 0);
                }
            }
        }
        return new Run(way.force, displacement, velocity, way.slope, diverged);
    }

    private boolean leavesBounds() {
        boolean out = false;
        for (LinkMotion motion : motions) {
            out |= !(Math.abs(motion.displacement) * omega < LIMIT && Math.abs(motion.velocity) < LIMIT);
        }
        return out;
    }

    /** Series of the same kind for the parts of a step. */
    private static double[][][] between(double[][][] series) {
        return java.util.Arrays.stream(series).map(each -> new double[each.length][PARTS + 1]).toArray(double[][][]::new);
    }

    /**
     * A straight line over a step into its parts.
     *
     * @param series nothing where empty
     * @param out Modified.
     */
    private static void between(double[] series, int j, double[] out) {
        for (int k = 0; k <= PARTS && series.length > 0; k++) {
            out[k] = series[j] + (series[j + 1] - series[j]) * k / PARTS;
        }
    }

    private static void between(double[][] series, int j, double[][] out) {
        for (int l = 0; l < series.length; l++) {
            between(series[l], j, out[l]);
        }
    }

    /** A run on its way: state, forces and memories, and what it has told so far. */
    private static final class Way {
        private final FreeRun run;
        private final double[][] force;
        private final double[][][] slope;
        /** The state as {@link ModalStep} keeps it, and room for the next. */
        private double[] y;
        private double[] next;
        /** The whole state before the last step. */
        private final double[] old;
        private final double[] now;
        private final double[] last;
        private final double[] memory;
        private final double[] before;
        private final double[] greatest;
        private final double[][][] forceSlope;
        private final Optional<CarriedSlopes> carried;
        private final Optional<Way> parts;
        private final double[][] shaken;
        private final double[][] pushed;
        private final double[][] modulated;
        private final double[][] begun;
        /** Whether it is the whole run's, and no part of a step's. */
        private final boolean whole;

        /** @param known how many bodies known forces act on */
        Way(FreeRun run, int samples, boolean sensitivities, int known, double[][][] forceSlope, boolean whole) {
            this.run = run;
            this.whole = whole;
            this.forceSlope = forceSlope;
            int m = run.laws.length;
            run.displacement = new double[m][samples];
            run.velocity = new double[m][samples];
            force = new double[m][samples];
            slope = new double[sensitivities ? m : 0][forceSlope.length][samples];
            y = new double[run.states];
            next = new double[run.states];
            old = new double[run.states];
            now = new double[m];
            last = new double[m];
            memory = new double[m];
            before = new double[m];
            greatest = new double[m];
            carried = sensitivities ? Optional.of(new CarriedSlopes(run, run.linear, run.slopes, slope, forceSlope, known > 0, samples))
                    : Optional.empty();
            parts = run.parted.map(finer -> new Way(finer, PARTS + 1, sensitivities, known, between(forceSlope), false));
            shaken = new double[run.structure.axes()][PARTS + 1];
            pushed = new double[known][PARTS + 1];
            modulated = new double[m][PARTS + 1];
            begun = new double[m][forceSlope.length];
        }

        /**
         * A step, in parts where a force jumps in it.
         *
         * @param since time at which the run's own begins [s]
         */
        void go(double[][] acceleration, double[][] bodyForce, double[][] modulation, int j, double since) {
            System.arraycopy(last, 0, before, 0, last.length);
            run.modulation = modulation;
            step(acceleration, bodyForce, j, since);
            boolean jumped = false;
            for (int i = 0; i < now.length; i++) {
                greatest[i] = Math.max(greatest[i], Math.abs(now[i]));
                jumped |= Math.abs(now[i] - (2 * last[i] - before[i])) > JUMP * greatest[i];
            }
            if (jumped && parts.isPresent()) {
                stepInParts(parts.get(), acceleration, bodyForce, modulation, j, since);
            } else {
                carried.ifPresent(it -> it.step(old, last, now, acceleration, bodyForce, j));
                for (int i = 0; i < now.length; i++) {
                    memory[i] = run.laws[i].law.remember(run.motions[i]);
                }
            }
        }

        private void step(double[][] acceleration, double[][] bodyForce, int j, double since) {
            int m = now.length;
            if (carried.isPresent() || parts.isPresent()) {
                run.linear.whole(y, now, old);
            }
            run.linear.advance(y, now, acceleration, bodyForce, j, next);
            double[] kept = y;
            y = next;
            next = kept;
            for (int i = 0; i < m; i++) {
                double ahead = 2 * now[i] - last[i];
                last[i] = now[i];
                now[i] = ahead;
            }
            run.since = since;
            run.solve(y, now, memory, j);
            for (int i = 0; i < m; i++) {
                run.displacement[i][j + 1] = run.motions[i].displacement;
                run.velocity[i][j + 1] = run.motions[i].velocity;
                force[i][j + 1] = now[i];
            }
        }

        /** The step just made anew. */
        private void stepInParts(Way parts, double[][] acceleration, double[][] bodyForce, double[][] modulation, int j, double since) {
            int m = now.length;
            parts.run.linear.kept(old, last, parts.y);
            java.util.Arrays.fill(parts.run.gradients, Double.NaN);
            between(acceleration, j, shaken);
            between(bodyForce, j, pushed);
            between(run.lift.height(), j, parts.run.lift.height());
            between(run.lift.rate(), j, parts.run.lift.rate());
            for (int i = 0; i < m; i++) {
                modulated[i] = modulation[i].length == 0 ? modulation[i] : modulated[i].length == 0 ? new double[PARTS + 1] : modulated[i];
                between(modulation[i], j, modulated[i]);
            }
            for (int i = 0; i < m; i++) {
                parts.now[i] = last[i];
                parts.last[i] = last[i] - (last[i] - before[i]) / PARTS;
                parts.greatest[i] = greatest[i];
                parts.memory[i] = memory[i];
                parts.force[i][0] = last[i];
                parts.run.displacement[i][0] = run.displacement[i][j];
                parts.run.velocity[i][0] = run.velocity[i][j];
            }
            if (carried.isPresent()) {
                for (int p = 0; p < forceSlope.length; p++) {
                    between(forceSlope[p], j, parts.forceSlope[p]);
                }
                for (int p = 0; p < run.lift.heightSlope().length; p++) {
                    between(run.lift.heightSlope()[p], j, parts.run.lift.heightSlope()[p]);
                    between(run.lift.rateSlope()[p], j, parts.run.lift.rateSlope()[p]);
                }
                parts.carried.get().goOnFrom(carried.get());
                for (int i = 0; i < m; i++) {
                    for (int p = 0; p < slope[i].length; p++) {
                        begun[i][p] = carried.get().slope(i, p);
                        parts.slope[i][p][0] = begun[i][p];
                    }
                }
            }
            for (int k = 0; k < PARTS; k++) {
                parts.go(shaken, pushed, modulated, k, since + j * run.step);
            }
            parts.run.linear.whole(parts.y, parts.now, old);
            run.linear.kept(old, parts.now, y);
            for (int i = 0; i < m; i++) {
                now[i] = parts.now[i];
                memory[i] = parts.memory[i];
                run.displacement[i][j + 1] = parts.run.displacement[i][PARTS];
                run.velocity[i][j + 1] = parts.run.velocity[i][PARTS];
                force[i][j + 1] = now[i];
                share(parts.force[i], last[i], now[i], force[i], j);
            }
            if (carried.isPresent()) {
                carried.get().goOnFrom(parts.carried.get());
                for (int i = 0; i < m; i++) {
                    for (int p = 0; p < slope[i].length; p++) {
                        slope[i][p][j + 1] = carried.get().slope(i, p);
                        share(parts.slope[i][p], begun[i][p], slope[i][p][j + 1], slope[i][p], j);
                    }
                }
            }
        }

        /**
         * Puts the impulse of a step's parts to its two ends, as near to each as it was.
         *
         * @param parts with what they have had put to them
         * @param begun value at the start
         * @param ended at the end
         * @param out Modified.
         */
        private void share(double[] parts, double begun, double ended, double[] out, int j) {
            double first = (parts[0] - begun / 2) / PARTS;
            double second = (parts[PARTS] - ended / 2) / PARTS;
            for (int k = 1; k < PARTS; k++) {
                first += parts[k] * (PARTS - k) / PARTS / PARTS;
                second += parts[k] * k / PARTS / PARTS;
            }
            out[j] += first - begun / 2;
            out[j + 1] += second - ended / 2;
            if (j == 0 && whole) {   // nothing comes before the record's first sample that could have the other half
                out[0] = 2 * first;
            }
        }
    }

    /** Solves the laws of every link at the end of the step, link after link until nothing moves; leaves every law's motion there. */
    private void solve(double[] y, double[] now, double[] memory, int j) {
        for (int[] link : together) {
            int at = laws[link[0]].link;
            reached[link[0]] = ModalStep.dot(linear.stretch[link[0]], y) - lift.height(at, j + 1);
            passing[link[0]] = ModalStep.dot(linear.rate[link[0]], y) - lift.rate(at, j + 1);
            followed[link[0]].lifted(lift, j + 1);
            for (int i : link) {
                begin(motions[i], i, memory[i], j);
            }
        }
        boolean several = together.length > 1;
        boolean settled = false;
        for (int sweep = 0; sweep < (several ? SWEEPS : 1) && !settled; sweep++) {
            double moved = 0;
            for (int[] link : together) {
                double kept = sum(link, now);
                place(link, now, y);
                FollowedLink other = followed[link[0]];
                double found = root(link, now, kept, other.follows() ? other.whole(y, now) : 0);
                moved = Math.max(moved, Math.abs(found - kept) / (1 + Math.abs(found)));
            }
            settled = moved < TOLERANCE;
        }
        for (int[] link : several ? together : new int[0][]) {
            place(link, now, y);
        }
        for (FollowedLink link : followed) {
            if (link.follows()) {
                link.settle(y, now);
            }
        }
    }

    /** Of the forces of some laws [N]. */
    static double sum(int[] link, double[] now) {
        double sum = 0;
        for (int i : link) {
            sum += now[i];
        }
        return sum;
    }

    /**
     * f = φ(r + g (f - f0), v + h (f - f0)), φ the sum of a link's laws, by secants from where it was found last, now and then a Newton
     * step, kept within a bracket. What another link does moves with f as well.
     *
     * @param now   force of each law. Modified: those of the link are what was found.
     * @param start of the link's in all
     * @param whole what it goes by, with the forces so far
     */
    private double root(int[] link, double[] now, double start, double whole) {
        int i = link[0];
        LinkMotion motion = motions[i];
        double r = motion.displacement - linear.give[i][i] * start;
        double v = motion.velocity - linear.giveVelocity[i][i] * start;
        double w = followed[i].follows() ? whole - followed[i].give[i] * start : 0;
        double f = start;
        double low = Double.NEGATIVE_INFINITY;
        double high = Double.POSITIVE_INFINITY;
        double excess = f - force(link);
        double gradient = gradients[i];
        for (int k = 0; k < ITERATIONS && !(Math.abs(excess) <= TOLERANCE * (1 + Math.abs(f))); k++) {
            if (excess > 0) {
                high = f;
            } else {
                low = f;
            }
            if (k > 0 && k % FRESH == 0 || Double.isNaN(gradient)) {
                double h = 1e-6 * (1 + Math.abs(f));
                move(link, r, v, w, f + h);
                gradient = (f + h - force(link) - excess) / h;
            }
            double next = gradient > LEAST_GRADIENT ? f - excess / gradient : f - excess;
            boolean bracketed = low > Double.NEGATIVE_INFINITY && high < Double.POSITIVE_INFINITY;
            if (bracketed && !(next > low && next < high)) {
                next = (low + high) / 2;
            }
            move(link, r, v, w, next);
            double there = next - force(link);
            gradient = next == f ? gradient : (there - excess) / (next - f);
            f = next;
            excess = there;
        }
        gradients[i] = gradient;
        // What little is left goes by the slope, which costs no look at the law: over thousands of steps a memory would gather it.
        f -= gradient > LEAST_GRADIENT ? excess / gradient : 0;
        move(link, r, v, w, f);
        now[i] = f;
        for (int k = 1; k < link.length; k++) {
            now[link[k]] = laws[link[k]].law.force(motions[link[k]]);
            now[i] -= now[link[k]];
        }
        return f;
    }

    /** Force of a link's laws in its motion [N]. */
    private double force(int[] link) {
        double sum = 0;
        for (int i : link) {
            sum += laws[i].law.force(motions[i]);
        }
        return sum;
    }

    /**
     * The motion of a link whose laws have a force, and what another link does then.
     *
     * @param r displacement without the force [m]
     * @param v velocity without it [m/s]
     * @param w what the law goes by without it
     */
    private void move(int[] link, double r, double v, double w, double force) {
        int first = link[0];
        double displacement = r + linear.give[first][first] * force;
        double velocity = v + linear.giveVelocity[first][first] * force;
        for (int i : link) {
            motions[i].displacement = displacement;
            motions[i].velocity = velocity;
        }
        FollowedLink other = followed[first];
        if (other.follows()) {
            motions[first].modulation = other.value(w + other.give[first] * force);
        }
    }

    /** What a law's motion is at the end of step j whatever its force. */
    private void begin(LinkMotion motion, int i, double memory, int j) {
        motion.time = since + (j + 1) * step;
        motion.before = displacement[i][j];
        motion.memory = memory;
        motion.modulation = modulation[i].length == 0 ? 1 : modulation[i][j + 1];
        if (laws[i].late()) {
            recall(motion, i, j + 1, laws[i].law.lateness());
        }
    }

    /** The motion of a link at the end of the step, given all law forces. */
    private void place(int[] link, double[] now, double[] y) {
        int first = link[0];
        double r = reached[first];
        double v = passing[first];
        for (int k = 0; k < now.length; k++) {
            r += linear.give[first][k] * now[k];
            v += linear.giveVelocity[first][k] * now[k];
        }
        for (int i : link) {
            motions[i].displacement = r;
            motions[i].velocity = v;
        }
        if (followed[first].follows()) {
            motions[first].modulation = followed[first].value(followed[first].whole(y, now));
        }
    }

    /** Fills in the motion of law i some time before sample index; at rest before the start. At least one sample ago. */
    void recall(LinkMotion motion, int i, int index, double ago) {
        motion.lateDisplacement = earlier(displacement[i], index, ago);
        motion.lateVelocity = earlier(velocity[i], index, ago);
    }

    Structure structure() {
        return structure;
    }

    /** What lifts the links. Not a copy. */
    Lift lift() {
        return lift;
    }

    /** Not a copy. */
    LawSlopes[] laws() {
        return laws;
    }

    /** Laws that are found together, see there. Not a copy. */
    int[][] together() {
        return together;
    }

    /** The link by which law i goes, as it was at the end of the last step. */
    FollowedLink followed(int i) {
        return followed[i];
    }

    /** Motion of law i's link at the end of the last step. Not a copy. */
    LinkMotion motion(int i) {
        return motions[i];
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
        return LinkMotion.between(series, index - Math.max(1, ago / step), index);
    }
}

package wbv.body.simulate;

import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import wbv.body.Structure;

/**
 * The derivatives of state, law forces and memories of a {@link FreeRun} to every parameter, carried from step to step: those of the
 * discrete step itself, in modal coordinates.
 *
 * <p>Everything that runs over parameters lies side by side in memory, coordinate i of parameter p at i P + p, so that the
 * innermost loops are long and plain.
 */
final class CarriedSlopes {

    private final FreeRun run;
    private final Structure structure;
    private final LawSlopes[] laws;
    private final LawSlopes.Past past;
    private final int states;
    private final int count;
    private final double[][][] slope;
    private final double[][][] forceSlope;
    private final boolean known;
    /** Whether the structure's own parameters are among them. */
    private final boolean ofStructure;

    private final ModalStep linear;
    /** What parameters do through the step's own matrices, by source: states, then inputs before, then inputs after. */
    private final double[][] through;
    private final double[] source;

    private double[] state;
    private double[] free;
    /** Laws of one motion, those of a link: what concerns that is kept by link, in the order of these. */
    private final int[][] links;
    private final double[][] displacement;
    private final double[][] rate;
    private final double[][] earlier;
    /** Of the force of a link's laws in all. */
    private final double[][] force;
    /** What that changes the link's displacement and velocity by. */
    private final double[] moved;
    private final double[] passed;
    private final double[][] right;
    private final double[][] memory;
    /** Parameters that lift a link. */
    private final int[] lifting;
    /** Of what multiplies a law that goes by another link. */
    private final double[][] modulation;
    private final double[][] matrix;
    private final double[][][] displacementPast;
    private final double[][][] velocityPast;

    /**
     * @param slope      filled: derivative of each law force, by law, parameter and sample
     * @param forceSlope derivative of the known force, by parameter, body and sample. Not modified.
     * @param known      whether known forces act on the bodies
     */
    CarriedSlopes(FreeRun run, ModalStep linear, ExactHold[] holds, double[][][] slope, double[][][] forceSlope, boolean known,
            int samples) {
        this.run = run;
        this.structure = run.structure();
        this.laws = run.laws();
        this.past = run::recall;
        this.states = 2 * structure.bodies();
        this.count = forceSlope.length;
        this.slope = slope;
        this.forceSlope = forceSlope;
        this.known = known;
        this.ofStructure = holds.length > 1;
        int m = laws.length;
        links = run.together();
        this.linear = linear;
        ModalBasis basis = linear.basis;
        int inputs = inputs();
        through = new double[ofStructure ? states + 2 * inputs : 0][states * count];
        source = new double[through.length];
        for (int p = 0; p + 1 < holds.length; p++) {
            DMatrixRMaj transition = basis.within(holds[1 + p].transition);
            DMatrixRMaj first = basis.into(holds[1 + p].before);
            DMatrixRMaj second = basis.into(holds[1 + p].after);
            for (int i = 0; i < states; i++) {
                for (int k = 0; k < states; k++) {
                    through[k][i * count + p] = transition.get(i, k);
                }
                for (int u = 0; u < inputs; u++) {
                    through[states + u][i * count + p] = first.get(i, input(u));
                    through[states + inputs + u][i * count + p] = second.get(i, input(u));
                }
            }
        }
        state = new double[states * count];
        free = new double[states * count];
        displacement = new double[links.length][count];
        rate = new double[links.length][count];
        earlier = new double[links.length][count];
        force = new double[links.length][count];
        moved = new double[count];
        passed = new double[count];
        lifting = IntStream.range(0, run.lift().heightSlope().length)
                .filter(p -> java.util.Arrays.stream(run.lift().heightSlope()[p]).anyMatch(each -> each.length > 0)).toArray();
        right = new double[m][count];
        memory = new double[m][count];
        modulation = new double[m][count];
        matrix = new double[links.length][links.length];
        boolean late = IntStream.range(0, m).anyMatch(i -> laws[i].late());
        displacementPast = new double[m][count][late ? samples : 0];
        velocityPast = new double[m][count][late ? samples : 0];
    }

    /** Goes on from where another is, of the same structure and laws in steps of another length. */
    void goOnFrom(CarriedSlopes other) {
        System.arraycopy(other.state, 0, state, 0, state.length);
        for (int l = 0; l < laws.length; l++) {
            for (int i = 0; i < states; i++) {   // what the laws' forces do in a step waits for the next
                addRow(state, i * count, other.right[l], other.linear.own[l][i] - linear.own[l][i]);
            }
            System.arraycopy(other.right[l], 0, right[l], 0, count);
            System.arraycopy(other.memory[l], 0, memory[l], 0, count);
        }
        for (int g = 0; g < links.length; g++) {
            System.arraycopy(other.force[g], 0, force[g], 0, count);
            System.arraycopy(other.displacement[g], 0, displacement[g], 0, count);
        }
    }

    private void addRow(double[] target, int to, double[] row, double factor) {
        for (int p = 0; p < count; p++) {
            target[to + p] += factor * row[p];
        }
    }

    /** Derivative of law i's force to parameter p now. */
    double slope(int i, int p) {
        return right[i][p];
    }

    /** Inputs that may act: the base along each axis, each link that has laws, and the bodies where forces on them are known. */
    private int inputs() {
        return structure.axes() + links.length + (known ? structure.bodies() : 0);
    }

    /** Column of the step's input matrices for one of the {@link #inputs}. */
    private int input(int u) {
        int g = u - structure.axes();
        return g < 0 ? u : g < links.length ? structure.linkInput(laws[links[g][0]].link) : structure.bodyInput(g - links.length);
    }

    /**
     * One step.
     *
     * @param old the whole state before it, in modal coordinates
     * @param last law forces before it
     * @param now law forces after it. None modified.
     * @param j   sample before the step
     */
    void step(double[] old, double[] last, double[] now, double[][] acceleration, double[][] bodyForce, int j) {
        for (int i = 0; i < laws.length; i++) {
            laws[i].take(run.motion(i), past, i, j + 1);
        }
        for (int g = 0; g < links.length; g++) {
            System.arraycopy(displacement[g], 0, earlier[g], 0, count);
        }
        advance();
        if (ofStructure) {
            sources(old, last, now, acceleration, bodyForce, j);
        }
        for (int p = 0; p < count; p++) {
            for (int b = 0; b < forceSlope[p].length; b++) {
                int input = structure.bodyInput(b);
                double first = forceSlope[p][b][j];
                double second = forceSlope[p][b][j + 1];
                for (int i = 0; i < states; i++) {
                    free[i * count + p] += linear.before[input][i] * first + linear.after[input][i] * second;
                }
            }
        }
        for (int g = 0; g < links.length; g++) {
            read(g, j + 1);
            java.util.Arrays.fill(force[g], 0);
            for (int i : links[g]) {
                if (run.followed(i).follows()) {
                    follow(run.followed(i), modulation[i], j + 1);
                }
                rightSide(i, g, j);
                add(force[g], right[i], 1);
            }
        }
        eliminate();
        for (int g = 0; g < links.length; g++) {
            moves(g);
            for (int i : links[g]) {
                answer(i, g);
                for (int p = 0; p < count; p++) {
                    slope[i][p][j + 1] = right[i][p];
                }
                remember(i, g, j);
            }
        }
        double[] kept = state;
        state = free;
        free = kept;
    }

    /** The next state by itself and by the laws' forces so far; what they do in this step waits for the next. */
    private void advance() {
        for (int i = 0; i < states; i++) {
            int[] filled = linear.filled(i);
            double[] entry = linear.entry(i);
            int to = i * count;
            boolean paired = filled.length > 1;
            int one = filled[0] * count;
            int other = filled[paired ? 1 : 0] * count;
            double a = entry[0];
            double b = paired ? entry[1] : 0;
            double c = linear.push[links[0][0]][i];
            double[] first = force[0];
            for (int p = 0; p < count; p++) {
                free[to + p] = a * state[one + p] + b * state[other + p] + c * first[p];
            }
            for (int e = 2; e < entry.length; e++) {
                addRow(to, state, filled[e] * count, entry[e]);
            }
            for (int g = 1; g < links.length; g++) {
                addRow(to, force[g], 0, linear.push[links[g][0]][i]);
            }
        }
    }

    private void addRow(int to, double[] source, int from, double factor) {
        for (int p = 0; p < count; p++) {
            free[to + p] += factor * source[from + p];
        }
    }

    /** What the parameters of the structure do through the step's own matrices. */
    private void sources(double[] old, double[] last, double[] now, double[][] acceleration, double[][] bodyForce, int j) {
        int inputs = inputs();
        System.arraycopy(old, 0, source, 0, states);
        int axes = acceleration.length;
        for (int axis = 0; axis < axes; axis++) {
            source[states + axis] = acceleration[axis][j];
            source[states + inputs + axis] = acceleration[axis][j + 1];
        }
        for (int g = 0; g < links.length; g++) {
            source[states + axes + g] = FreeRun.sum(links[g], last);
            source[states + inputs + axes + g] = FreeRun.sum(links[g], now);
        }
        for (int b = 0; b < bodyForce.length; b++) {
            source[states + axes + links.length + b] = bodyForce[b][j];
            source[states + inputs + axes + links.length + b] = bodyForce[b][j + 1];
        }
        int s = 0;
        for (; s + 3 < source.length; s += 4) {
            addFour(free, s);
        }
        for (; s < source.length; s++) {
            add(free, through[s], source[s]);
        }
    }

    /** Four sources one after the other, so that what they are added to is fetched and stored once. */
    private void addFour(double[] target, int s) {
        double[] t0 = through[s];
        double[] t1 = through[s + 1];
        double[] t2 = through[s + 2];
        double[] t3 = through[s + 3];
        double s0 = source[s];
        double s1 = source[s + 1];
        double s2 = source[s + 2];
        double s3 = source[s + 3];
        for (int i = 0; i < target.length; i++) {
            target[i] = target[i] + s0 * t0[i] + s1 * t1[i] + s2 * t2[i] + s3 * t3[i];
        }
    }

    /** Motion of a link at a sample by the state, and by what lifts it. */
    private void read(int g, int j) {
        int first = links[g][0];
        double[] r = displacement[g];
        double[] v = rate[g];
        java.util.Arrays.fill(r, 0);
        java.util.Arrays.fill(v, 0);
        for (int k = 0; k < states; k++) {
            double a = linear.stretch[first][k];
            double b = linear.rate[first][k];
            int at = k * count;
            for (int p = 0; p < count; p++) {
                double value = free[at + p];
                r[p] += a * value;
                v[p] += b * value;
            }
        }
        Lift lift = run.lift();
        for (int p : lifting) {
            r[p] -= Lift.at(lift.heightSlope()[p][laws[first].link], j);
            v[p] -= Lift.at(lift.rateSlope()[p][laws[first].link], j);
        }
    }

    /**
     * What multiplies a law by the state, and by what the link that it goes by is itself.
     *
     * @param target Modified.
     */
    private void follow(FollowedLink other, double[] target, int j) {
        java.util.Arrays.fill(target, 0);
        double slope = other.slope();
        for (int k = 0; k < states; k++) {
            double a = slope * other.read[k];
            int at = k * count;
            for (int p = 0; p < count; p++) {
                target[p] += a * free[at + p];
            }
        }
        for (int p : lifting) {
            target[p] += slope * other.liftSlope(run.lift(), p, j);
        }
        if (ofStructure && other.isLoad) {
            target[other.link] += slope * other.displacement();
            target[structure.links() + other.link] += slope * other.velocity();
        }
    }

    private static void add(double[] target, double[] source, double factor) {
        for (int i = 0; i < target.length; i++) {
            target[i] += factor * source[i];
        }
    }

    /** The derivative of law i's force if no law's force changed its motion. */
    private void rightSide(int i, int g, int j) {
        double[] f = laws[i].force;
        double r = f[LawSlopes.DISPLACEMENT_NOW];
        double v = f[LawSlopes.VELOCITY_NOW];
        double b = f[LawSlopes.DISPLACEMENT_BEFORE];
        double z = f[LawSlopes.MEMORY_BEFORE];
        for (int p = 0; p < count; p++) {
            right[i][p] = r * displacement[g][p] + v * rate[g][p] + b * earlier[g][p] + z * memory[i][p];
        }
        direct(right[i], f, i);
        if (run.followed(i).follows()) {
            add(right[i], modulation[i], f[LawSlopes.MODULATION]);
        }
        if (laws[i].late()) {
            for (int p = 0; p < count; p++) {
                right[i][p] += f[LawSlopes.LATE_DISPLACEMENT] * run.past(displacementPast[i][p], i, j + 1)
                        + f[LawSlopes.LATE_VELOCITY] * run.past(velocityPast[i][p], i, j + 1);
            }
        }
    }

    /** What the forces of all links change a link's motion by. */
    private void moves(int g) {
        int first = links[g][0];
        java.util.Arrays.fill(moved, 0);
        java.util.Arrays.fill(passed, 0);
        for (int h = 0; h < links.length; h++) {
            add(moved, force[h], linear.give[first][links[h][0]]);
            add(passed, force[h], linear.giveVelocity[first][links[h][0]]);
        }
        add(displacement[g], moved, 1);
        add(rate[g], passed, 1);
    }

    /** Brings the derivative of law i's force to the motion that it has with all forces. */
    private void answer(int i, int g) {
        if (run.followed(i).follows()) {
            for (int h = 0; h < links.length; h++) {
                add(modulation[i], force[h], run.followed(i).slope() * run.followed(i).give[links[h][0]]);
            }
        }
        if (links[g].length == 1) {
            System.arraycopy(force[g], 0, right[i], 0, count);
        } else {
            add(right[i], moved, laws[i].force[LawSlopes.DISPLACEMENT_NOW]);
            add(right[i], passed, laws[i].force[LawSlopes.VELOCITY_NOW]);
        }
    }

    /** Adds the slopes of law i to its own parameters at unchanged motion. */
    private void direct(double[] target, double[] of, int i) {
        if (ofStructure) {
            target[laws[i].link] += of[LawSlopes.STIFFNESS];
            target[structure.links() + laws[i].link] += of[LawSlopes.DAMPING];
        }
        for (int own = 0; own < laws[i].parameters; own++) {
            target[run.ownOffset(i) + own] += of[LawSlopes.OWN + own];
        }
    }

    private void remember(int i, int g, int j) {
        double[] z = laws[i].memory;
        double[] kept = memory[i];
        for (int p = 0; p < count; p++) {
            kept[p] = z[LawSlopes.DISPLACEMENT_NOW] * displacement[g][p] + z[LawSlopes.VELOCITY_NOW] * rate[g][p]
                    + z[LawSlopes.DISPLACEMENT_BEFORE] * earlier[g][p] + z[LawSlopes.MEMORY_BEFORE] * kept[p];
        }
        direct(kept, z, i);
        if (run.followed(i).follows()) {
            add(kept, modulation[i], z[LawSlopes.MODULATION]);
        }
        if (laws[i].late()) {
            for (int p = 0; p < count; p++) {
                kept[p] += z[LawSlopes.LATE_DISPLACEMENT] * run.past(displacementPast[i][p], i, j + 1)
                        + z[LawSlopes.LATE_VELOCITY] * run.past(velocityPast[i][p], i, j + 1);
                displacementPast[i][p][j + 1] = displacement[g][p];
                velocityPast[i][p][j + 1] = rate[g][p];
            }
        }
    }

    /** Solves the few coupled links for all parameters at once: force becomes the derivative of what each link's laws carry. */
    private void eliminate() {
        int m = links.length;
        for (int g = 0; g < m; g++) {
            for (int h = 0; h < m; h++) {
                matrix[g][h] = g == h ? 1 : 0;
                for (int i : links[g]) {
                    int k = links[h][0];
                    matrix[g][h] -= laws[i].force[LawSlopes.DISPLACEMENT_NOW] * linear.give[i][k]
                            + laws[i].force[LawSlopes.VELOCITY_NOW] * linear.giveVelocity[i][k];
                    if (run.followed(i).follows()) {
                        matrix[g][h] -= laws[i].force[LawSlopes.MODULATION] * run.followed(i).slope() * run.followed(i).give[k];
                    }
                }
            }
        }
        for (int c = 0; c < m; c++) {
            for (int i = c + 1; i < m; i++) {
                double q = matrix[i][c] / matrix[c][c];
                for (int k = c; k < m; k++) {
                    matrix[i][k] -= q * matrix[c][k];
                }
                add(force[i], force[c], -q);
            }
        }
        for (int i = m - 1; i >= 0; i--) {
            for (int k = i + 1; k < m; k++) {
                add(force[i], force[k], -matrix[i][k]);
            }
            double pivot = 1 / matrix[i][i];
            for (int p = 0; p < count; p++) {
                force[i][p] *= pivot;
            }
        }
    }
}

package wbv.body.simulate;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import wbv.body.Row;
import wbv.body.Structure;

/**
 * The exact step of a structure's linear part in modal coordinates, where a row of it has two numbers at most and not as many as there are
 * states. What a force in a link does in the step at whose end it is found is added in the next, so that a state as kept here lacks it: x =
 * y + Σ after f.
 *
 * <p>Flat arrays and plain loops: a free run takes this step for every fine sample.
 */
final class ModalStep {

    /** Entries of the step's matrix that are no more than rounding. */
    private static final double NOTHING = 1e-13;

    final int states;
    final ModalBasis basis;
    /** By input of {@link Structure#inputMatrix} and state: what an input at the start and at the end of a step does. */
    final double[][] before;
    final double[][] after;
    /** By law: what its force at the end of one step does to the state as kept at the end of the next, before + E after. */
    final double[][] push;
    /** By law: columns of {@link #after}. */
    final double[][] own;
    /** By law and state: displacement and velocity of its link. */
    final double[][] stretch;
    final double[][] rate;
    /** Displacement and velocity of the link of law i that a unit force of law k gives at the end of the step. */
    final double[][] give;
    final double[][] giveVelocity;

    /** Columns of the step's matrix that are filled, by row, and what stands there. */
    private final int[][] filled;
    private final double[][] entry;
    private final int[] one;
    private final int[] other;
    private final double[] first;
    private final double[] second;
    private final boolean paired;
    private final int[] bodies;
    private final double[][] vectors;
    private final double balance;

    /**
     * @param hold the step of the states themselves
     * @param links of the laws
     */
    ModalStep(Structure structure, ModalBasis basis, ExactHold hold, int[] links) {
        this.basis = basis;
        states = 2 * structure.bodies();
        DMatrixRMaj step = basis.within(hold.transition);
        filled = IntStream.range(0, states)
                .mapToObj(i -> IntStream.range(0, states).filter(k -> k == i || Math.abs(step.get(i, k)) > NOTHING).toArray())
                .toArray(int[][]::new);
        entry = IntStream.range(0, states).mapToObj(i -> Arrays.stream(filled[i]).mapToDouble(k -> step.get(i, k)).toArray())
                .toArray(double[][]::new);
        one = new int[states];
        other = new int[states];
        first = new double[states];
        second = new double[states];
        for (int i = 0; i < states; i++) {
            boolean two = filled[i].length > 1;
            one[i] = filled[i][0];
            first[i] = entry[i][0];
            other[i] = filled[i][two ? 1 : 0];
            second[i] = two ? entry[i][1] : 0;
        }
        paired = Arrays.stream(filled).allMatch(row -> row.length <= 2);
        before = columns(basis.into(hold.before));
        after = columns(basis.into(hold.after));
        bodies = IntStream.range(0, structure.bodies()).map(structure::bodyInput).toArray();
        own = Arrays.stream(links).mapToObj(link -> after[structure.linkInput(link)]).toArray(double[][]::new);
        push = Arrays.stream(links).mapToObj(link -> pushed(before[structure.linkInput(link)], after[structure.linkInput(link)]))
                .toArray(double[][]::new);
        vectors = columns(basis.vectors);
        balance = structure.balance();
        stretch = Arrays.stream(links).mapToObj(link -> reads(structure.stretch(link), 1, 0)).toArray(double[][]::new);
        rate = Arrays.stream(links).mapToObj(link -> reads(structure.stretch(link), 0, 1)).toArray(double[][]::new);
        give = Arrays.stream(stretch).map(this::gives).toArray(double[][]::new);
        giveVelocity = Arrays.stream(rate).map(this::gives).toArray(double[][]::new);
    }

    /**
     * What reads a sum of a displacement and a velocity from a state as kept, by state.
     *
     * @param motion combination of the bodies' coordinates
     * @param displacement by which its displacement counts
     * @param velocity by which its velocity counts
     */
    double[] reads(Row motion, double displacement, double velocity) {
        return Arrays.stream(vectors)
                .mapToDouble(vector -> displacement / balance * motion.of(vector, 0) + velocity * motion.of(vector, states / 2)).toArray();
    }

    /** What unit forces of the laws give at the end of the step in which they are found to what is read so, by law. */
    double[] gives(double[] reads) {
        return Arrays.stream(own).mapToDouble(column -> dot(reads, column)).toArray();
    }

    private double[] pushed(double[] atStart, double[] atEnd) {
        double[] out = atStart.clone();
        for (int i = 0; i < states; i++) {
            for (int e = 0; e < entry[i].length; e++) {
                out[i] += entry[i][e] * atEnd[filled[i][e]];
            }
        }
        return out;
    }

    /**
     * The state as kept at the end of a step.
     *
     * @param y         at its start
     * @param forces of the laws at its start. Not modified.
     * @param base      acceleration of the base [m/s²], by axis and sample
     * @param known forces on the bodies [N], by body and sample. Not modified.
     * @param j         sample at its start
     * @param out Modified.
     */
    void advance(double[] y, double[] forces, double[][] base, double[][] known, int j, double[] out) {
        for (int i = 0; i < states; i++) {
            out[i] = first[i] * y[one[i]] + second[i] * y[other[i]];
        }
        for (int i = 0; i < states && !paired; i++) {
            for (int e = 2; e < filled[i].length; e++) {
                out[i] += entry[i][e] * y[filled[i][e]];
            }
        }
        for (int axis = 0; axis < base.length; axis++) {
            act(axis, base[axis][j], base[axis][j + 1], out);
        }
        for (int law = 0; law < push.length; law++) {
            add(out, push[law], forces[law]);
        }
        for (int body = 0; body < known.length; body++) {
            act(bodies[body], known[body][j], known[body][j + 1], out);
        }
    }

    /** Adds what an input does in a step. */
    private void act(int input, double atStart, double atEnd, double[] out) {
        double[] early = before[input];
        double[] late = after[input];
        for (int i = 0; i < states; i++) {
            out[i] += early[i] * atStart + late[i] * atEnd;
        }
    }

    /** Columns of row i of the step's matrix that are filled. Not a copy. */
    int[] filled(int i) {
        return filled[i];
    }

    /** What stands there. Not a copy. */
    double[] entry(int i) {
        return entry[i];
    }

    /**
     * The state with what the laws' forces did in the last step.
     *
     * @param out Modified.
     */
    void whole(double[] y, double[] forces, double[] out) {
        System.arraycopy(y, 0, out, 0, states);
        for (int law = 0; law < own.length; law++) {
            add(out, own[law], forces[law]);
        }
    }

    /**
     * The state as kept of a whole one.
     *
     * @param out Modified.
     */
    void kept(double[] whole, double[] forces, double[] out) {
        System.arraycopy(whole, 0, out, 0, states);
        for (int law = 0; law < own.length; law++) {
            add(out, own[law], -forces[law]);
        }
    }

    /** Largest magnitude of the states themselves, displacements times the balance and velocities; NaN where one is. */
    double largest(double[] y) {
        double most = 0;
        for (int i = 0; i < states; i++) {
            double sum = 0;
            for (int k = 0; k < states; k++) {
                sum += basis.vectors.get(i, k) * y[k];
            }
            most = Math.max(most, Math.abs(sum));
        }
        return most;
    }

    static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }

    private static void add(double[] x, double[] column, double amount) {
        for (int i = 0; i < x.length; i++) {
            x[i] += column[i] * amount;
        }
    }

    private static double[][] columns(DMatrixRMaj matrix) {
        return IntStream.range(0, matrix.numCols)
                .mapToObj(j -> IntStream.range(0, matrix.numRows).mapToDouble(i -> matrix.get(i, j)).toArray()).toArray(double[][]::new);
    }
}

package wbv.body.simulate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import java.util.stream.Stream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import wbv.body.Structure;

/** The step in modal coordinates against the same step of the states themselves. */
class ModalStepTest {

    private static final double STEP = 1 / 240.0;

    static Stream<Structure> structures() {
        return Stream.of(
                new Structure(new int[] {-1, 0, 1}, new int[] {0, 1, 2}, new double[] {90000, 75000, 30000}, new double[] {1300, 1500, 220},
                        new double[] {12, 45, 5.5}),
                // A head that nothing holds: two modes at zero, with one direction between them, so that the states stay as they are.
                new Structure(new int[] {-1, 0, 1}, new int[] {0, 1, 2}, new double[] {90000, 75000, 0}, new double[] {1300, 1500, 0},
                        new double[] {12, 45, 5.5}));
    }

    @ParameterizedTest
    @MethodSource("structures")
    void itIsTheStepOfTheStates(Structure structure) {
        double omega = structure.balance();
        ExactHold hold = ExactHold.of(structure.stateMatrix(omega), structure.inputMatrix(), STEP, new DMatrixRMaj[0],
                new DMatrixRMaj[0])[0];
        ModalStep step = new ModalStep(structure, ModalBasis.of(structure.stateMatrix(omega)), hold, new int[] {1, 2});
        Random random = new Random(5);
        int steps = 40;
        double[][] base = {random.doubles(steps + 1, -3, 3).toArray()};
        double[][] known = Stream.generate(() -> random.doubles(steps + 1, -20, 20).toArray()).limit(3).toArray(double[][]::new);
        double[][] forces = Stream.generate(() -> random.doubles(2, -50, 50).toArray()).limit(steps + 1).toArray(double[][]::new);
        DMatrixRMaj states = new DMatrixRMaj(6, 1);
        forces[0] = new double[2];
        double[] y = new double[6];
        double[] next = new double[6];
        for (int j = 0; j < steps; j++) {
            states = stepped(structure, hold, states, base, known, forces, j);
            step.advance(y, forces[j], base, known, j, next);
            double[] kept = y;
            y = next;
            next = kept;
        }
        double[] whole = new double[6];
        step.whole(y, forces[steps], whole);
        DMatrixRMaj back = new DMatrixRMaj(6, 1);
        CommonOps_DDRM.mult(step.basis.vectors, new DMatrixRMaj(6, 1, true, whole), back);
        assertArrayEquals(states.data, back.data, 1e-10 * CommonOps_DDRM.elementMaxAbs(states));
        double[] again = new double[6];
        step.kept(whole, forces[steps], again);
        assertArrayEquals(y, again, 1e-12 * CommonOps_DDRM.elementMaxAbs(states));
        for (int law = 0; law < 2; law++) {
            int link = law + 1;
            double gives = step.give[law][0] * forces[steps][0] + step.give[law][1] * forces[steps][1];
            assertEquals(structure.stretch(link).of(states.data, 0) / omega, ModalStep.dot(step.stretch[law], y) + gives, 1e-12);
            double hastens = step.giveVelocity[law][0] * forces[steps][0] + step.giveVelocity[law][1] * forces[steps][1];
            assertEquals(structure.stretch(link).of(states.data, 3), ModalStep.dot(step.rate[law], y) + hastens, 1e-10);
        }
    }

    /** x(h) = E x + B0 u(0) + B1 u(h). */
    private static DMatrixRMaj stepped(Structure structure, ExactHold hold, DMatrixRMaj states, double[][] base, double[][] known,
            double[][] forces, int j) {
        DMatrixRMaj out = new DMatrixRMaj(6, 1);
        CommonOps_DDRM.mult(hold.transition, states, out);
        CommonOps_DDRM.multAdd(hold.before, inputs(structure, base, known, forces, j), out);
        CommonOps_DDRM.multAdd(hold.after, inputs(structure, base, known, forces, j + 1), out);
        return out;
    }

    private static DMatrixRMaj inputs(Structure structure, double[][] base, double[][] known, double[][] forces, int j) {
        DMatrixRMaj out = new DMatrixRMaj(structure.inputMatrix().numCols, 1);
        out.set(0, base[0][j]);
        for (int law = 0; law < 2; law++) {
            out.set(structure.linkInput(law + 1), forces[j][law]);
        }
        for (int body = 0; body < 3; body++) {
            out.set(structure.bodyInput(body), known[body][j]);
        }
        return out;
    }
}

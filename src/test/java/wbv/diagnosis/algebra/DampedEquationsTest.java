package wbv.diagnosis.algebra;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import wbv.signal.ScalarProduct;

class DampedEquationsTest {

    private static final double[][] C = {{4e6, 1e3, 0}, {1e3, 3, 0.5}, {0, 0.5, 2}};
    private static final double[] G = {5, -1, 7};

    @Test
    void whatIsSolvedFulfilsTheEquations() {
        double[] s = DampedEquations.solve(C, G);
        for (int i = 0; i < 3; i++) {
            assertEquals(G[i], ScalarProduct.of(C[i], s), 1e-8);
        }
    }

    /** Held coordinates move nothing and ask nothing; damping raises the diagonal of the others by its share. */
    @Test
    void whatIsHeldStaysAndWhatIsDampedMovesLess() {
        double[] s = DampedEquations.solve(C, G, new boolean[] {false, true, false}, 0.25);
        assertArrayEquals(new double[] {5 / 5e6, 0, 7 / 2.5}, s, 1e-9);
        assertArrayEquals(new double[3], DampedEquations.solve(C, G, new boolean[] {true, true, true}, 0), 0);
    }

    /** Two equations that are one: the least of all solutions, half of it each. */
    @Test
    void equationsThatAreOneHaveTheirLeastSolution() {
        assertArrayEquals(new double[] {0.5, 0.5}, DampedEquations.solve(new double[][] {{1, 1}, {1, 1}}, new double[] {1, 1}), 1e-6);
    }
}

package wbv.diagnosis.algebra;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;

class SymmetricFactorTest {

    /** By hand: det {{4, 1}, {1, 3}} = 11, and (1, 4) is what it makes of (-1/11, 15/11). */
    @Test
    void determinantAndSolutionAreThoseOfTheMatrix() {
        SymmetricFactor factor = SymmetricFactor.of(new DMatrixRMaj(new double[][] {{4, 1}, {1, 3}})).orElseThrow();
        assertEquals(Math.log(11), factor.logDeterminant(), 1e-14);
        assertArrayEquals(new double[] {-1.0 / 11, 15.0 / 11}, factor.solve(new double[] {1, 4}), 1e-14);
        assertTrue(SymmetricFactor.of(new DMatrixRMaj(new double[][] {{1, 2}, {2, 1}})).isEmpty());
    }
}

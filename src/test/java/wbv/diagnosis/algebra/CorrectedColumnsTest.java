package wbv.diagnosis.algebra;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Vectors with corrections do what the sums of both do. */
class CorrectedColumnsTest {

    private static final int COUNT = 5;
    private static final int LENGTH = 23;

    @Test
    void theyAreTheirSums() {
        Random random = new Random(1);
        double[][] vectors = random(random, COUNT, LENGTH);
        double[][] more = random(random, 2, LENGTH);
        double[][] weights = random(random, 2, COUNT);
        CorrectedColumns plain = new CorrectedColumns(new Columns(vectors));
        CorrectedColumns corrected = plain.plus(more[0], weights[0]).plus(more[1], weights[1]);
        assertTrue(plain.isPlain());
        assertFalse(corrected.isPlain());
        assertSame(vectors[2], plain.sums()[2]);
        double[][] sums = new double[COUNT][LENGTH];
        for (int i = 0; i < COUNT; i++) {
            for (int k = 0; k < LENGTH; k++) {
                sums[i][k] = vectors[i][k] + weights[0][i] * more[0][k] + weights[1][i] * more[1][k];
            }
            assertArrayEquals(sums[i], corrected.sums()[i], 1e-14);
        }
        double[] other = random(random, 1, LENGTH)[0];
        assertArrayEquals(new Columns(sums).products(other), corrected.products(other), 1e-12);
        double[] factors = random(random, 1, COUNT)[0];
        double[] expected = other.clone();
        new Columns(sums).subtract(factors, expected);
        corrected.subtract(factors, other);
        assertArrayEquals(expected, other, 1e-12);
    }

    private static double[][] random(Random random, int count, int length) {
        double[][] out = new double[count][length];
        for (double[] vector : out) {
            for (int k = 0; k < length; k++) {
                vector[k] = random.nextGaussian();
            }
        }
        return out;
    }
}

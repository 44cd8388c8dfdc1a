package wbv.diagnosis.algebra;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Products of vectors are those of the matrices that EJML makes of them, for any number and length of vectors, with any zeros at their
 * ends.
 */
class ColumnsTest {

    private static double[][] vectors(Random random, int count, int length, int zeros) {
        double[][] vectors = new double[count][length];
        for (double[] vector : vectors) {
            int end = length - random.nextInt(zeros + 1);
            for (int i = random.nextInt(zeros + 1); i < end; i++) {
                vector[i] = random.nextGaussian();
            }
        }
        return vectors;
    }

    /** Each row of one times each of another, by row of the second. */
    private static double[][] products(double[][] one, double[][] other) {
        double[][] out = new double[other.length][one.length];
        if (one.length > 0 && other.length > 0) {
            DMatrixRMaj expected = new DMatrixRMaj(other.length, one.length);
            CommonOps_DDRM.multTransB(new DMatrixRMaj(other), new DMatrixRMaj(one), expected);
            for (int i = 0; i < other.length; i++) {
                for (int j = 0; j < one.length; j++) {
                    out[i][j] = expected.get(i, j);
                }
            }
        }
        return out;
    }

    private static void assertAre(double[][] expected, double[][] actual) {
        assertEquals(expected.length, actual.length);
        for (int i = 0; i < expected.length; i++) {
            assertArrayEquals(expected[i], actual[i], 1e-10);
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 5, 0", "1, 1, 0", "1, 3, 3", "2, 511, 0", "3, 512, 200", "4, 513, 513", "5, 2000, 0", "5, 2000, 1999", "9, 1025, 600"})
    void productsAreThoseOfTheMatrix(int count, int length, int zeros) {
        Random random = new Random(count + zeros);
        double[][] vectors = vectors(random, count, length, zeros);
        double[][] others = vectors(random, 3, length, zeros);
        Columns columns = new Columns(vectors);
        assertAre(products(vectors, vectors), columns.gram());
        assertAre(products(vectors, others), columns.products(new Columns(others)));
        assertArrayEquals(products(vectors, others)[0], columns.products(others[0]), 1e-10);
    }

    @ParameterizedTest
    @CsvSource({"0, 5, 0", "3, 512, 200", "4, 513, 513", "9, 1025, 600"})
    void multiplesAreTakenOneAfterTheOther(int count, int length, int zeros) {
        Random random = new Random(count + zeros);
        double[][] vectors = vectors(random, count, length, zeros);
        double[] factors = random.doubles(count, -1, 1).map(factor -> factor > 0.5 ? 0 : factor).toArray();
        double[] target = random.doubles(length, -1, 1).toArray();
        double[] expected = target.clone();
        for (int i = 0; i < count; i++) {
            for (int k = 0; k < length; k++) {
                expected[k] -= factors[i] * vectors[i][k];
            }
        }
        new Columns(vectors).subtract(factors, target);
        assertArrayEquals(expected, target, 1e-12);
    }
}

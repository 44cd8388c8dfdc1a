package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Products of vectors are those of the matrix that EJML makes of them, for any number and length of vectors. */
class GramTest {

    @ParameterizedTest
    @CsvSource({"0, 5", "1, 1", "2, 511", "3, 512", "4, 513", "5, 2000", "9, 1025"})
    void productsAreThoseOfTheMatrix(int count, int length) {
        Random random = new Random(count);
        double[][] vectors = new double[count][length];
        for (double[] vector : vectors) {
            for (int i = 0; i < length; i++) {
                vector[i] = random.nextGaussian();
            }
        }
        double[][] gram = Gram.of(vectors);
        assertEquals(count, gram.length);
        if (count > 0) {
            DMatrixRMaj rows = new DMatrixRMaj(vectors);
            DMatrixRMaj expected = new DMatrixRMaj(count, count);
            CommonOps_DDRM.multTransB(rows, rows, expected);
            for (int i = 0; i < count; i++) {
                for (int j = 0; j < count; j++) {
                    assertEquals(expected.get(i, j), gram[i][j], 1e-10);
                }
            }
        }
    }
}

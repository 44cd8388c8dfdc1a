package wbv.body.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.ejml.data.ZMatrixRMaj;
import org.ejml.dense.row.CommonOps_ZDRM;
import org.junit.jupiter.api.Test;

/** Inverses of complex symmetric matrices beside EJML's. */
class LineMatricesTest {

    private static final int LINES = LineMatrices.LINES - 3;
    private static final int FIRST = 5;

    @Test
    void theyAreThoseOfALibrary() {
        for (int rows = 1; rows <= 14; rows++) {
            Random random = new Random(rows);
            double[][][] entries = new double[rows][rows][2 * (FIRST + LINES)];
            LineMatrices matrices = new LineMatrices(rows);
            for (int again = 0; again < 2; again++) {
                matrices.clear();
                for (int i = 0; i < rows; i++) {
                    for (int j = 0; j <= i; j++) {
                        // A chain with a branch: most entries are nothing.
                        boolean joined = i - j <= 1 || j == 0 && i % 4 == 0;
                        for (int k = 0; k < entries[i][j].length && joined; k++) {
                            entries[i][j][k] = random.nextGaussian() + (i == j ? 9 : 0);
                        }
                        entries[j][i] = entries[i][j];
                        if (joined) {
                            matrices.add(i, j, entries[i][j], 0.5, FIRST, LINES);
                        }
                    }
                    for (int k = 0; k < LINES; k++) {
                        matrices.add(i, k, 0.1 * k);
                    }
                }
                matrices.invert();
                hold(rows, entries, matrices);
            }
        }
    }

    private static void hold(int rows, double[][][] entries, LineMatrices matrices) {
        for (int k = 0; k < LINES; k++) {
            ZMatrixRMaj whole = new ZMatrixRMaj(rows, rows);
            for (int i = 0; i < rows; i++) {
                for (int j = 0; j < rows; j++) {
                    whole.set(i, j, 0.5 * entries[i][j][2 * (FIRST + k)] + (i == j ? 0.1 * k : 0),
                            0.5 * entries[i][j][2 * (FIRST + k) + 1]);
                }
            }
            CommonOps_ZDRM.invert(whole);
            for (int i = 0; i < rows; i++) {
                for (int j = 0; j < rows; j++) {
                    double[] spectrum = new double[2 * (FIRST + LINES)];
                    matrices.get(i, j, spectrum, FIRST, LINES);
                    assertEquals(whole.getReal(i, j), spectrum[2 * (FIRST + k)], 1e-12);
                    assertEquals(whole.getImag(i, j), spectrum[2 * (FIRST + k) + 1], 1e-12);
                    assertEquals(0, spectrum[0], "what comes before the first line is left as it was");
                }
            }
        }
    }
}

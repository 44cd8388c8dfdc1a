package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.MultivariateNormalDistribution;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.special.Erf;
import org.junit.jupiter.api.Test;

/** Evidence held to closed forms, and to sums over fine grids where there are none. */
class LaplaceEvidenceTest {

    private static final int NUMBERS = 30;
    private static final double DEVIATION = 1.7;

    private static double[] far(int n, double sign) {
        double[] out = new double[n];
        Arrays.fill(out, sign * Double.POSITIVE_INFINITY);
        return out;
    }

    /** y = A x + unit noise, x normal: the evidence of the first k columns. */
    private static double laplace(double[] y, double[][] a, int k) {
        double[][] h = new double[k][k];
        double[] g = new double[k];
        for (int i = 0; i < k; i++) {
            g[i] = -Fitter.dot(a[i], y);
            for (int j = 0; j < k; j++) {
                h[i][j] = Fitter.dot(a[i], a[j]) + (i == j ? 1 / (DEVIATION * DEVIATION) : 0);
            }
        }
        double top = -0.5 * Fitter.dot(y, y) - 0.5 * NUMBERS * Math.log(2 * Math.PI) - k * Math.log(DEVIATION * Math.sqrt(2 * Math.PI));
        return LaplaceEvidence.log(top, g, h, far(k, -1), far(k, 1));
    }

    private static double closed(double[] y, double[][] a, int k) {
        RealMatrix c = MatrixUtils.createRealIdentityMatrix(NUMBERS);
        for (int i = 0; i < k; i++) {
            RealMatrix column = MatrixUtils.createColumnRealMatrix(a[i]);
            c = c.add(column.multiply(column.transpose()).scalarMultiply(DEVIATION * DEVIATION));
        }
        return Math.log(new MultivariateNormalDistribution(null, new double[NUMBERS], c.getData()).density(y));
    }

    @Test
    void nestedLinearModelsHaveTheirClosedForm() {
        Random random = new Random(3);
        for (int draw = 0; draw < 20; draw++) {
            double[][] a = new double[4][];
            Arrays.setAll(a, i -> random.doubles(NUMBERS).map(v -> 2 * v - 1).toArray());
            double[] y = IntStream.range(0, NUMBERS).mapToDouble(i -> random.nextGaussian() + a[0][i] - 2 * a[2][i]).toArray();
            for (int k = 1; k <= 4; k++) {
                assertEquals(closed(y, a, k), laplace(y, a, k), 1e-8);
            }
        }
    }

    /** A half of a normal distribution, a sliver of its tail, and one that is level between bounds. */
    @Test
    void boundsCutWhatTheyCut() {
        double[] none = {Double.NEGATIVE_INFINITY};
        double[] free = {Double.POSITIVE_INFINITY};
        double h = 3;
        double whole = 0.5 * Math.log(2 * Math.PI / h);
        assertEquals(whole - Math.log(2), LaplaceEvidence.log(0, new double[] {0}, new double[][] {{h}}, new double[] {0}, free), 1e-8);
        double g = 20;
        double tail = 0.5 * g * g / h + whole + Math.log(0.5 * Erf.erfc(g / Math.sqrt(h) / Math.sqrt(2)));
        assertEquals(tail, LaplaceEvidence.log(0, new double[] {g}, new double[][] {{h}}, new double[] {0}, free), 1e-6);
        assertEquals(Math.log(1 / 1e4), LaplaceEvidence.log(0, new double[] {1e4}, new double[][] {{1e-3}}, new double[] {0}, free), 1e-5);
        assertEquals(Math.log(0.7), LaplaceEvidence.log(0, new double[] {0}, new double[][] {{1e-9}}, new double[] {-0.2}, new double[] {0.5}), 2e-3);
        assertEquals(whole, LaplaceEvidence.log(0, new double[] {0}, new double[][] {{h}}, none, free), 1e-12);
    }

    /** Two coordinates that lean on each other, one at a bound, one between two; by a sum over a fine grid: means for ranges cost a few hundredths. */
    @Test
    void boundedTogether() {
        double[][] h = {{4, 1.5, 0.5}, {1.5, 3, -0.7}, {0.5, -0.7, 2}};
        double[] g = {1, -0.4, 0.3};
        double[] low = {0, -0.5, Double.NEGATIVE_INFINITY};
        double[] high = {Double.POSITIVE_INFINITY, 0.6, Double.POSITIVE_INFINITY};
        double step = 0.02;
        double sum = 0;
        for (double x = step / 2; x < 5; x += step) {
            for (double y = -0.5 + step / 2; y < 0.6; y += step) {
                for (double z = -6 + step / 2; z < 6; z += step) {
                    double quadratic = h[0][0] * x * x + h[1][1] * y * y + h[2][2] * z * z + 2 * (h[0][1] * x * y + h[0][2] * x * z + h[1][2] * y * z);
                    sum += Math.exp(-(g[0] * x + g[1] * y + g[2] * z) - 0.5 * quadratic);
                }
            }
        }
        assertEquals(Math.log(sum * step * step * step), LaplaceEvidence.log(0, g, h, low, high), 0.05);
    }
}

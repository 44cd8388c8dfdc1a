package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CoherenceDistributionTest {

    @Test
    void ofUnrelatedSignalsItIsBetaAndItsMeanIsInputsOverAverages() {
        CoherenceDistribution one = new CoherenceDistribution(7, 1);
        assertEquals(1.0 / 7, one.byChance());
        for (double c : new double[] {0.05, 0.3, 0.6, 0.9}) {
            assertEquals(1 - Math.pow(1 - c, 6), one.cumulative(c, 0), 1e-12);
        }
        assertEquals(1 - Math.pow(0.05, 1 / 6.0), one.quantile(0.95, 0), 1e-8);
        assertEquals(3.0 / 12, new CoherenceDistribution(12, 3).byChance());
    }

    /** The finite sum of Carter, Knapp and Nuttall (1973) for a whole number of averages. */
    @ParameterizedTest
    @CsvSource({"2, 0.3", "7, 0.5", "16, 0.7", "40, 0.2", "64, 0.9"})
    void withOneInputItIsCartersSum(int n, double truth) {
        CoherenceDistribution one = new CoherenceDistribution(n, 1);
        for (double c = 0.05; c < 1; c += 0.1) {
            assertEquals(carter(c, truth, n), one.cumulative(c, truth), 1e-8);
        }
    }

    private static double carter(double c, double truth, int n) {
        double sum = 0;
        for (int l = 0; l <= n - 2; l++) {
            double term = 1;
            double hypergeometric = 1;
            for (int k = 0; k < l; k++) {   // 2F1(-l, 1-n; 1; γ² c)
                term *= (double) (k - l) * (k + 1 - n) / ((k + 1.0) * (k + 1)) * truth * c;
                hypergeometric += term;
            }
            sum += Math.pow((1 - c) / (1 - truth * c), l) * hypergeometric;
        }
        return c * Math.pow((1 - truth) / (1 - truth * c), n) * sum;
    }

    /** Gaussian segments of two inputs that cause a given share of the output. */
    @ParameterizedTest
    @CsvSource({"5, 0", "8, 0.5", "20, 0.7"})
    void severalInputsScatterLikeGaussianSegments(int n, double truth) {
        Random random = new Random(31);
        CoherenceDistribution law = new CoherenceDistribution(n, 2);
        double[] chances = new double[4000];
        for (int trial = 0; trial < chances.length; trial++) {
            chances[trial] = law.cumulative(estimate(n, truth, random), truth);
        }
        Arrays.sort(chances);
        double distance = 0;
        for (int i = 0; i < chances.length; i++) {
            distance = Math.max(distance, Math.abs(chances[i] - (i + 0.5) / chances.length));
        }
        assertTrue(distance < 1.63 / Math.sqrt(chances.length), "Kolmogorov's distance " + distance);   // 1 % of cases
    }

    /** The multiple coherence of n complex Gaussian segments, by projection on two inputs made orthogonal. */
    private static double estimate(int n, double truth, Random random) {
        double[][] x = new double[2][];
        double[] y = gaussian(n, random);
        for (int i = 0; i < 2; i++) {
            x[i] = gaussian(n, random);
        }
        for (int k = 0; k < 2 * n; k++) {
            y[k] = Math.sqrt(1 - truth) * y[k] + Math.sqrt(truth / 2) * (x[0][k] + x[1][k]);
        }
        double power = Arrays.stream(y).map(v -> v * v).sum();
        subtract(x[1], x[0]);
        subtract(y, x[0]);
        subtract(y, x[1]);
        return 1 - Arrays.stream(y).map(v -> v * v).sum() / power;
    }

    private static double[] gaussian(int n, Random random) {
        return random.doubles(2L * n).map(u -> 0).map(zero -> random.nextGaussian()).toArray();
    }

    /** Takes from y what x explains, as complex numbers. */
    private static void subtract(double[] y, double[] x) {
        double re = 0;
        double im = 0;
        double power = 0;
        for (int k = 0; k < x.length; k += 2) {
            re += y[k] * x[k] + y[k + 1] * x[k + 1];
            im += y[k + 1] * x[k] - y[k] * x[k + 1];
            power += x[k] * x[k] + x[k + 1] * x[k + 1];
        }
        for (int k = 0; k < x.length; k += 2) {
            y[k] -= (re * x[k] - im * x[k + 1]) / power;
            y[k + 1] -= (re * x[k + 1] + im * x[k]) / power;
        }
    }

    @Test
    void quantilesInvertAlsoForManyAveragesAndPartsOfOne() {
        for (double n : new double[] {1.9, 41.7, 900.5}) {
            CoherenceDistribution law = new CoherenceDistribution(n, 1);
            for (double truth : new double[] {0, 0.5, 0.95}) {
                assertEquals(0.95, law.cumulative(law.quantile(0.95, truth), truth), 1e-5);
            }
        }
        // Of many averages an estimate is normal, with variance 2 γ² (1-γ²)² / n (Bendat and Piersol, 2010, table 9.6).
        assertEquals(0.5 + 1.645 * Math.sqrt(2 * 0.5 * 0.25 / 4000), new CoherenceDistribution(4000, 1).quantile(0.95, 0.5), 1e-3);
    }

    @Test
    void tooFewAveragesAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> new CoherenceDistribution(2, 2));
        assertThrows(IllegalArgumentException.class, () -> new CoherenceDistribution(5, 1).cumulative(0.5, 1));
        assertThrows(IllegalArgumentException.class, () -> new CoherenceDistribution(5, 1).quantile(0, 0.5));
    }

    /** Hours of averages: the normal form takes over where the sum has grown long, and is the same there. */
    @Test
    void manyAveragesAreTheNormalForm() {
        for (double truth : new double[] {0.5, 0.7, 0.9}) {
            for (double chance : new double[] {0.01, 0.05, 0.5, 0.95}) {
                double sum = new CoherenceDistribution(CoherenceDistribution.MANY, 1).quantile(chance, truth);
                double normal = new CoherenceDistribution(CoherenceDistribution.MANY + 1e-6, 1).quantile(chance, truth);
                assertEquals(sum, normal, 1e-4, truth + " at " + chance);
            }
        }
        assertEquals(0.5, new CoherenceDistribution(1e9, 1).quantile(0.05, 0.5), 1e-4);
    }
}

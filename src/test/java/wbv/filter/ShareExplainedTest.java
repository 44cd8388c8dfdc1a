package wbv.filter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ShareExplainedTest {

    private static final double RATE = 60;
    private static final int N = 6000;

    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.5, 0.9})
    void itIsOneLessTheErrorOverTheVariance(double left) {
        Random random = new Random(3);
        ShareExplained explained = new ShareExplained();
        double[] y = new double[N];
        double errors = 0;
        for (int n = 0; n < N; n++) {
            double said = Math.sqrt(1 - left) * random.nextGaussian();
            double error = Math.sqrt(left) * random.nextGaussian();
            y[n] = 9.81 + said + error;
            errors += error * error;
            explained.accept(9.81 + said, y[n], RATE, true);
        }
        double mean = java.util.Arrays.stream(y).average().orElseThrow();
        double total = java.util.Arrays.stream(y).map(value -> (value - mean) * (value - mean)).sum();
        assertEquals(1 - errors / total, explained.share(), 1e-9);
        assertEquals(0, explained.lost());
    }

    /** For a third of the time the predictions are of something else: share -0.33, and that third is lost, but for the memory's. */
    @Test
    void whatIsNoBetterThanTheMeanIsLost() {
        Random random = new Random(4);
        ShareExplained explained = new ShareExplained();
        for (int n = 0; n < N; n++) {
            double y = random.nextGaussian();
            boolean astray = n >= N / 3 && n < 2 * N / 3;
            explained.accept(astray ? 2 * random.nextGaussian() : 0.9 * y, y, RATE, true);
        }
        assertTrue(explained.share() < -0.5, "share " + explained.share());
        assertEquals(N / 3.0, explained.lost(), 12 * RATE);
    }

    @Test
    void atRestAndWhereSamplesAreMissingNothingIsLost() {
        ShareExplained explained = new ShareExplained();
        Random random = new Random(5);
        for (int n = 0; n < N; n++) {
            explained.accept(random.nextGaussian(), n % 2 == 0 ? Double.NaN : random.nextGaussian(), RATE, false);
        }
        assertEquals(0, explained.lost());
        assertTrue(explained.share() < 0);
    }
}

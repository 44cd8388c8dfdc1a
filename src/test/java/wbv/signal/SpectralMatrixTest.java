package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What one channel shares with none of the others; the rest of the matrix is held to the responses that are made of it. */
class SpectralMatrixTest {

    private static final int SAMPLES = 20_000;

    /** Closed form: white noise of variance σ² at rate 1 has a one-sided density of 2σ². */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void whatTheOthersDoNotShowIsTheNoise(long seed) {
        Random random = new Random(seed);
        SpectralMatrix matrix = new SpectralMatrix(new Segmentation(1, 128, 0.5), Detrend.MEAN, 3);
        for (int i = 0; i < SAMPLES; i++) {
            double common = 30 * random.nextGaussian();
            double other = 10 * random.nextGaussian();
            matrix.accept(new double[] {common + random.nextGaussian(), common + other + 2 * random.nextGaussian(), other});
        }
        double[] shared = matrix.density(0);
        double[] own = matrix.unshared()[0];
        // The second channel less the third shows the first with a noise of variance 4: what is left of 1 beside it is its own,
        // and of what both have the part that the weaker does not tell.
        double left = 1 + 1 / (1 / 900.0 + 1 / 4.0);
        assertEquals(2 * left, mean(own), 0.1 * 2 * left);
        assertTrue(mean(shared) > 100 * mean(own));
    }

    @Test
    void whereTheOthersLeaveNothingItIsNotANumber() {
        Random random = new Random(4);
        SpectralMatrix matrix = new SpectralMatrix(new Segmentation(1, 64, 0.5), Detrend.MEAN, 2);
        for (int i = 0; i < 90; i++) {
            matrix.accept(new double[] {random.nextGaussian(), random.nextGaussian()});
        }
        assertTrue(Double.isNaN(matrix.unshared()[0][5]), "one segment tells nothing of two channels");
    }

    private static double mean(double[] density) {
        return Arrays.stream(density, 2, density.length - 2).average().orElseThrow();
    }
}

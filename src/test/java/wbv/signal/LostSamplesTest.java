package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LostSamplesTest {

    private static final int SAMPLES = 6000;

    @Test
    void aPauseIsAtTheMean() {
        double[] x = new double[200];
        Arrays.setAll(x, i -> i < 60 ? 3 : i < 150 ? Double.NaN : 7);
        double mean = (60 * 3 + 50 * 7) / 110.0;
        double[] out = LostSamples.resting(x, 90);
        assertEquals(mean, out[80], 1e-12);
        assertEquals(mean, out[130], 1e-12);
        assertTrue(out[65] > 3 && out[65] < mean && out[145] > mean && out[145] < 7, out[65] + " " + out[145]);
        assertArrayEquals(LostSamples.filled(x), LostSamples.resting(x, 91), "a shorter gap is none");
        assertEquals(5, LostSamples.filled(x)[105], 0.05);
    }

    @Test
    void aWholeSeriesIsItself() {
        double[] x = {1, 2, 3};
        assertSame(x, LostSamples.filled(x));
    }

    @Test
    void whatIsLostAtTheEndsIsAsTheNextThatIsThere() {
        double nan = Double.NaN;
        assertArrayEquals(new double[] {5, 5, 5, 7, 7}, LostSamples.filled(new double[] {nan, 5, 5, 7, nan}), 1e-9);
        assertArrayEquals(new double[3], LostSamples.filled(new double[] {nan, nan, nan}));
        assertArrayEquals(new double[] {4, 4, 4}, LostSamples.filled(new double[] {4, nan, 4}));
    }

    @Test
    void theMeanIsOfWhatIsThere() {
        double nan = Double.NaN;
        assertEquals(3, LostSamples.mean(new double[] {1, nan, nan, 5}));
        assertEquals(0, LostSamples.mean(new double[] {nan}));
        assertArrayEquals(new double[] {-1, 1}, Arrays.copyOf(LostSamples.centred(new double[] {4, 6, nan}), 2));
    }

    /**
     * Closed form (Kolmogorov 1941): the sample that is lost between endless neighbours is missed by the harmonic mean of the spectrum. A
     * motion in 0.74 of the band with a noise of a fiftieth: 0.039.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void aBandLimitedMotionIsMetToItsNoise(long seed) {
        Random random = new Random(seed);
        double[] read = Arrays.stream(motion(random, 0.37)).map(value -> value + 0.02 * random.nextGaussian()).toArray();
        double[] gaps = read.clone();
        for (int i = 40; i < gaps.length - 40; i += 50) {
            gaps[i] = Double.NaN;
        }
        double least = Math.sqrt(1 / (0.26 / 0.0004 + 0.74 / (1 / 0.74 + 0.0004)));
        double error = error(read, gaps, LostSamples.filled(gaps));
        assertTrue(error < 1.4 * least && error > 0.7 * least, "missed by " + error + ", at least " + least);
    }

    /**
     * Closed form: of x_i = a x_(i-1) + e_i the likeliest value between two is a (x_(i-1) + x_(i+1)) / (1 + a²), missed by a variance of
     * 1 / (1 + a²) of that of e.
     */
    @ParameterizedTest
    @ValueSource(doubles = {-0.8, 0.3, 0.95})
    void anAutoregressionIsMetAsWellAsItCanBe(double a) {
        Random random = new Random(7);
        double[] x = new double[40_000];
        for (int i = 1; i < x.length; i++) {
            x[i] = a * x[i - 1] + random.nextGaussian();
        }
        double[] gaps = lossy(x, random, 0.05);
        assertEquals(Math.sqrt(1 / (1 + a * a)), error(x, gaps, LostSamples.filled(gaps)), 0.06);
    }

    /** A position that runs on is met between its ends, however long the gap. */
    @Test
    void alongAPathTheGapIsOnIt() {
        double[] x = new double[2000];
        Arrays.setAll(x, i -> 0.01 * i);
        for (int gap : new int[] {1, 5, 16, 40}) {
            double[] gaps = x.clone();
            Arrays.fill(gaps, 700, 700 + gap, Double.NaN);
            double error = error(x, gaps, LostSamples.filled(gaps));
            assertTrue(error < 0.02, gap + " samples: missed by " + error);
        }
    }

    private static double[] motion(Random random, double band) {
        RealDft dft = new RealDft(SAMPLES);
        double[] spectrum = dft.forward(random.doubles(SAMPLES, -1, 1).toArray());
        Arrays.fill(spectrum, (int) (2 * band * SAMPLES), spectrum.length, 0);
        double[] x = dft.inverse(spectrum);
        double size = Math.sqrt(Arrays.stream(x).map(value -> value * value).average().orElseThrow());
        return Arrays.stream(x).map(value -> value / size).toArray();
    }

    private static double[] lossy(double[] x, Random random, double share) {
        double[] out = x.clone();
        for (int i = 1; i < x.length - 1; i++) {
            out[i] = random.nextDouble() < share ? Double.NaN : x[i];
        }
        return out;
    }

    private static double error(double[] x, double[] gaps, double[] filled) {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < x.length; i++) {
            if (Double.isNaN(gaps[i])) {
                sum += (filled[i] - x[i]) * (filled[i] - x[i]);
                count++;
            }
        }
        return Math.sqrt(sum / count);
    }
}

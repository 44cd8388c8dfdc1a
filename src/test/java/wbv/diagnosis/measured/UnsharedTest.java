package wbv.diagnosis.measured;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Sensors at 50 Hz, whose noise is read between 12 and 18 Hz. */
class UnsharedTest {

    private static final double NOISE = 0.02;
    private static final int DRAWS = 20;

    /** Motion ten times the noise, broad as a road gives it, reaches the sensors by ways of their own: it is no noise. */
    @ParameterizedTest
    @CsvSource({"1100, 2", "1100, 4", "6000, 2", "6000, 5"})
    void motionThatSensorsShareIsNoNoise(int samples, int sensors) {
        double mean = 0;
        for (int d = 0; d < DRAWS; d++) {
            double[][] series = series(d, samples, sensors, 0.2);
            double level = new NoiseLevel().ofWhatIsNotShared(series).orElseThrow();
            assertEquals(NOISE, level, 0.35 * NOISE, "draw " + d);
            mean += level / DRAWS;
            assertTrue(new NoiseLevel().of(series[0]) > 5 * NOISE, "the band is full of motion");
        }
        assertEquals(NOISE, mean, 0.15 * NOISE);
    }

    @ParameterizedTest
    @CsvSource({"1100, 4", "6000, 4"})
    void sensorsThatShareNothingAreLeftToTheirBand(int samples, int sensors) {
        for (int d = 0; d < 5 * DRAWS; d++) {
            assertTrue(new NoiseLevel().ofWhatIsNotShared(series(d, samples, sensors, 0)).isEmpty(), "draw " + d);
        }
    }

    /** @param size standard deviation of the motion */
    private static double[][] series(long seed, int samples, int sensors, double size) {
        Random random = new Random(seed);
        double[] motion = random.doubles(samples).map(v -> size * Math.sqrt(12) * (v - 0.5)).toArray();
        double[][] out = new double[sensors][samples];
        for (int c = 0; c < sensors; c++) {
            double pole = c == 0 ? 0.9 : 0.55 - 0.08 * c;   // a body passes little on up there
            double moved = 0;
            for (int i = 0; i < samples; i++) {
                moved += pole * (motion[i] - moved);
                out[c][i] = moved + NOISE * random.nextGaussian();
            }
        }
        return out;
    }
}

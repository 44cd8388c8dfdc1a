package wbv.diagnosis.measured;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.simulate.Excitation;

/** Noise is left out of a motion, over seeds; what is more is integrated. */
class AboveNoiseTest {

    private static final int SAMPLES = 8000;
    private static final double RATE = 200;
    private static final double NOISE = 0.05;
    private static final Excitation ANY = Excitation.ofForces(RATE, SAMPLES, Map.of());

    private static double[] noise(Random random) {
        return random.doubles(SAMPLES).map(any -> NOISE * random.nextGaussian()).toArray();
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
    void ofNoiseNothingIsLeft(long seed) {
        double[] spectrum = ANY.spectrum(noise(new Random(seed)));
        for (int times = 0; times <= 2; times++) {
            assertTrue(Arrays.stream(AboveNoise.integral(ANY, spectrum, NOISE, times)).allMatch(x -> x == 0), times + " times");
        }
    }

    /** A motion of 2 to 15 Hz that comes and goes, under a white noise that would be ten times as much, twice integrated. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
    void anAccelerationIsAMotion(long seed) {
        Random random = new Random(seed);
        double[] motion = new double[SAMPLES];
        double[] acceleration = noise(random);
        for (double f = 2; f < 15; f += 0.37) {
            double w = 2 * Math.PI * f;
            double phase = 2 * Math.PI * random.nextDouble();
            for (int i = 0; i < SAMPLES; i++) {
                double t = i / RATE;
                double slow = Math.PI / SAMPLES * RATE;
                double s = Math.sin(slow * t);
                double c = Math.cos(slow * t);
                motion[i] += s * s * Math.sin(w * t + phase) / (w * w);
                acceleration[i] += (2 * slow * slow * (c * c - s * s) - w * w * s * s) / (w * w) * Math.sin(w * t + phase)
                        + 4 * slow * s * c / w * Math.cos(w * t + phase);
            }
        }
        double[] found = ANY.series(AboveNoise.integral(ANY, ANY.spectrum(acceleration), NOISE, 2));
        double off = 0;
        double size = 0;
        for (int i = 0; i < SAMPLES; i++) {
            off += Math.pow(found[i] - motion[i], 2);
            size += Math.pow(motion[i], 2);
        }
        assertTrue(off < 0.03 * 0.03 * size, "off by " + Math.sqrt(off / size));
    }
}

package wbv.filter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.filter.model.Spec;

class NoiseTest {

    private static final double RATE = 60;
    private static final double SENSOR = 0.01;
    private static final Spec SPEC = Spec.at(RATE).withNoise(SENSOR);

    /** Output of 1 m/s² rms whose innovations have a share of the model's error in them, and nothing that the filter expects. */
    private static OutputNoise after(double modelError, int samples, long seed) {
        Random random = new Random(seed);
        OutputNoise noise = new OutputNoise(SPEC);
        for (int i = 0; i < samples; i++) {
            noise.hear(random.nextGaussian());
            noise.learn(SENSOR * random.nextGaussian() + modelError * random.nextGaussian(), 0);
        }
        return noise;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.3, 0.5})
    void theModelsErrorIsLearned(double modelError) {
        double mean = 0;
        for (long seed = 0; seed < 20; seed++) {
            mean += after(modelError, 3600, seed).variance() / 20;
        }
        assertEquals(modelError * modelError + SENSOR * SENSOR, mean, 0.15 * modelError * modelError);
    }

    @Test
    void neverBelowTheSensorsNoise() {
        OutputNoise noise = after(0, 3600, 1);
        assertTrue(noise.variance() >= SENSOR * SENSOR);
        assertEquals(SENSOR * SENSOR, noise.variance(), 0.2 * SENSOR * SENSOR);
        for (int i = 0; i < 3600; i++) {
            noise.hear(1);
            noise.learn(0, 1);
        }
        assertEquals(SENSOR * SENSOR, noise.variance(), 1e-12);
    }

    /** First-order noise with correlation ρ: n samples are worth n (1 - ρ)/(1 + ρ). */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 0.8})
    void samplesThatFollowEachOtherCountLess(double correlation) {
        Random random = new Random(2);
        OutputNoise noise = new OutputNoise(SPEC);
        double value = 0;
        double mean = 0;
        for (int i = 0; i < 60000; i++) {
            value = correlation * value + Math.sqrt(1 - correlation * correlation) * random.nextGaussian();
            noise.correlate(value);
            mean += noise.samplesInOne() / 60000;
        }
        assertEquals((1 + correlation) / (1 - correlation), mean, 0.1 * (1 + correlation) / (1 - correlation));
    }

    /** q is a share of μ² + σ², not of μ + σ². */
    @Test
    void processNoiseIsTheSecondMomentAboutZero() {
        Random random = new Random(3);
        double[] q = new double[2];
        for (int sign = 0; sign < 2; sign++) {
            ParameterNoise noise = new ParameterNoise(1e-4, SPEC);
            for (int i = 0; i < 20000; i++) {
                noise.learn((sign == 0 ? 1 : -1) * 0.003 + 0.004 * random.nextGaussian(), 20000);
            }
            q[sign] = noise.variance();
        }
        assertEquals(0.5 * (0.003 * 0.003 + 0.004 * 0.004), q[0], 0.03 * q[0]);
        assertEquals(q[0], q[1], 0.05 * q[0]);
    }

    @Test
    void processNoiseKeepsItsBounds() {
        ParameterNoise noise = new ParameterNoise(0.003, SPEC);
        assertEquals(0.003 * 0.003 / RATE, noise.variance(), 0);
        for (int i = 0; i < 100; i++) {
            noise.learn(10, 100);
        }
        assertEquals(0.1 * 0.1 / RATE, noise.variance(), 1e-18);
    }
}

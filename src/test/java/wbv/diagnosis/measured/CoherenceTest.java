package wbv.diagnosis.measured;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What chance gives, as a distribution over draws of unrelated series, and what a relation gives. */
class CoherenceTest {

    private static final double RATE = 60;
    private static final int DRAWS = 300;

    /** Seven segments of the usual length have a coherence of 0.15 with nothing: that is no evidence. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1024, 1", "1024, 0.1", "3600, 1", "3600, 0.1"})
    void chanceGivesNothingInTheMean(int samples, double band) {
        double[] share = new double[DRAWS];
        double expected = 0;
        for (int d = 0; d < DRAWS; d++) {
            Coherence none = Coherence.of(RATE, series(2L * d, samples, band), series(2L * d + 1, samples, band), Coherence.Weight.INPUT);
            share[d] = none.share();
            expected += none.deviation() / DRAWS;
            assertFalse(none.isSure(), "draw " + d + ": " + none);
        }
        double mean = Arrays.stream(share).average().orElseThrow();
        double deviation = Math.sqrt(Arrays.stream(share).map(s -> (s - mean) * (s - mean)).average().orElseThrow());
        assertEquals(0, mean, 4 * expected / Math.sqrt(DRAWS) + 0.01);
        assertEquals(1, deviation / expected, 0.25);
    }

    @ParameterizedTest
    @CsvSource({"1024", "3600"})
    void aRelationKeepsItsShare(int samples) {
        double mean = 0;
        for (int d = 0; d < 20; d++) {
            double[] x = series(d, samples, 1);
            double[] noise = series(1000 + d, samples, 1);
            double[] y = new double[samples];
            Arrays.setAll(y, i -> x[i] + noise[i]);
            Coherence half = Coherence.of(RATE, x, y, Coherence.Weight.INPUT);
            assertTrue(half.isSure(), half.toString());
            mean += half.share() / 20;
        }
        assertEquals(0.5, mean, 0.04);
    }

    /** White noise, or what a one-pole low-pass leaves of it twice. @param band pole, 1 for white */
    private static double[] series(long seed, int samples, double band) {
        Random random = new Random(seed);
        double[] out = new double[samples];
        double a = 0;
        double b = 0;
        for (int i = 0; i < samples; i++) {
            a += band * (random.nextGaussian() - a);
            b += band * (a - b);
            out[i] = b;
        }
        return out;
    }
}

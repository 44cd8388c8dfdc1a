package wbv.filter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.filter.model.Spec;

/** Against a constant in noise, which a Kalman filter of one number finds; it takes the noise for white, and the noise may not be. */
class ObservedScatterTest {

    private static final double RATE = 60;
    /** Variance of the constant before the first sample, and of the noise, which is large beside it. */
    private static final double PRIOR = 1;
    private static final double NOISE = 100;

    /** What is left after some seconds: error, the filter's variance and that of the scatter. */
    private record End(double error, double filters, double scatter) {}

    /** @param correlation of the noise from a sample to the next, which the filter does not know */
    private static End follow(double correlation, double seconds, long seed) {
        Random random = new Random(500 + seed);
        ObservedScatter scatter = new ObservedScatter(Spec.at(RATE));
        scatter.restart(PRIOR);
        double truth = Math.sqrt(PRIOR) * random.nextGaussian();
        double estimate = 0;
        double p = PRIOR;
        double noise = Math.sqrt(NOISE) * random.nextGaussian();
        for (int i = 0; i < seconds * RATE; i++) {
            noise = correlation * noise + Math.sqrt(NOISE * (1 - correlation * correlation)) * random.nextGaussian();
            double gain = p / (p + NOISE);
            double move = gain * (truth + noise - estimate);
            double before = p;
            p *= 1 - gain;
            estimate += move;
            scatter.hear(move, before, p);
        }
        return new End(estimate - truth, p, scatter.variance(p));
    }

    /** Where noise is white the filter is right, from the first batches on: what it learns is not taken for scatter. */
    @ParameterizedTest
    @CsvSource({"6, 8", "15, 3", "60, 1.8"})
    void whiteNoiseIsNoScatter(double seconds, double most) {
        double ratio = 0;
        for (int seed = 0; seed < 200; seed++) {
            End end = follow(0, seconds, seed);
            ratio += Math.log(end.scatter() / end.filters()) / 200;
        }
        assertTrue(Math.exp(ratio) < most, "variance " + Math.exp(ratio) + " times the filter's");
    }

    /** Noise whose memory is a third of a second: (1 + ρ)/(1 - ρ) times the variance that the filter believes. */
    @Test
    void noiseThatFollowsItselfIs() {
        double correlation = 0.95;
        double square = 0;
        double said = 0;
        int runs = 400;
        for (int seed = 0; seed < runs; seed++) {
            End end = follow(correlation, 120, seed);
            square += end.error() * end.error() / end.filters() / runs;
            said += Math.log(end.scatter() / end.filters()) / runs;
        }
        double factor = (1 + correlation) / (1 - correlation);
        double shrunk = factor * NOISE / (120 * RATE) < PRIOR ? factor : PRIOR;
        assertEquals(shrunk, square, 0.25 * factor, "the truth");
        assertTrue(Math.exp(said) > 0.8 * square && Math.exp(said) < 2 * square, Math.exp(said) + " where the truth is " + square);
    }

    /** Two standard deviations hold the truth as often as they claim, whatever the noise, early and late. */
    @ParameterizedTest
    @CsvSource({"0, 6", "0, 30", "0, 120", "0.9, 6", "0.9, 30", "0.9, 120", "0.97, 6", "0.97, 30", "0.97, 120"})
    void twoDeviationsHoldTheTruth(double correlation, double seconds) {
        int inside = 0;
        int runs = 400;
        for (int seed = 0; seed < runs; seed++) {
            End end = follow(correlation, seconds, seed);
            inside += Math.abs(end.error()) < 2 * Math.sqrt(end.scatter()) ? 1 : 0;
        }
        assertTrue(inside > 0.91 * runs, inside + " of " + runs);
    }
}

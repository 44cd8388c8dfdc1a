package wbv.filter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.distribution.TDistribution;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.filter.model.Adaptation;
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
        return follow(Spec.at(RATE), correlation, seconds, seed);
    }

    private static End follow(Spec spec, double correlation, double seconds, long seed) {
        Random random = new Random(500 + seed);
        ObservedScatter scatter = new ObservedScatter(spec);
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

    /** Where noise is white the filter is right, but for what few batches may say: what it learns is not taken for scatter. */
    @ParameterizedTest
    @CsvSource({"30, 3", "60, 1.6", "600, 1.4"})
    void whiteNoiseIsNoScatter(double seconds, double most) {
        double ratio = 0;
        for (int seed = 0; seed < 200; seed++) {
            End end = follow(0, seconds, seed);
            ratio += Math.log(end.scatter() / end.filters()) / 200;
        }
        assertTrue(Math.exp(ratio) < most, "variance " + Math.exp(ratio) + " times the filter's");
    }

    /** Noise whose memory is a third of a second: (1 + ρ)/(1 - ρ) times the variance that the filter believes. */
    @ParameterizedTest
    @ValueSource(doubles = {60, 240, 1200})
    void noiseThatFollowsItselfIs(double seconds) {
        double correlation = 0.95;
        double said = 0;
        int runs = 200;
        for (int seed = 0; seed < runs; seed++) {
            End end = follow(correlation, seconds, seed);
            said += Math.log(end.scatter() / end.filters()) / runs;
        }
        double factor = (1 + correlation) / (1 - correlation);
        assertTrue(Math.exp(said) > 0.8 * factor && Math.exp(said) < 1.6 * factor, Math.exp(said) + " where the truth is " + factor);
    }

    /** Two standard deviations hold the truth as often as they claim, whatever the noise, early and late. */
    @ParameterizedTest
    @CsvSource({"0, 8", "0, 30", "0, 240", "0.9, 8", "0.9, 30", "0.9, 240", "0.97, 8", "0.97, 30", "0.97, 240"})
    void twoDeviationsHoldTheTruth(double correlation, double seconds) {
        int inside = 0;
        int runs = 400;
        for (int seed = 0; seed < runs; seed++) {
            End end = follow(correlation, seconds, seed);
            inside += Math.abs(end.error()) < 2 * Math.sqrt(end.scatter()) ? 1 : 0;
        }
        // 95.4 % wanted; 2 % is two standard errors of the count.
        assertTrue(inside > 0.93 * runs, inside + " of " + runs);
    }

    /** Batches that say the same number have no scatter, however far they moved the estimate. */
    @Test
    void twoBatchesAreTheJackknifeByHand() {
        Spec spec = Spec.at(RATE).adapting(Adaptation.USUAL.with(new Adaptation.Scatter(1 / RATE, 20)));
        ObservedScatter agreed = new ObservedScatter(spec);
        agreed.restart(0);
        agreed.hear(8, 1, 1e-9);
        agreed.hear(0, 1, 0.5);
        assertEquals(0, agreed.variance(0), 1e-12);
        ObservedScatter apart = new ObservedScatter(spec);
        apart.restart(0);
        apart.hear(8, 1, 1e-9);
        apart.hear(1, 1, 0.5);   // one says 8 and the other 10, so that leaving either out moves their mean by 1
        double student = new TDistribution(1).inverseCumulativeProbability(0.975)
                / new NormalDistribution().inverseCumulativeProbability(0.975);
        assertEquals(2 * student * student, apart.variance(0), 1e-6);
    }

    /** With room for few, neighbours are joined: what they say together stays, and fewer degrees of freedom cost what they have to. */
    @Test
    void fewBatchesSayTheSameRoughly() {
        double ratio = 0;
        for (int seed = 0; seed < 100; seed++) {
            double[] said = new double[2];
            for (int i = 0; i < 2; i++) {
                Spec spec = Spec.at(RATE).adapting(Adaptation.USUAL.with(new Adaptation.Scatter(3, i == 0 ? 10 : 200)));
                said[i] = follow(spec, 0.9, 600, seed).scatter();
            }
            ratio += Math.log(said[0] / said[1]) / 100;
        }
        double student = new TDistribution(9).inverseCumulativeProbability(0.975)
                / new NormalDistribution().inverseCumulativeProbability(0.975);
        assertEquals(Math.pow(student * 10 / 9, 2), Math.exp(ratio), 0.2);
    }
}

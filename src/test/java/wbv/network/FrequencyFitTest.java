package wbv.network;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The fit beside bodies in closed form: sums of sines go through a transmissibility one by one. */
class FrequencyFitTest {

    private static final double TAU = 2 * Math.PI;

    @ParameterizedTest
    @CsvSource({"0.1,2.2", "0.35,5", "0.6,8.5"})
    void oneModeIsFoundFromAfar(double zeta, double frequency) {
        double[][] motion = motion(7, 0, zeta, TAU * frequency);
        FrequencyFit.Found found = new FrequencyFit(1).from(motion, start(0.4, 5));
        assertEquals(zeta, found.value()[0], 0.02 * zeta);
        assertEquals(TAU * frequency, found.value()[1], 0.005 * TAU * frequency);
    }

    /** A mean of the two resonances in series form, not one of wbv's own models: 1/D1 + 1/D2 with a common DC gain of 1. */
    @Test
    void twoModesAreFoundWhateverTheNumerator() {
        double[] truth = {0.2, TAU * 4, 0.3, TAU * 9};
        FrequencyFit.Found found = new FrequencyFit(2).from(motion(3, 0, truth), start(0.4, 5, 0.4, 10));
        for (int j = 0; j < 4; j++) {
            assertEquals(truth[j], found.value()[j], 0.05 * truth[j], "target " + j);
        }
    }

    /** Without an excitation, under noise, nothing is learned: what was known comes back, with its deviation. */
    @Test
    void aWindowThatTellsNothingLeavesWhatWasKnown() {
        double[] known = {0.3, 30};
        double[] deviation = {0.03, 2};
        SplittableRandom random = new SplittableRandom(4);
        double[][] motion = new double[2][Imaging.SAMPLES];
        Arrays.setAll(motion[1], n -> random.nextDouble(-1, 1));
        FrequencyFit.Found found = new FrequencyFit(1).from(motion, new Estimate(known, deviation));
        assertArrayEquals(known, found.value(), 0.5);
        assertEquals(1, found.deviation()[1] / deviation[1], 0.1);
    }

    /** Noise of a known level in both sensors is found again, and intervals of 90 % hold as often as they say. */
    @Test
    void noiseIsMeasuredAndIntervalsHold() {
        int held = 0;
        double sum = 0;
        int trials = 200;
        FrequencyFit fit = new FrequencyFit(1);
        for (int i = 0; i < trials; i++) {
            FrequencyFit.Found found = fit.from(motion(100 + i, 0.02, 0.3, TAU * 5), start(0.4, 4));
            held += Math.abs(found.value()[1] - TAU * 5) < Estimate.NINETY * found.deviation()[1] ? 1 : 0;
            sum += found.left() / trials;
        }
        assertTrue(held >= 165 && held <= 194, held + " of 200; 90 % less or more four deviations are 163 to 197");
        assertEquals(0.02 * Math.sqrt(25 / 30.0), sum, 0.0015, "of white noise to 30 Hz what lies below 25 Hz");
    }

    /** Two modes shown to one: more is left where there is shaking than where not. */
    @Test
    void whatAnotherBodyLeavesIsColoured() {
        double[][] motion = motion(9, 0.005, 0.2, TAU * 4, 0.3, TAU * 9);
        FrequencyFit.Found found = new FrequencyFit(1).from(motion, start(0.4, 5));
        assertTrue(found.coloured() > 3, "noise would leave 1: " + found.coloured());
        assertTrue(new FrequencyFit(2).from(motion, start(0.4, 5, 0.4, 10)).coloured() < 1.5);
    }

    /** Doubt adds the spread of all by the share of unexplained power that is too much: 3/4 at twice the limit. */
    @Test
    void doubtGrowsFromTheLimitToTheSpreadOfAll() {
        Estimate sure = new Estimate(new double[] {1}, new double[] {0.3});
        Estimate other = new Estimate(new double[] {4}, new double[] {0.3});
        assertEquals(0.3, Usual.doubted(sure, other, 0.99, new double[] {2}).deviation()[0], 1e-15);
        assertEquals(Math.sqrt(0.09 + 3), Usual.doubted(sure, sure, 2, new double[] {2}).deviation()[0], 1e-12);
        assertEquals(Math.sqrt(0.09 + 4 + 9), Usual.doubted(sure, other, 1e9, new double[] {2}).deviation()[0], 1e-9);
    }

    private static Estimate start(double... values) {
        double[] value = new double[values.length];
        double[] unknown = new double[values.length];
        Arrays.fill(unknown, Double.NaN);
        Arrays.setAll(value, j -> j % 2 == 0 ? values[j] : TAU * values[j]);
        return new Estimate(value, unknown);
    }

    /** Sixty sines to 12 Hz, none of them on a line of the window, and their answers; white noise on both. */
    private static double[][] motion(long seed, double noise, double... modes) {
        SplittableRandom random = new SplittableRandom(seed);
        double[][] motion = new double[2][Imaging.SAMPLES];
        for (int s = 0; s < 60; s++) {
            double omega = TAU * random.nextDouble(0.5, 12);
            double phase = random.nextDouble(TAU);
            double[] gain = transmissibility(omega, modes);
            for (int n = 0; n < Imaging.SAMPLES; n++) {
                double angle = omega * n / Imaging.RATE + phase;
                motion[0][n] += 0.15 * Math.cos(angle);
                motion[1][n] += 0.15 * (gain[0] * Math.cos(angle) - gain[1] * Math.sin(angle));
            }
        }
        for (double[] channel : motion) {
            for (int n = 0; n < channel.length; n++) {
                channel[n] += noise * random.nextGaussian();
            }
        }
        return motion;
    }

    private static double[] transmissibility(double omega, double... modes) {
        List<double[]> parts = new java.util.ArrayList<>();
        for (int m = 0; m < modes.length; m += 2) {
            double w2 = modes[m + 1] * modes[m + 1];
            double d = w2 - omega * omega;
            double c = 2 * modes[m] * modes[m + 1] * omega;
            double size = d * d + c * c;
            parts.add(new double[] {(w2 * d + c * c) / size, (c * d - w2 * c) / size});
        }
        return new double[] {parts.stream().mapToDouble(p -> p[0]).average().orElseThrow(),
            parts.stream().mapToDouble(p -> p[1]).average().orElseThrow()};
    }
}

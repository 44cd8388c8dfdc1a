package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.signal.FrequencyResponse.Excited;

class FrequencyResponseTest {

    private static final double RATE = 60;
    private static final double NATURAL = 5;

    /**
     * Transmissibility of a mass on a spring and damper. Columns 2 and 3: peak at {@code r = sqrt(sqrt(1+8ζ²)-1)/(2ζ)} of
     * {@code T(r) = sqrt((1+4ζ²r²)/((1-r²)²+4ζ²r²))}. The record is made in the frequency domain, so that it is exact between
     * the samples too.
     */
    @ParameterizedTest
    @CsvSource({"0.1, 0.9903, 5.1228", "0.2, 0.9647, 2.7339", "0.25, 0.9481, 2.2832", "0.3, 0.9302, 1.9946",
        "0.35, 0.9115, 1.7970", "0.4, 0.8926, 1.6550", "0.475, 0.8647, 1.5060", "0.5, 0.8556, 1.4679",
        "0.6, 0.8206, 1.3528", "0.7, 0.7883, 1.2764", "1.0, 0.7071, 1.1547"})
    void transmissibilityIsTheClosedForm(double damping, double peakRatio, double peak) {
        double[][] record = oscillator(1 << 16, damping, new Random(7));
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(RATE, 1024, 0.5), Detrend.MEAN, 1);
        for (int n = 0; n < record[0].length; n++) {
            spectrum.accept(record[0][n], record[1][n]);
        }
        FrequencyResponse response = spectrum.response(0, Excited.USUAL);
        double bias = spectrum.segmentation().peakBias(NATURAL, damping);
        int best = 1;
        for (int k = 1; response.frequency()[k] < 20; k++) {
            double expected = modulus(response.frequency()[k] / NATURAL, damping);
            double tolerance = -1.5 * bias + 5 * response.error()[k] + 0.002;
            assertEquals(1, response.h1().magnitude(k) / expected, tolerance, "|H1| at " + response.frequency()[k] + " Hz");
            assertEquals(1, response.hv().magnitude(k) / expected, tolerance, "|Hv| at " + response.frequency()[k] + " Hz");
            assertEquals(phase(response.frequency()[k] / NATURAL, damping), response.h1().phase(k),
                    -1.5 * bias + 5 * response.error()[k] + 0.002, "phase at " + response.frequency()[k] + " Hz");
            assertEquals(k > 1, response.usable()[k]);
            best = response.hv().magnitude(k) > response.hv().magnitude(best) ? k : best;
        }
        assertEquals(peak, response.hv().magnitude(best), 0.02 * peak);
        // A flat peak is found less exactly: |T| within 0.5 % of it is as good.
        assertEquals(peak, modulus(response.frequency()[best] / NATURAL, damping), 0.005 * peak);
        assertEquals(peak, modulus(peakRatio, damping), 1e-4);
    }

    @Test
    void noiseOnTheInputLeavesH2AndLowersH1() {
        double[] mean = gains(0.5, 0);
        assertEquals(2 / 1.5, mean[0], 4 * mean[3]);
        assertEquals(2, mean[1], 4 * mean[3]);
    }

    @Test
    void noiseOnTheOutputLeavesH1AndRaisesH2() {
        double[] mean = gains(0, 0.5);
        assertEquals(2, mean[0], 4 * mean[3]);
        assertEquals(2 * 1.5, mean[1], 4 * mean[3]);
    }

    @Test
    void equalNoiseOnBothLeavesHv() {
        double[] mean = gains(0.5, 0.5);
        assertEquals(2 / 1.5, mean[0], 4 * mean[3]);
        assertEquals(2 * 1.5, mean[1], 4 * mean[3]);
        assertEquals(2, mean[2], 4 * mean[3]);
    }

    /**
     * Mean real H1, H2, Hv of a gain of 2 over bins and seeds, and a bound of their standard error; noise power over signal
     * power on input and output given. H2 and Hv of few averages are biased by chance: 1000 s are averaged in each.
     */
    private static double[] gains(double inputNoise, double outputNoise) {
        double[] sum = new double[3];
        int count = 0;
        for (int seed = 0; seed < 4; seed++) {
            Random random = new Random(seed);
            CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(RATE, 64, 0.5), Detrend.MEAN, 1);
            for (int n = 0; n < 60_000; n++) {
                double x = random.nextGaussian();
                spectrum.accept(x + Math.sqrt(inputNoise) * random.nextGaussian(),
                        2 * (x + Math.sqrt(outputNoise) * random.nextGaussian()));
            }
            FrequencyResponse response = spectrum.response(0, Excited.USUAL);
            for (int k = 2; k < 31; k++) {
                sum[0] += response.h1().re()[k];
                sum[1] += response.h2().re()[k];
                sum[2] += response.hv().re()[k];
                count++;
            }
        }
        // One estimate scatters by less than 0.03 · 2; neighbouring bins of a Hann window count as half independent.
        return new double[] {sum[0] / count, sum[1] / count, sum[2] / count, 0.06 / Math.sqrt(count / 2.0)};
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"0.5, 0.2", "0.5, 1", "0.75, 0.5", "0, 0.5"})
    void randomErrorIsTheScatterOverRepetitions(double overlap, double noise) {
        double squares = 0;
        double predicted = 0;
        int count = 0;
        for (int seed = 0; seed < 60; seed++) {
            Random random = new Random(100 + seed);
            CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(RATE, 32, overlap), Detrend.NONE, 1);
            for (int n = 0; n < 3200; n++) {
                double x = random.nextGaussian();
                spectrum.accept(x, x + Math.sqrt(noise) * random.nextGaussian());
            }
            FrequencyResponse response = spectrum.response(0, Excited.USUAL);
            for (int k = 2; k < 15; k++) {
                double deviation = response.h1().magnitude(k) - 1;
                squares += deviation * deviation;
                predicted += response.error()[k];
                count++;
            }
        }
        // 780 estimates, about 400 of them independent, know their own scatter to 3.5 %.
        assertEquals(1, predicted / count / Math.sqrt(squares / count), 0.14);
    }

    @Test
    void anOutputThatLagsHasNegativePhase() {
        Random random = new Random(3);
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(RATE, 256, 0.5), Detrend.MEAN, 1);
        double previous = 0;
        for (int n = 0; n < 20_000; n++) {
            double x = random.nextGaussian();
            spectrum.accept(x, previous);
            previous = x;
        }
        FrequencyResponse response = spectrum.response(0, Excited.USUAL);
        for (int k = 1; k < 127; k++) {
            double expected = -2 * Math.PI * response.frequency()[k] / RATE;
            assertEquals(expected, response.h1().phase(k), 0.01);
            assertEquals(expected, response.h2().phase(k), 0.01);
            assertEquals(expected, response.hv().phase(k), 0.01);
        }
    }

    @Test
    void moduliObeyTheCoherence() {
        Random random = new Random(4);
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(RATE, 64, 0.5), Detrend.MEAN, 1);
        for (int n = 0; n < 2000; n++) {
            double x = random.nextGaussian();
            spectrum.accept(x, 0.3 * x + random.nextGaussian());
        }
        FrequencyResponse response = spectrum.response(0, Excited.USUAL);
        for (int k = 0; k < 33; k++) {
            double h1 = response.h1().magnitude(k);
            double h2 = response.h2().magnitude(k);
            assertEquals(response.coherence()[k] * h2, h1, 1e-12);
            assertEquals(h1 * h2, Math.pow(response.hv().magnitude(k), 2), 1e-12);
        }
    }

    @Test
    void frequenciesWithoutExcitationAreNotUsable() {
        double[][] record = oscillator(1 << 14, 0.4, new Random(5), 1, 9);
        Random random = new Random(6);
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(RATE, 512, 0.5), Detrend.LINEAR, 1);
        for (int n = 0; n < record[0].length; n++) {
            spectrum.accept(record[0][n] + 1e-3 * random.nextGaussian(), record[1][n] + 1e-3 * random.nextGaussian());
        }
        FrequencyResponse response = spectrum.response(0, Excited.USUAL);
        assertFalse(response.usable()[0]);
        for (int k = 1; k < response.frequency().length; k++) {
            double f = response.frequency()[k];
            if (f > 1.3 && f < 8.7) {
                assertTrue(response.usable()[k], f + " Hz is excited");
            } else if (f < 0.5 || f > 9.5) {
                assertFalse(response.usable()[k], f + " Hz is not");
            }
        }
    }

    @Test
    void chanceCoherenceOfFewSegmentsIsNotUsable() {
        assertEquals(0.7, Excited.USUAL.leastCoherence(40, 1));
        // Two averages: P(estimate <= c) = c (1-γ²)²/(1-γ²c)², half of the output caused.
        double c = Excited.USUAL.leastCoherence(2, 1);
        assertEquals(0.95, c * 0.25 / Math.pow(1 - c / 2, 2), 1e-6);
        assertEquals(1, Excited.USUAL.leastCoherence(1, 1));
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(RATE, 64, 0.5), Detrend.MEAN, 1);
        Random random = new Random(8);
        for (int n = 0; n < 64; n++) {
            spectrum.accept(random.nextGaussian(), random.nextGaussian());
        }
        for (boolean usable : spectrum.response(0, Excited.USUAL).usable()) {
            assertFalse(usable); // a single segment has coherence 1 everywhere, and it means nothing
        }
    }

    @Test
    void aDeadInputGivesNoNumbersAndNoBin() {
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(RATE, 64, 0.5), Detrend.MEAN, 1);
        for (int n = 0; n < 640; n++) {
            spectrum.accept(0, Math.sin(n));
        }
        FrequencyResponse response = spectrum.response(0, Excited.USUAL);
        for (int k = 0; k < 33; k++) {
            assertTrue(Double.isNaN(response.h1().re()[k]));
            assertEquals(0, response.coherence()[k]);
            assertFalse(response.usable()[k]);
        }
    }

    private static double modulus(double r, double damping) {
        double c = 4 * damping * damping * r * r;
        return Math.sqrt((1 + c) / ((1 - r * r) * (1 - r * r) + c));
    }

    private static double phase(double r, double damping) {
        return Math.atan(2 * damping * r) - Math.atan2(2 * damping * r, 1 - r * r);
    }

    private static double[][] oscillator(int length, double damping, Random random) {
        return oscillator(length, damping, random, 0.1, 0.45 * RATE);
    }

    /** One period of band-limited noise on a base, and what the mass on it does. */
    private static double[][] oscillator(int length, double damping, Random random, double from, double to) {
        double[] base = new double[length];
        double[] mass = new double[length];
        for (int k = 1; k < length / 2; k++) {
            double f = k * RATE / length;
            if (f >= from && f <= to) {
                double size = Math.sqrt(length) * modulus(f / NATURAL, damping);
                base[2 * k] = Math.sqrt(length) * random.nextGaussian();
                base[2 * k + 1] = Math.sqrt(length) * random.nextGaussian();
                double angle = phase(f / NATURAL, damping);
                double scale = size / Math.sqrt(length);
                mass[2 * k] = scale * (Math.cos(angle) * base[2 * k] - Math.sin(angle) * base[2 * k + 1]);
                mass[2 * k + 1] = scale * (Math.sin(angle) * base[2 * k] + Math.cos(angle) * base[2 * k + 1]);
            }
        }
        Fft fft = new Fft(length);
        fft.inverse(base);
        fft.inverse(mass);
        return new double[][] {base, mass};
    }
}

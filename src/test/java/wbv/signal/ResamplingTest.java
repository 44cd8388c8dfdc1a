package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@link BandlimitedResampler} and {@link Upsampler}. */
class ResamplingTest {

    /** Ratio, frequency as a part of the lower rate, within the pass band of 0.4. */
    @ParameterizedTest
    @CsvSource({"4, 1, 0.05", "4, 1, 0.17", "4, 1, 0.4", "8, 1, 0.3", "3, 2, 0.39", "5, 3, 0.21", "1, 1, 0.4", "1, 4, 0.4",
        "3, 5, 0.35", "50, 60, 0.1", "147, 160, 0.38"})
    void sinesInThePassBandKeepTheirAmplitudeAndPhase(int up, int down, double part) {
        double frequency = part * Math.min(1, (double) up / down); // cycles per input sample
        double[] out = BandlimitedResampler.resample(sine(4000, frequency), up, down);
        assertEquals((4000 * up + down - 1) / down, out.length);
        int edge = 200 * up / down + 1;
        double worst = 0;
        for (int k = edge; k < out.length - edge; k++) {
            double expected = Math.sin(2 * Math.PI * frequency * k * down / up);
            worst = Math.max(worst, Math.abs(out[k] - expected));
        }
        assertTrue(worst < 1e-3, "largest error " + worst);
    }

    /** Ratio below 1 and a frequency above half the lower rate: it must not come back as an alias. */
    @ParameterizedTest
    @CsvSource({"1, 4, 0.126", "1, 4, 0.3", "3, 5, 0.32", "3, 5, 0.45", "1, 2, 0.251"})
    void sinesAboveHalfTheLowerRateVanish(int up, int down, double frequency) {
        double[] out = BandlimitedResampler.resample(sine(8000, frequency), up, down);
        double largest = Arrays.stream(out, out.length / 8, out.length * 7 / 8).map(Math::abs).max().orElseThrow();
        assertTrue(20 * Math.log10(largest) < -60, "left over " + largest);
    }

    /** Images of an upsampled sine: amplitude found by projection onto the image's frequency over whole periods. */
    @Test
    void upsamplingMakesNoImages() {
        double[] out = BandlimitedResampler.resample(sine(4000, 0.4), 4, 1);
        double cos = 0;
        double sin = 0;
        int from = 1000;
        int length = 12_000;
        for (int k = from; k < from + length; k++) {
            cos += out[k] * Math.cos(2 * Math.PI * 0.6 * k / 4) * 2 / length;
            sin += out[k] * Math.sin(2 * Math.PI * 0.6 * k / 4) * 2 / length;
        }
        assertTrue(20 * Math.log10(Math.hypot(cos, sin)) < -60, "image of " + Math.hypot(cos, sin));
    }

    @Test
    void aConstantStaysWhatItIsFromTheFirstSampleToTheLast() {
        double[] constant = new double[300];
        Arrays.fill(constant, 9.81);
        for (double value : BandlimitedResampler.resample(constant, 7, 3)) {
            assertEquals(9.81, value, 1e-12);
        }
    }

    @Test
    void missingSamplesReachNoFurtherThanTheFilter() {
        double[] signal = sine(1000, 0.1);
        double[] whole = BandlimitedResampler.resample(signal, 2, 1);
        signal[500] = Double.NaN;
        double[] holed = BandlimitedResampler.resample(signal, 2, 1);
        int reach = new BandlimitedResampler(2, 1, value -> {}).delay();
        assertEquals(Double.NaN, holed[1000]);
        assertArrayEquals(Arrays.copyOf(whole, 2 * (500 - reach)), Arrays.copyOf(holed, 2 * (500 - reach)));
        assertEquals(whole[2 * (500 + reach)], holed[2 * (500 + reach)]);
    }

    @Test
    void noSampleGivesNothingAndOneSampleAConstant() {
        assertEquals(0, BandlimitedResampler.resample(new double[0], 4, 1).length);
        assertArrayEquals(new double[] {2, 2, 2}, BandlimitedResampler.resample(new double[] {2}, 3, 1), 1e-12);
    }

    @Test
    void upsamplerGivesTheSameValuesBlockByBlock() {
        double[] signal = sine(500, 0.23);
        double[] expected = BandlimitedResampler.resample(signal, 4, 1);
        Upsampler upsampler = Upsampler.reaching(60, 240);
        assertEquals(4, upsampler.factor());
        double[] block = new double[4];
        for (int n = 0; n < 500; n++) {
            boolean came = upsampler.accept(signal[n], block);
            assertEquals(n >= upsampler.delay(), came);
            if (came) {
                int start = 4 * (n - upsampler.delay());
                assertArrayEquals(Arrays.copyOfRange(expected, start, start + 4), block);
            }
        }
        assertFalse(upsampler.delay() > 40);
    }

    @Test
    void factorsNeverFallShortOfTheWantedRate() {
        assertEquals(7, Upsampler.reaching(60, 400).factor());
        assertEquals(1, Upsampler.reaching(500, 400).factor());
        assertThrows(IllegalArgumentException.class, () -> Upsampler.reaching(0, 400));
        assertThrows(IllegalArgumentException.class, () -> new BandlimitedResampler(0, 1, value -> {}));
    }

    private static double[] sine(int length, double frequency) {
        double[] sine = new double[length];
        for (int n = 0; n < length; n++) {
            sine[n] = Math.sin(2 * Math.PI * frequency * n);
        }
        return sine;
    }
}

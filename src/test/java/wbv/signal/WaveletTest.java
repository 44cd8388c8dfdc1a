package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class WaveletTest {

    private static final double RATE = 60;

    private static double[] noise(int length, long seed) {
        Random source = new Random(seed);
        double[] x = new double[length];
        Arrays.setAll(x, i -> source.nextGaussian());
        return x;
    }

    /** Orthonormal to its own even shifts, sum √2, and as many vanishing moments as half its taps. */
    @ParameterizedTest
    @EnumSource
    void filtersAreOrthonormal(Wavelet wavelet) {
        int taps = wavelet.taps();
        for (int shift = 0; shift < taps; shift += 2) {
            double product = 0;
            double cross = 0;
            for (int n = shift; n < taps; n++) {
                product += wavelet.low(n) * wavelet.low(n - shift);
                cross += wavelet.low(n) * wavelet.high(n - shift);
            }
            assertEquals(shift == 0 ? 1 : 0, product, 1e-10);
            assertEquals(0, cross, 1e-10);
        }
        for (int power = 0; power < taps / 2; power++) {
            double moment = 0;
            double size = 0;
            for (int n = 0; n < taps; n++) {
                moment += Math.pow(n - taps / 2.0, power) * wavelet.high(n);
                size += Math.abs(Math.pow(n - taps / 2.0, power) * wavelet.high(n));
            }
            assertEquals(0, moment / size, 1e-8, "moment " + power);
        }
    }

    /** Coefficients of PyWavelets, stored with how they were made. */
    @ParameterizedTest
    @CsvSource({"haar, HAAR", "db4, DAUBECHIES_8", "sym8, SYMLET_16"})
    void coefficientsAreThoseOfPyWavelets(String name, Wavelet wavelet) throws IOException {
        double[] x = new double[64];
        Arrays.setAll(x, n -> Math.sin(0.7 * n) + 0.5 * Math.cos(2.2 * n + 0.3) + 0.01 * n);
        double[][] bands = new WaveletPacket(wavelet, 3).split(x);
        List<String> lines;
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(
                WaveletTest.class.getResourceAsStream("wavelet-packets.csv"), StandardCharsets.UTF_8))) {
            lines = reader.lines().filter(line -> line.startsWith(name + ",")).toList();
        }
        assertEquals(8, lines.size());
        for (int k = 0; k < 8; k++) {
            assertArrayEquals(Arrays.stream(lines.get(k).split(",")).skip(2).mapToDouble(Double::parseDouble).toArray(), bands[k],
                    1e-9);
        }
    }

    @ParameterizedTest
    @EnumSource
    void bandsKeepTheEnergyAndGiveTheSignalBack(Wavelet wavelet) {
        double[] x = noise(512, 1);
        WaveletPacket packet = new WaveletPacket(wavelet, 4);
        assertArrayEquals(x, packet.join(packet.split(x)), 1e-9);
        assertEquals(Arrays.stream(x).map(v -> v * v).sum() / 512, Arrays.stream(packet.power(x)).sum(), 1e-9);
    }

    @Test
    void aToneLiesInItsBand() {
        WaveletPacket packet = new WaveletPacket(Wavelet.SYMLET_16, 4);
        for (int band = 0; band < 16; band++) {
            double f = (band + 0.5) * packet.width(RATE);
            double[] x = new double[1024];
            Arrays.setAll(x, n -> Math.sqrt(2) * Math.sin(2 * Math.PI * f * n / RATE));
            assertTrue(packet.power(x)[band] > 0.6, "band " + band);
        }
        assertThrows(IllegalArgumentException.class, () -> packet.split(new double[1000]));
    }

    @ParameterizedTest
    @CsvSource({"1.0, 0.7, 0.4", "5, 2, -1", "20, 0.3, 2"})
    void aSineGivesItsAmplitudeAndPhase(double f, double amplitude, double phase) {
        double[] x = new double[2400];
        Arrays.setAll(x, n -> amplitude * Math.cos(2 * Math.PI * f * n / RATE + phase));
        MorletTransform.Scalogram scalogram = new MorletTransform(RATE, new double[] {f}, 6).of(x);
        for (int n = 600; n < 1800; n += 37) {
            assertEquals(amplitude, scalogram.values()[0].magnitude(n), 1e-6 * amplitude);
            double expected = 2 * Math.PI * f * n / RATE + phase;
            assertEquals(0, Math.IEEEremainder(scalogram.values()[0].phase(n) - expected, 2 * Math.PI), 1e-6);
            assertTrue(scalogram.trusted(0, n));
        }
    }

    /** The definition in the time domain: the record times the conjugate wavelet, summed, at moments and frequencies. */
    @Test
    void valuesAreTheCorrelationWithTheWavelet() {
        double[] x = noise(600, 2);
        double[] f = {1.5, 4, 9};
        MorletTransform.Scalogram scalogram = new MorletTransform(RATE, f, 6).of(x);
        for (int i = 0; i < f.length; i++) {
            double a = 6 / (2 * Math.PI * f[i]);
            for (int n = 0; n < 600; n += 61) {
                double re = 0;
                double im = 0;
                for (int m = 0; m < 600; m++) {
                    double t = (m - n) / RATE;
                    double weight = 2 / (a * Math.sqrt(2 * Math.PI)) * Math.exp(-t * t / (2 * a * a)) / RATE;
                    re += x[m] * weight * Math.cos(2 * Math.PI * f[i] * t);
                    im -= x[m] * weight * Math.sin(2 * Math.PI * f[i] * t);
                }
                assertEquals(re, scalogram.values()[i].re()[n], 1e-5);
                assertEquals(im, scalogram.values()[i].im()[n], 1e-5);
            }
        }
    }

    /** An impulse at the record's end is felt inwards: its power has fallen to e⁻² where the cone of influence begins. */
    @Test
    void theConeOfInfluenceIsWhereAnEdgeHasFaded() {
        double[] x = new double[6000];
        x[0] = 1;
        double rate = 600;
        MorletTransform.Scalogram scalogram = new MorletTransform(rate, new double[] {5}, 6).of(x);
        int edge = (int) Math.round(scalogram.influence()[0] * rate);
        double ratio = scalogram.values()[0].magnitude(edge) / scalogram.values()[0].magnitude(0);
        assertEquals(Math.exp(-2), ratio * ratio, 0.005);
        assertTrue(scalogram.trusted(0, edge + 1));
        assertFalse(scalogram.trusted(0, edge - 1) || scalogram.trusted(0, 5999));
    }

    /** A sweep's ridge follows its frequency. */
    @Test
    void aSweepIsFollowed() {
        double[] x = new double[3600];
        Arrays.setAll(x, n -> Math.sin(2 * Math.PI * (1 + 8.0 / 120 * n / RATE) * n / RATE));   // 1 to 17 Hz in 60 s
        double[] f = MorletTransform.octaves(0.5, 25, 24);
        MorletTransform.Scalogram scalogram = new MorletTransform(RATE, f, 6).of(x);
        for (int n = 400; n < 3200; n += 100) {
            int best = 0;
            for (int i = 0; i < f.length; i++) {
                best = scalogram.values()[i].magnitude(n) > scalogram.values()[best].magnitude(n) ? i : best;
            }
            double now = 1 + 2 * 8.0 / 120 * n / RATE;
            assertEquals(0, Math.log(f[best] / now) / Math.log(2), 1.5 / 24, "at " + n / RATE + " s");
        }
    }
}

package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MorletTransformTest {

    private static final double RATE = 60;

    private static double[] noise(int length, long seed) {
        Random source = new Random(seed);
        double[] x = new double[length];
        Arrays.setAll(x, i -> source.nextGaussian());
        return x;
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

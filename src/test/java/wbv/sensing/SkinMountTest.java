package wbv.sensing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.recording.DataFault;
import wbv.signal.ComplexSeries;

class SkinMountTest {

    /** A sensor on skin of 20 Hz integrated step by step under a bone that shakes: the correction gives the bone back. */
    @ParameterizedTest
    @CsvSource({"5", "15", "20", "28"})
    void theCorrectionGivesTheBoneBack(double f) {
        SkinMount skin = new SkinMount(20, 0.3);
        double w0 = 2 * Math.PI * 20;
        double w = 2 * Math.PI * f;
        double h = 1e-5;
        double z = 0;
        double v = 0;
        double re = 0;
        double im = 0;
        int from = (int) (2 / h);
        int periods = (int) Math.round(0.5 * f);
        int to = from + (int) Math.round(periods / f / h);
        for (int n = 0; n < to; n++) {
            // Midpoint rule for z'' = -a - 2ζω₀ z' - ω₀² z, sensor a + z'' .
            double t = n * h;
            double a = Math.sin(w * t);
            double relative = -a - 0.6 * w0 * v - w0 * w0 * z;
            double zm = z + h / 2 * v;
            double vm = v + h / 2 * relative;
            double middle = -Math.sin(w * (t + h / 2)) - 0.6 * w0 * vm - w0 * w0 * zm;
            if (n >= from) {
                re += (a + relative) * Math.sin(w * t) * 2 / (to - from);
                im += (a + relative) * Math.cos(w * t) * 2 / (to - from);
            }
            z += h * vm;
            v += h * middle;
        }
        ComplexSeries correction = skin.correction(new double[] {f});
        double c = correction.re()[0];
        double d = correction.im()[0];
        assertEquals(1, re * c - im * d, 2e-3);
        assertEquals(0, re * d + im * c, 2e-3);
    }

    @ParameterizedTest
    @CsvSource({"20, 0.2, 400", "35, 0.3, 1000", "60, 0.4, 1000", "25, 0.35, 200", "12, 0.1, 100"})
    void aTapShowsFrequencyAndDamping(double frequency, double damping, double rate) {
        Random source = new Random(7);
        double square = 0;
        for (int i = 0; i < 10; i++) {
            double w = 2 * Math.PI * frequency;
            double[] record = new double[(int) rate];
            int tap = record.length / 5;
            double phase = 0.5 * source.nextGaussian();
            for (int n = 0; n < record.length; n++) {
                double t = (n - tap) / rate;
                record[n] = (t < 0 ? 0 : 10 * Math.exp(-damping * w * t) * Math.cos(w * Math.sqrt(1 - damping * damping) * t
                        + 0.2 * phase))
                        + 0.05 * source.nextGaussian();
            }
            TapTest.Rung rung = TapTest.fit(record, rate);
            square += Math.pow((rung.mount().frequency() - frequency) / rung.frequencyDeviation(), 2)
                    + Math.pow((rung.mount().damping() - damping) / rung.dampingDeviation(), 2);
            assertEquals(frequency, rung.mount().frequency(), 0.05 * frequency);
            assertTrue(rung.unexplained() < 0.1);
        }
        // Twenty squared deviations, correlated by pairs: their mean is 1 ± 0.4.
        assertEquals(1, square / 20, 1);
    }

    @Test
    void whatNoTapCanShowIsRefused() {
        double[] fast = new double[120];
        for (int n = 40; n < fast.length; n++) {
            fast[n] = 10 * Math.exp(-0.1 * (n - 40)) * Math.cos(2 * Math.PI * 27 * (n - 40) / 60.0);
        }
        assertTrue(assertThrows(DataFault.class, () -> TapTest.fit(fast, 60)).getMessage().contains("below 24"));
        double[] dead = new double[200];
        assertTrue(assertThrows(DataFault.class, () -> TapTest.fit(dead, 60)).getMessage().contains("nothing rings"));
        double[] creeping = new double[200];
        for (int n = 20; n < 200; n++) {
            creeping[n] = Math.exp(-0.2 * (n - 20));
        }
        assertTrue(assertThrows(DataFault.class, () -> TapTest.fit(creeping, 60)).getMessage().contains("does not swing"));
    }
}

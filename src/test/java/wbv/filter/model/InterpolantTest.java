package wbv.filter.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class InterpolantTest {

    /** What is read at a place of the interval from samples of a signal. */
    private static double between(int m, double s, DoubleUnaryOperator signal) {
        double[] samples = new double[2 * m];
        for (int i = 0; i < samples.length; i++) {
            samples[i] = signal.applyAsDouble(i - m + 1);
        }
        double[] c = new double[2 * m];
        new Interpolant(m).coefficients(samples, 0, c);
        double value = 0;
        for (int j = c.length - 1; j >= 0; j--) {
            value = value * s + c[j];
        }
        return value;
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void aConstantPassesUnchanged(int m) {
        for (double s : new double[] {0, 0.3, 0.5, 1}) {
            assertEquals(7, between(m, s, at -> 7), 1e-9);
        }
    }

    /** The largest error anywhere between samples, of any phase; Lagrange's polynomial is wrong by 1.4 % at 14 Hz. */
    @ParameterizedTest
    @CsvSource({"4, 2, 4e-4", "4, 8, 4e-4", "4, 12, 4e-4", "4, 14, 4e-4", "4, 15, 2e-3", "3, 12, 4e-3", "2, 8, 2e-2", "1, 8, 0.09"})
    void aSinePassesNearlyUnchanged(int m, double frequency, double most) {
        double omega = 2 * Math.PI * frequency / 60;
        double worst = 0;
        for (double s = 0; s <= 1; s += 0.05) {
            worst = Math.max(worst, Math.hypot(between(m, s, t -> Math.cos(omega * t)) - Math.cos(omega * s),
                    between(m, s, t -> Math.sin(omega * t)) - Math.sin(omega * s)));
        }
        assertTrue(worst < most, worst + "");
    }
}

package wbv.filter.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.filter.ExactStep;

/** The step of a mode beside {@link ExactStep}, which knows nothing of modes, over all that estimators may ask. */
class ModeStepTest {

    private static final int POINTS = InputWindow.POINTS;

    @ParameterizedTest
    @ValueSource(doubles = {20, 60, 240, 1000})
    void itIsTheGeneralStep(double rate) {
        for (double frequency : new double[] {0.3, 1, 3, 5, 8, 14, 25}) {
            for (double damping : new double[] {0.01, 0.3, 0.999, 1, 1.5, 3}) {
                for (double reference : new double[] {2 * Math.PI, 10 * Math.PI, 50 * Math.PI}) {
                    compare(frequency, damping, reference, rate);
                }
            }
        }
    }

    private static void compare(double frequency, double damping, double reference, double rate) {
        double omega = 2 * Math.PI * frequency;
        double d = 2 * damping * omega;
        double s = omega * omega / reference;
        ExactStep general = new ExactStep(2, 2, POINTS - 1);
        general.set(new double[] {-d, -s, reference, 0}, new double[][] {{-d, -2 * s, 0, 0}, {-d, 0, 0, 0}}, new double[] {1, 0},
                1 / rate);
        ModeStep with = new ModeStep(1 / rate, true);
        ModeStep without = new ModeStep(1 / rate, false);
        with.set(d, s, reference);
        without.set(d, s, reference);
        String where = frequency + " Hz, damping " + damping + ", reference " + reference + ", rate " + rate;
        near(general.transition(), with.transition(), 0, where);
        near(general.transition(), without.transition(), 0, where);
        for (int j = 0; j < POINTS; j++) {
            near(general.gain(j), with.gains(), 2 * j, where);
            near(general.gain(j), without.gains(), 2 * j, where);
        }
        for (int i = 0; i < 2; i++) {
            near(general.transitionSlope(i), with.transitionSlopes(), 4 * i, where);
            for (int j = 0; j < POINTS; j++) {
                near(general.gainSlope(i, j), with.gainSlopes(), 2 * POINTS * i + 2 * j, where);
            }
        }
    }

    /** To rounding of the largest of them: one may be a difference of two that are far larger. */
    private static void near(double[] expected, double[] actual, int from, String where) {
        double largest = 0;
        for (double value : expected) {
            largest = Math.max(largest, Math.abs(value));
        }
        for (int i = 0; i < expected.length; i++) {
            assertEquals(expected[i], actual[from + i], 1e-12 * largest, where);
        }
    }

    @Test
    void whatIsNoNumberIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new ModeStep(1 / 60.0, true).set(Double.NaN, 1, 1));
        assertThrows(IllegalArgumentException.class, () -> new ModeStep(1 / 60.0, false).set(1e9, 1, 1));
    }
}

package wbv.rig;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** From 1000 Hz inside a sensor to its output rate. */
class AntiAliasTest {

    /** REFERENCE 1.3: sinc(f / fs) at 60 Hz. */
    @ParameterizedTest
    @CsvSource({"2,0.998", "5,0.989", "8,0.971", "10,0.955", "12.5,0.930", "16,0.887", "20,0.827", "25,0.738"})
    void boxcarDroopsAsSinc(double f, double expected) {
        assertEquals(expected, throughput(AntiAlias.BOXCAR, 60, f), 1e-3);
    }

    @ParameterizedTest
    @CsvSource({"BOXCAR,0.0899,0.001", "NONE,1,0.01", "LINEAR,0,0.001"})
    void whatLiesAboveHalfTheRateFoldsBackUnlessFiltered(AntiAlias filter, double expected, double tolerance) {
        // 55 Hz shows as 5 Hz; the boxcar lets sinc(55/60) = 0.0899 through.
        assertEquals(expected, throughput(filter, 60, 55), tolerance);
    }

    @Test
    void linearPhaseFilterIsShutFromJustAboveHalfTheRate() {
        assertEquals(0, throughput(AntiAlias.LINEAR, 60, 31.5), 3e-3);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 5, 10, 14, 16.5})
    void linearPhaseFilterIsFlatTo16HzAt60Hz(double f) {
        assertEquals(1, throughput(AntiAlias.LINEAR, 60, f), 3e-3);
    }

    @ParameterizedTest
    @ValueSource(doubles = {60, 100, 256, 1000})
    void boxcarOfAConstantIsTheConstantAtEveryRate(double rate) {
        for (double value : decimate(AntiAlias.BOXCAR, rate, t -> 3.25)) {
            assertEquals(3.25, value, 1e-12);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {60, 100, 256, 1000})
    void boxcarOfARampIsItsMiddle(double rate) {
        double[] values = decimate(AntiAlias.BOXCAR, rate, t -> t);
        for (int n = 0; n < values.length; n++) {
            assertEquals((n - 0.5) / rate, values[n], 1e-11);
        }
    }

    private static double throughput(AntiAlias filter, double rate, double f) {
        double square = 0;
        double[] values = decimate(filter, rate, t -> Math.sin(2 * Math.PI * f * t + 0.3));
        for (double value : values) {
            square += value * value;
        }
        double gain = Math.sqrt(2 * square / values.length);
        // The boxcar takes the mean of a polyline through 1 kHz samples: sinc²(f/1000) is the polyline's, not the sensor's.
        double polyline = Math.pow(Math.sin(Math.PI * f / 1000) / (Math.PI * f / 1000), 2);
        return filter == AntiAlias.BOXCAR ? gain / polyline : gain;
    }

    /** Outputs at 0, 1 / rate, 2 / rate, ... of a signal that has been going on for a second. */
    private static double[] decimate(AntiAlias filter, double rate, DoubleUnaryOperator signal) {
        Decimator decimator = filter.decimators(1000 / rate).get();
        double[] values = new double[1200];
        int tick = -1001;
        for (int n = -50; n < values.length; n++) {
            double instant = n * 1000 / rate;
            while (tick < instant) {
                tick++;
                decimator.accept(signal.applyAsDouble(tick * 0.001));
            }
            double value = decimator.take(instant - (tick - 1));
            if (n >= 0) {
                values[n] = value;
            }
        }
        return values;
    }
}

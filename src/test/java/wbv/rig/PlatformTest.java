package wbv.rig;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.rig.platform.Axis;
import wbv.rig.platform.PlatformCommand;
import wbv.rig.platform.PlatformExcitation;
import wbv.rig.platform.Program;
import wbv.rig.platform.Regime;
import wbv.rig.platform.Seeds;

/** What the platform is told, and what it does. */
class PlatformTest {

    private static final double H = 0.001;

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1, 3, 5, 8, 10, 12})
    void platformIsFlatWithinOnePercentTo12Hz(double f) {
        double expected = 1 / Math.sqrt(1 + Math.pow(f / Hexapod.CORNER, 8));
        double[] gain = platformGain(f);
        for (Axis axis : Axis.values()) {
            assertEquals(expected, gain[axis.ordinal()], 1e-3, axis + ": the Butterworth modulus");
            assertEquals(1, gain[axis.ordinal()], 0.01, axis + ": flat");
        }
    }

    @Test
    void rateAndSpinAreTheDerivativesOfAngle() {
        Hexapod hexapod = new Hexapod(H);
        PlaceMotion platform = new PlaceMotion();
        PlatformCommand drive = Regime.of(6).drive(H, new Seeds(4));
        double[] command = new double[Axis.COUNT];
        double[] angle = new double[3];
        double[] rate = new double[3];
        for (int k = 0; k < 5000; k++) {
            Arrays.fill(command, 0);
            drive.next(Math.min(1, k / 1000.0), command);
            hexapod.step(command, platform);
            for (int i = 0; i < 3 && k > 0; i++) {
                angle[i] += H * (rate[i] + platform.rate[i]) / 2;
                assertEquals(angle[i], platform.angle[i], 1e-6, "integral of the rate");
            }
            System.arraycopy(platform.rate, 0, rate, 0, 3);
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7, 8})
    void everyAxisOfARegimeReachesItsLevelWithin2Percent(int number) {
        for (long seed = 1; seed <= 4; seed++) {
            double[] rms = regimeRms(number, seed, 120_000);
            for (Axis axis : Axis.values()) {
                double target = Regime.of(number).rms(axis);
                assertEquals(target, rms[axis.ordinal()], 0.02 * target, axis + " of regime " + number + ", seed " + seed);
            }
        }
    }

    @Test
    void sweepRunsFrequencyAndAmplitudeTogether() {
        PlatformCommand drive = PlatformExcitation.Sweep.chapter4(60).drive(H, new Seeds(1));
        double[] command = new double[Axis.COUNT];
        for (int k = 0; k <= 59_999; k++) {
            command[2] = 0;
            drive.next(1, command);
            double t = k * H;
            double phase = 2 * Math.PI * (t + 8 * t * t / 120);
            assertEquals((0.1 + 2.4 * t / 60) * Math.sin(phase), command[2], 1e-9, "at " + t);
        }
        double before = command[2];
        command[2] = 0;
        drive.next(1, command);
        assertTrue(Math.abs(before) < 2.5 * 2 * Math.PI * 9 * H + 0.1, "300 whole cycles: the run ends near zero");
        assertEquals(0, command[2], 1e-9, "and begins again there");
    }

    /** Power in eighths of the band; 40 windows over 8 minutes. Standard error of an eighth about 4 %. */
    @Test
    void randomMotionIsFlatInItsBandAndNearlyNormal() {
        PlatformCommand drive = new PlatformExcitation.Random(Axis.Z, 1, 9, 2).drive(H, new Seeds(11));
        int n = 1024;
        double[] band = new double[8];
        double outside = 0;
        double square = 0;
        double fourth = 0;
        int windows = 80;
        double[] command = new double[Axis.COUNT];
        FastFourierTransformer fft = new FastFourierTransformer(DftNormalization.STANDARD);
        for (int w = 0; w < windows; w++) {
            double[] x = new double[n];
            for (int i = 0; i < n; i++) {
                for (int skip = 0; skip < 10; skip++) {
                    command[2] = 0;
                    drive.next(1, command);
                }
                square += command[2] * command[2];
                fourth += Math.pow(command[2], 4);
                x[i] = command[2] * (1 - Math.cos(2 * Math.PI * i / n));
            }
            Complex[] spectrum = fft.transform(x, TransformType.FORWARD);
            for (int i = 0; i < n / 2; i++) {
                double f = i * 100.0 / n;
                double power = Math.pow(spectrum[i].abs(), 2);
                if (f > 1.2 && f < 8.8) {
                    band[(int) ((f - 1.2) / 7.6 * 8)] += power;
                } else if (f < 0.6 || f > 9.4) {
                    outside += power;
                }
            }
        }
        double samples = (double) windows * n;
        double mean = Arrays.stream(band).average().orElseThrow();
        for (double b : band) {
            assertEquals(mean, b, 0.15 * mean);
        }
        assertTrue(outside < 0.002 * 8 * mean, "out of band: " + outside / (8 * mean));
        assertEquals(2, Math.sqrt(square / samples), 0.04, "level");
        assertEquals(3, fourth / samples / Math.pow(square / samples, 2), 0.2, "kurtosis");
    }

    @Test
    void segmentsSwellAndFadeWithoutJumps() {
        PlatformCommand drive = new Program(List.of(
                new Program.Segment(new PlatformExcitation.Sine(Axis.X, 2, 1), 2),
                new Program.Segment(new PlatformExcitation.Sine(Axis.Z, 3, 1), 2))).drive(H, new Seeds(1));
        double[] command = new double[Axis.COUNT];
        double[] previous = new double[Axis.COUNT];
        for (int k = 0; k < 5000; k++) {
            Arrays.fill(command, 0);
            drive.next(1, command);
            assertEquals(previous[0], command[0], 0.02, "at step " + k);
            assertEquals(previous[2], command[2], 0.025, "at step " + k);
            assertTrue(k < 2000 ? command[2] == 0 : command[0] == 0, "one segment at a time");
            if (k > 4000) {
                assertEquals(0, command[2], "over");
            }
            System.arraycopy(command, 0, previous, 0, Axis.COUNT);
        }
    }

    private static double[] platformGain(double f) {
        Hexapod hexapod = new Hexapod(H);
        PlaceMotion platform = new PlaceMotion();
        double[] command = new double[Axis.COUNT];
        double[] re = new double[Axis.COUNT];
        double[] im = new double[Axis.COUNT];
        int steps = (int) Math.round(2 / H);
        for (int k = 1; k <= 60_000 + steps; k++) {
            double phase = 2 * Math.PI * f * k * H;
            Arrays.fill(command, Math.sin(phase));
            hexapod.step(command, platform);
            for (int i = 0; i < Axis.COUNT && k > 60_000; i++) {
                double y = i < 3 ? platform.acceleration[i] : platform.rate[i - 3];
                re[i] += y * Math.sin(phase);
                im[i] += y * Math.cos(phase);
            }
        }
        for (int i = 0; i < Axis.COUNT; i++) {
            re[i] = 2 * Math.hypot(re[i], im[i]) / steps;
        }
        return re;
    }

    private static double[] regimeRms(int number, long seed, int steps) {
        Hexapod hexapod = new Hexapod(H);
        PlaceMotion platform = new PlaceMotion();
        PlatformCommand drive = Program.of(new PlatformExcitation.OfRegime(number), steps * H).drive(H, new Seeds(seed));
        double[] command = new double[Axis.COUNT];
        double[] square = new double[Axis.COUNT];
        for (int k = 0; k < steps; k++) {
            Arrays.fill(command, 0);
            drive.next(1, command);
            hexapod.step(command, platform);
            for (int i = 0; i < Axis.COUNT; i++) {
                double y = i < 3 ? platform.acceleration[i] : platform.rate[i - 3];
                square[i] += y * y;
            }
        }
        for (int i = 0; i < Axis.COUNT; i++) {
            square[i] = Math.sqrt(square[i] / steps);
        }
        return square;
    }
}

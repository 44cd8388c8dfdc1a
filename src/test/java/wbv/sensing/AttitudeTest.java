package wbv.sensing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

class AttitudeTest {

    private static final double RATE = 60;
    private static final double G = 9.80665;

    /** Pitching and shaken: pitch 0.15 sin(2π 0.4 t) + 0.1, world acceleration in three tones; closed form throughout. */
    @Test
    void gravityAndGyroscopeGiveTheFreeAcceleration() {
        Attitude attitude = new Attitude(RATE, 20, Double.POSITIVE_INFINITY);
        Random source = new Random(1);
        double[] bias = {0.004, -0.006, 0.002};
        double tilt = 0;
        double free = 0;
        int count = 0;
        for (int n = 0; n < 240 * RATE; n++) {
            double t = n / RATE;
            double w = 2 * Math.PI * 0.4;
            // The rate over a step turns the sensor from the last sample to this one.
            double pitch = 0.1 + 0.15 * Math.sin(w * t);
            double before = 0.1 + 0.15 * Math.sin(w * (t - 1 / RATE));
            double[] world = {0.8 * Math.sin(2 * Math.PI * 2 * t), 0.5 * Math.cos(2 * Math.PI * 3.1 * t),
                Math.sin(2 * Math.PI * 5 * t)};
            Orientation truth = Orientation.of(Math.cos(pitch / 2), 0, Math.sin(pitch / 2), 0);
            double[] specific = {world[0], world[1], world[2] + G};
            truth.inward(specific, specific);
            double[] rate = {bias[0], bias[1] + (pitch - before) * RATE, bias[2]};
            for (int j = 0; j < 3; j++) {
                specific[j] += 0.0107 * source.nextGaussian();
                rate[j] += 0.001 * source.nextGaussian();
            }
            attitude.accept(specific, rate);
            if (t > 120) {
                double[] up = {0, 0, 1};
                attitude.orientation().inward(up, up);
                truth.outward(up, up);
                tilt = Math.max(tilt, Math.acos(Math.min(1, up[2])));
                double[] own = new double[3];
                double[] expected = new double[3];
                attitude.freeInSensor(specific, own);
                truth.inward(world, expected);
                for (int j = 0; j < 3; j++) {
                    free += Math.pow(own[j] - expected[j], 2);
                }
                count += 3;
            }
        }
        assertTrue(tilt < 0.006, "tilt off by " + Math.toDegrees(tilt) + "°");
        assertTrue(Math.sqrt(free / count) < 0.03, "free acceleration off by " + Math.sqrt(free / count));
        assertEquals(bias[0], attitude.bias()[0], 1e-3);
        assertEquals(bias[1], attitude.bias()[1], 1e-3);
    }

    /** The rig's head sensor with gravity in, beside the same ride with gravity removed by the rig itself. */
    @Test
    void theRigsFreeAccelerationIsFound() {
        String ride = "subject=1 regime=2 seconds=60 seed=4 channels=head effects=usual ";
        Recording with = RigSpec.parse(ride + "gravity=included").recording();
        Recording without = RigSpec.parse(ride + "gravity=removed").recording();
        Attitude attitude = new Attitude(RATE, 20, Double.POSITIVE_INFINITY);
        double[][] specific = columns(with, "head.accg.");
        double[][] rate = columns(with, "head.gyr.");
        double[][] free = columns(without, "head.acc.");
        double error = 0;
        double power = 0;
        for (int n = 0; n < with.length(); n++) {
            double[] f = {specific[0][n], specific[1][n], specific[2][n]};
            attitude.accept(f, new double[] {rate[0][n], rate[1][n], rate[2][n]});
            double[] out = new double[3];
            attitude.free(f, out);
            for (int j = 0; n > 1200 && j < 3; j++) {
                // A constant tilt of the sensor leaks gravity into the rig's own; it is not what is compared.
                double expected = free[j][n] - mean(free[j]);
                error += Math.pow(out[j] - expected, 2);
                power += expected * expected;
            }
        }
        assertTrue(Math.sqrt(error / power) < 0.1, "off by " + Math.sqrt(error / power));
    }

    private static double[][] columns(Recording recording, String name) {
        return List.of("x", "y", "z").stream().map(axis -> recording.values(Channel.parse(name + axis))).toArray(double[][]::new);
    }

    private static double mean(double[] values) {
        return java.util.Arrays.stream(values).average().orElseThrow();
    }

    @Test
    void aHeadingThatIsHeldComesBack() {
        Attitude held = new Attitude(RATE, 10, 5);
        Attitude kept = new Attitude(RATE, 10, Double.POSITIVE_INFINITY);
        for (int n = 0; n < 30 * RATE; n++) {
            double[] rate = {0, 0, n < RATE ? 0.5 : 0};
            held.accept(new double[] {0, 0, G}, rate);
            kept.accept(new double[] {0, 0, G}, rate);
        }
        assertEquals(0.5, kept.orientation().heading(), 1e-9);
        assertEquals(0.5 * Math.exp(-29.5 / 5), held.orientation().heading(), 3e-4);
    }

    @Test
    void missingSamplesAreCrossed() {
        Attitude whole = new Attitude(RATE, 10, Double.POSITIVE_INFINITY);
        Attitude holed = new Attitude(RATE, 10, Double.POSITIVE_INFINITY);
        double[] none = {Double.NaN, Double.NaN, Double.NaN};
        for (int n = 0; n < 20 * RATE; n++) {
            double[] f = {0, G * Math.sin(0.2), G * Math.cos(0.2)};
            boolean lost = n == 0 || n % 50 > 46;
            whole.accept(f, new double[3]);
            holed.accept(lost ? none : f, lost ? none : new double[3]);
        }
        double[] up = {0, 0, 1};
        double[] other = {0, 0, 1};
        whole.orientation().inward(up, up);
        holed.orientation().inward(other, other);
        assertArrayEquals(up, other, 1e-9);
        assertArrayEquals(new double[] {0, Math.sin(0.2), Math.cos(0.2)}, other, 1e-9);
    }

    /** A bar that swings in several tones to 18 Hz while its one end shakes: the other end, in closed form. */
    @Test
    void theFarEndOfABarFollowsFromTheNearOne() {
        double[] arm = {0.1, -0.05, 0.3};
        LeverArm lever = new LeverArm(RATE, arm);
        double[] tones = {1.3, 6, 18};
        double[] size = {0.2, 0.01, 0.002};
        double worst = 0;
        double largest = 0;
        double[][] expected = new double[2000][3];
        for (int n = 0; n < 2000; n++) {
            double t = n / RATE;
            double angle = 0;
            double rate = 0;
            double turning = 0;
            for (int i = 0; i < 3; i++) {
                double w = 2 * Math.PI * tones[i];
                angle += size[i] * Math.sin(w * t);
                rate += size[i] * w * Math.cos(w * t);
                turning -= size[i] * w * w * Math.sin(w * t);
            }
            double[] near = {Math.sin(20 * t), 0.5 * Math.cos(9 * t), Math.cos(31 * t)};
            // Far end: origin + R_y(angle) arm; twice differentiated in the world, then turned into the bar's axes.
            double c = Math.cos(angle);
            double s = Math.sin(angle);
            double px = c * arm[0] + s * arm[2];
            double pz = -s * arm[0] + c * arm[2];
            double[] far = {near[0] + turning * pz - rate * rate * px, near[1], near[2] - turning * px - rate * rate * pz};
            Orientation bar = Orientation.of(Math.cos(angle / 2), 0, Math.sin(angle / 2), 0);
            bar.inward(near, near);
            bar.inward(far, expected[n]);
            double[] out = new double[3];
            lever.accept(near, new double[] {0, rate, 0}, out);
            int then = n - lever.delay();
            for (int j = 0; j < 3 && n >= 2 * lever.delay(); j++) {
                worst = Math.max(worst, Math.abs(out[j] - expected[then][j]));
                largest = Math.max(largest, Math.abs(expected[then][j]));
            }
        }
        assertTrue(largest > 5 && worst < 2e-3 * largest, worst + " of " + largest);
    }
}

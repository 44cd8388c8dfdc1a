package wbv.rig;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.rig.platform.Seeds;

/** The sensors' errors, one by one. */
class ImuTest {

    private static final String REST = "sitter=one-dof excitation=idle channels=head ";

    /** 200 µg/√Hz and 0.01 °/s/√Hz over 30 Hz are 0.0107 m/s² and 0.055 °/s; 3600 samples: standard error 1.2 %. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void noiseHasTheDensityOfTheDataSheet(long seed) {
        double[][] rows = read(RigSpec.parse(REST + "effects=noise seconds=60").withSeed(seed));
        for (int channel = 1; channel <= 6; channel++) {
            double expected = channel <= 3 ? 0.0107 : 0.055 * Math.PI / 180;
            assertEquals(expected, deviation(rows, channel), 0.05 * expected, "channel " + channel);
            assertEquals(0, correlation(rows, channel, channel % 6 + 1), 0.06, "channels are independent");
            assertEquals(0, lagged(rows, channel), 0.06, "samples are independent");
        }
    }

    /** Offsets of 40 sensors: the standard deviation is the data sheet's, standard error 11 %. */
    @Test
    void biasScattersFromSensorToSensorAsTheDataSheetSays() {
        double acceleration = 0;
        double rate = 0;
        int count = 40;
        for (long seed = 1; seed <= count; seed++) {
            double[] row = read(RigSpec.parse(REST + "effects=bias seconds=0.05").withSeed(seed))[1];
            acceleration += (row[1] * row[1] + row[2] * row[2] + row[3] * row[3]) / 3;
            rate += (row[4] * row[4] + row[5] * row[5] + row[6] * row[6]) / 3;
        }
        assertEquals(0.1e-3 * 9.80665, Math.sqrt(acceleration / count), 0.3e-3);
        assertEquals(Math.toRadians(10.0 / 3600), Math.sqrt(rate / count), 1.5e-5);
    }

    @Test
    void gravityLeaksThroughTiltAsItsSine() {
        for (long seed = 1; seed <= 5; seed++) {
            RigSpec spec = RigSpec.parse(REST + "effects=tilt seconds=1").withSeed(seed);
            RigRun run = spec.run();
            double tiltX = run.sensorErrors().get("head.tilt.x");
            double tiltY = run.sensorErrors().get("head.tilt.y");
            double[] row = read(spec)[10];
            double angle = Math.hypot(tiltX, tiltY);
            assertEquals(-9.80665 * Math.sin(angle) * tiltY / angle, row[1], 1e-9);
            assertEquals(9.80665 * Math.sin(angle) * tiltX / angle, row[2], 1e-9);
            assertEquals(9.80665 * (Math.cos(angle) - 1), row[3], 1e-9);
        }
    }

    @Test
    void specificForceAtRestPointsUp() {
        double[] row = read(RigSpec.parse(REST + "gravity=included effects=none seconds=1"))[30];
        assertEquals(0, row[1], 1e-12);
        assertEquals(9.80665, row[3], 1e-12);
    }

    /** A platform that turns about y turns gravity into x of what stands on it, and specific force says so. */
    @Test
    void specificForceFollowsTheTurningSegment() {
        double w = 2 * Math.PI * 0.2;
        double[][] rows = read(RigSpec.parse("sitter=one-dof excitation=sine:pitch:0.2:0.05 effects=none seconds=90 "
                + "channels=platform.accg.x,platform.gyr.y"));
        double leak = 0;
        double rate = 0;
        for (int i = 4800; i < rows.length; i++) {
            leak = Math.max(leak, Math.abs(rows[i][1]));
            rate = Math.max(rate, Math.abs(rows[i][2]));
        }
        assertEquals(9.80665 * rate / w, leak, 0.02 * leak);
    }

    @Test
    void theFieldOfTheEarthTurnsWithTheSensor() {
        double[] row = read(RigSpec.parse("sitter=one-dof excitation=idle effects=none seconds=1 "
                + "channels=head.mag.x,head.mag.y,head.mag.z"))[30];
        assertEquals(1, Math.hypot(row[1], row[3]), 1e-12);
        assertEquals(64, Math.toDegrees(Math.atan2(row[3], row[1])), 1e-9, "dip, upwards");
        double w = 2 * Math.PI * 0.2;
        double side = 0;
        double rate = 0;
        for (double[] turning : read(RigSpec.parse("sitter=one-dof excitation=sine:yaw:0.2:0.05 effects=none seconds=90 "
                + "channels=platform.mag.y,platform.gyr.z"))) {
            boolean settled = turning[0] > 75;
            side = settled ? Math.max(side, Math.abs(turning[1])) : 0;
            rate = settled ? Math.max(rate, Math.abs(turning[2])) : 0;
        }
        assertEquals(Math.cos(Math.toRadians(64)) * Math.sin(rate / w), side, 0.02 * side);
    }

    /** 300 sensors over ten minutes each: 10 °/h in the mean, and after 100 s an e-th of it is remembered. */
    @Test
    void offsetsWalkSlowlyAndComeBack() {
        double square = 0;
        double product = 0;
        for (int sensor = 0; sensor < 300; sensor++) {
            SlowWalk walk = new SlowWalk(2, 10, new Seeds(sensor).source("walk"));
            double[] value = new double[60];
            for (int i = 0; i < value.length; i++) {
                value[i] = walk.next();
                square += value[i] * value[i];
                product += i < 10 ? 0 : value[i] * value[i - 10] * 60 / 50;
            }
        }
        assertEquals(4, square / 300 / 60, 0.4);
        assertEquals(Math.exp(-1), product / square, 0.05);
    }

    @Test
    void accelerationIsClippedAtTheRange() {
        double[][] rows = read(RigSpec.parse("sitter=one-dof excitation=sine:z:2:300 effects=none seconds=3 "
                + "channels=platform.acc.z"));
        double largest = 0;
        int clipped = 0;
        for (double[] row : rows) {
            largest = Math.max(largest, Math.abs(row[1]));
            clipped += Math.abs(row[1]) > 160 - 1e-9 ? 1 : 0;
        }
        assertEquals(160, largest, 1e-9);
        assertTrue(clipped > 60, "long runs: " + clipped);
    }

    /** 1 % of 60 000 packets in bursts of 3 on average: standard error 0.09 % and 0.1. */
    @Test
    void packetsAreLostInBursts() {
        double[][] rows = read(RigSpec.parse("sitter=one-dof excitation=idle channels=head.acc.z,head.gyr.x,platform.acc.z "
                + "effects=loss seconds=1000"));
        int lost = 0;
        int bursts = 0;
        int together = 0;
        for (int i = 1; i < rows.length; i++) {
            boolean gone = Double.isNaN(rows[i][1]);
            assertEquals(gone, Double.isNaN(rows[i][2]), "a packet holds all channels of a sensor");
            lost += gone ? 1 : 0;
            bursts += gone && !Double.isNaN(rows[i - 1][1]) ? 1 : 0;
            together += gone && Double.isNaN(rows[i][3]) ? 1 : 0;
        }
        assertEquals(0.01, (double) lost / rows.length, 0.003);
        assertEquals(3, (double) lost / bursts, 0.6);
        assertTrue(together < 0.2 * lost, "sensors lose apart");
    }

    @Test
    void resolutionSendsShortNumbers() {
        for (double[] row : read(RigSpec.parse("sitter=one-dof channels=head effects=noise,resolution seconds=5"))) {
            assertEquals(row[1], Math.rint(row[1] * 1e4) / 1e4);
            assertTrue(Double.toString(row[1]).length() <= 8, "short: " + row[1]);
            assertEquals(row[4], Math.rint(row[4] * 1e5) / 1e5);
        }
    }

    /** Bandwidth and step are one for all sensors, so what is left of an ideal record differs by the 184 Hz pole alone. */
    @ParameterizedTest
    @EnumSource(AntiAlias.class)
    void withoutEffectsASensorIsIdealButForItsBandwidth(AntiAlias filter) {
        RigSpec spec = RigSpec.oneDof(0.3, 5, 1, 10, 1).withEffects(Effects.NONE).withFilter(filter);
        RigRun run = spec.run();
        double[] row = new double[3];
        double[] ideal = new double[3];
        double difference = 0;
        double power = 0;
        while (run.read(row)) {
            run.ideal(ideal);
            difference += Math.pow(row[2] - ideal[2], 2);
            power += ideal[2] * ideal[2];
        }
        // |1 - 1/(1 + jf/184)| at about 5 Hz
        assertEquals(5 / 184.0, Math.sqrt(difference / power), 0.012);
    }

    static double[][] read(RigSpec spec) {
        RigRun run = spec.run();
        double[][] rows = new double[(int) spec.rows()][1 + spec.channels().size()];
        for (double[] row : rows) {
            assertTrue(run.read(row));
        }
        return rows;
    }

    private static double deviation(double[][] rows, int channel) {
        return Math.sqrt(covariance(rows, channel, channel, 0));
    }

    private static double correlation(double[][] rows, int one, int other) {
        return covariance(rows, one, other, 0) / deviation(rows, one) / deviation(rows, other);
    }

    private static double lagged(double[][] rows, int channel) {
        return covariance(rows, channel, channel, 1) / covariance(rows, channel, channel, 0);
    }

    private static double covariance(double[][] rows, int one, int other, int lag) {
        double sum = 0;
        for (int i = lag; i < rows.length; i++) {
            sum += rows[i][one] * rows[i - lag][other];
        }
        return sum / (rows.length - lag);
    }
}

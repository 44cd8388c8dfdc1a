package wbv.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** The lag of a head that moves as the seat did a known time ago, and none where nothing tells it. */
class HeadLagTest {

    private static final double RATE = 60;

    /** Jolts as on a rough track: A sin(2πt/T) sin(πt/T) every three seconds, over vibration at 5 to 8 Hz. */
    private record Track(double[] heights, double[] times, double[] phases, double vibration) {
        static Track of(int jolts, double vibration, Random random) {
            double[] heights = random.doubles(jolts, 4, 9).map(each -> random.nextBoolean() ? each : -each).toArray();
            return new Track(heights, random.doubles(jolts, 0.3, 0.6).toArray(), random.doubles(8, 0, 6.28).toArray(), vibration);
        }

        double at(double t) {
            double sum = 0;
            for (int i = 0; i < phases.length; i++) {
                sum += vibration * Math.sqrt(2.0 / phases.length) * Math.sin(2 * Math.PI * (5 + 0.41 * i) * t + phases[i]);
            }
            int jolt = (int) Math.floor(t / 3) - 4;
            double into = t - 3 * (jolt + 4);
            if (jolt >= 0 && jolt < heights.length && into < times[jolt]) {
                double turn = Math.PI * into / times[jolt];
                sum += heights[jolt] * Math.sin(2 * turn) * Math.sin(turn);
            }
            return sum;
        }
    }

    private static HeadLag follow(DoubleUnaryOperator seat, DoubleUnaryOperator head, double seconds, double noise, double halfLife,
            Random random) {
        HeadLag lag = new HeadLag(RATE, Thresholds.USUAL.surge(), halfLife);
        for (int i = 0; i < seconds * RATE; i++) {
            lag.accept(seat.applyAsDouble(i / RATE) + noise * random.nextGaussian(),
                    head.applyAsDouble(i / RATE) + noise * random.nextGaussian());
        }
        return lag;
    }

    /** Two standard deviations hold the lag as often as they say, and it is right in the mean. */
    @Test
    void deviationIsWhatTheLagIsOff() {
        int inside = 0;
        double sum = 0;
        double squares = 0;
        int rides = 200;
        for (int seed = 0; seed < rides; seed++) {
            Random random = new Random(seed);
            double known = 0.005 + 0.04 * random.nextDouble();
            Track track = Track.of(3 + seed % 12, 0.5, random);
            HeadLag lag = follow(track::at, t -> track.at(t - known), 15 + 3 * track.heights.length, 0.3, Double.POSITIVE_INFINITY, random);
            HeadLag.Lag said = lag.lag().orElseThrow(() -> new AssertionError("no lag of " + lag.jolts() + " jolts"));
            double off = (said.seconds() - known) / said.deviation();
            inside += Math.abs(off) <= 2 ? 1 : 0;
            sum += said.seconds() - known;
            squares += (said.seconds() - known) * (said.seconds() - known);
        }
        // 95.4 % wanted; of 200 rides 2.6 standard deviations of the share are 4 %.
        assertTrue(inside >= 0.915 * rides && inside <= 0.995 * rides, inside + " of " + rides);
        assertEquals(0, sum / rides, 3 * Math.sqrt(squares) / rides);
    }

    @Test
    void steadyMotionTellsNoLag() {
        Random random = new Random(1);
        Track steady = new Track(new double[0], new double[0], Track.of(0, 1, random).phases, 2.5);
        DoubleUnaryOperator sine = t -> 3 * Math.sin(2 * Math.PI * 2 * t);
        for (DoubleUnaryOperator motion : new DoubleUnaryOperator[] {t -> 0, steady::at, sine, t -> 2 * random.nextGaussian()}) {
            HeadLag lag = follow(motion, t -> motion.applyAsDouble(t - 0.024), 300, 0.01, Double.POSITIVE_INFINITY, random);
            assertEquals(Optional.empty(), lag.lag(), lag.jolts() + " jolts");
        }
    }

    @Test
    void headThatDoesNotFollowHasNoLagThatIsSure() {
        Random random = new Random(2);
        Track track = Track.of(20, 0.2, random);
        HeadLag lag = follow(track::at, t -> 5 * random.nextGaussian(), 75, 0, Double.POSITIVE_INFINITY, random);
        assertTrue(lag.lag().map(HeadLag.Lag::deviation).orElse(1.0) > 0.004, lag.lag().toString());
    }

    @Test
    void oldJoltsAreForgotten() {
        Random random = new Random(3);
        Track track = Track.of(60, 0.3, random);
        DoubleUnaryOperator head = t -> track.at(t - (t < 100 ? 0.015 : 0.03));
        assertEquals(0.03, follow(track::at, head, 192, 0.05, 10, random).lag().orElseThrow().seconds(), 0.001);
        assertTrue(follow(track::at, head, 192, 0.05, Double.POSITIVE_INFINITY, random).lag().orElseThrow().seconds() < 0.027);
    }

    /** A sample that is lost spoils its jolt and no other. */
    @Test
    void lostSamplesCostTheirJolt() {
        Random random = new Random(4);
        Track track = Track.of(10, 0.3, random);
        HeadLag whole = follow(track::at, t -> track.at(t - 0.02), 45, 0, Double.POSITIVE_INFINITY, random);
        HeadLag holed = follow(track::at, t -> Math.abs(t - 18.2) < 0.01 ? Double.NaN : track.at(t - 0.02), 45, 0,
                Double.POSITIVE_INFINITY, random);
        assertEquals(10, whole.jolts());
        assertEquals(9, holed.jolts());
        assertEquals(0.02, holed.lag().orElseThrow().seconds(), 5e-4);
    }

    /** The derivative of t⁴ and of all below it is exact, and 8 Hz is read to a twentieth. */
    @Test
    void slopeIsThatOfAPolynomial() {
        for (double rate : new double[] {60, 100, 1000}) {
            Slope slope = new Slope(rate);
            double late = Slope.delay(rate) / rate;
            double last = 0;
            double t = 0;
            for (int i = 0; i < rate; i++) {
                t = i / rate;
                last = slope.step(1 - 2 * t + 3 * t * t - t * t * t + 0.5 * t * t * t * t);
            }
            double at = t - late;
            assertEquals(-2 + 6 * at - 3 * at * at + 2 * at * at * at, last, 1e-9);
        }
        Slope slope = new Slope(RATE);
        double most = 0;
        for (int i = 0; i < 600; i++) {
            double value = slope.step(Math.sin(2 * Math.PI * 8 * i / RATE));
            most = i < 10 ? 0 : Math.max(most, Math.abs(value));
        }
        assertEquals(1, most / (2 * Math.PI * 8), 0.05);
    }
}

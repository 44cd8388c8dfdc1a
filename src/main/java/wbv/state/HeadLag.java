package wbv.state;

import java.io.Serializable;
import java.util.Arrays;
import java.util.Optional;
import org.apache.commons.math3.distribution.TDistribution;

/**
 * How much later the head jerks than the seat, as a stream, in memory that does not grow.
 *
 * <p>Only edges tell a lag: in steady vibration the head is ahead of the seat by one lag and behind it by another alike. An edge is a
 * {@link Surge} of the seat beyond what a jolt has and beyond six standard deviations of what surges usually, of which the median
 * tells; what that is takes eight seconds to learn. The jerks of seat and head from {@value #BEFORE} s before to {@value #AFTER} s after
 * are correlated at all lags up to a quarter of a second, every jolt over its own strength, so that each counts alike. The lag is where the
 * sum of these is greatest, by a parabola through the three samples about.
 *
 * <p>The deviation is that of a root of a sum of estimating equations, one a jolt (the sandwich of P. J. Huber, Proc. 5th Berkeley
 * Symp. 1 (1967) 221-233): what the jolts' slopes at the lag scatter, over the curvature. It is widened so that ±2 of it hold the
 * lag in 95 % however few the jolts (Student). Below three jolts there is no lag.
 */
public final class HeadLag implements Serializable {

    private static final long serialVersionUID = 1;
    private static final double LONGEST = 0.25;
    private static final double BEFORE = 0.4;
    private static final double AFTER = 0.35;
    private static final double OUTSTANDING = 6;
    /** Median of the amount of a standard normal variable. */
    private static final double MEDIAN = 0.6745;
    /** Time in which the median follows by a factor of e when all is above or below it [s]. */
    private static final double SETTLING = 4;
    private static final double FEWEST = 3;
    /** P(a normal variable &lt; 2). */
    private static final double TWO_SIGMA = 0.97725;

    private final double rate;
    private final double threshold;
    private final double least;
    private final double memory;
    private final Slope seat;
    private final Slope head;
    private final Surge surge;
    private final int longest;
    private final int before;
    private final int after;
    private final double[] seats;
    private final double[] heads;
    private final double[] jolt;
    private final double[] sum;
    /** Sum over jolts of the products of their correlations at two lags, the second 0 to 2 samples after the first. */
    private final double[][] products;
    private double seatPower;
    private double headPower;
    private double usual;
    private double weight;
    private double squares;
    private long taken;
    private long jolts;
    private long start = Long.MAX_VALUE;
    private long end = Long.MIN_VALUE;
    private long joltAt;

    /**
     * What the jolts so far say.
     *
     * @param seconds by which the head is later
     * @param deviation of it [s]
     * @param jolts number of those that count
     */
    public record Lag(double seconds, double deviation, double jolts) {}

    /**
     * Has met no jolt yet.
     *
     * @param rate     of the samples [Hz], 20 to 100 000
     * @param threshold surge of a jolt [m/s²], such as that of {@link Thresholds}
     * @param halfLife time after which a jolt counts half [s]; infinite to forget none
     */
    public HeadLag(double rate, double threshold, double halfLife) {
        if (!(rate >= 20 && rate <= 100_000 && threshold > 0 && halfLife > 0)) {
            throw new IllegalArgumentException("a lag needs 20 to 100 000 Hz, a threshold and a half-life > 0: " + rate + ", "
                    + threshold + ", " + halfLife);
        }
        this.rate = rate;
        this.threshold = threshold;
        this.memory = Math.log(0.5) / (halfLife * rate);
        seat = new Slope(rate);
        head = new Slope(rate);
        surge = new Surge(rate);
        longest = samples(LONGEST);
        before = samples(BEFORE) + Slope.delay(rate);
        after = samples(AFTER);
        seats = new double[before + 2 * longest + 1];
        heads = new double[seats.length];
        jolt = new double[2 * longest + 1];
        sum = new double[jolt.length];
        products = new double[jolt.length][3];
        // Where surges are usually as small as this, the threshold itself decides; lower, the median would be late when a ride begins.
        least = threshold / OUTSTANDING * MEDIAN / Math.E;
        usual = least;
        Arrays.fill(seats, Double.NaN);
        Arrays.fill(heads, Double.NaN);
    }

    private int samples(double seconds) {
        return Math.max(1, (int) Math.round(seconds * rate));
    }

    /**
     * Takes vertical accelerations; NaN is missing, and spoils its jolt.
     *
     * @param seatAcceleration [m/s²]
     * @param headAcceleration [m/s²]
     * @return whether a jolt has been counted now
     */
    public boolean accept(double seatAcceleration, double headAcceleration) {
        int at = (int) (taken % seats.length);
        seats[at] = seat.step(seatAcceleration);
        heads[at] = head.step(headAcceleration);
        watch(surge.step(seatAcceleration));
        long centre = taken++ - before - longest;
        if (centre >= start && centre <= end) {
            correlate(centre);
        }
        if (centre < end || start == Long.MAX_VALUE) {
            return false;
        }
        start = Long.MAX_VALUE;
        return count(centre);
    }

    /** Opens a jolt, or lets it go on. */
    private void watch(double now) {
        if (Double.isNaN(now)) {
            return;
        }
        boolean edge = now > threshold && now > OUTSTANDING * usual / MEDIAN && taken > 2 * SETTLING * rate;
        usual = Math.max(least, usual * Math.exp(Math.signum(now - usual) / (SETTLING * rate)));
        if (!edge) {
            return;
        }
        if (start == Long.MAX_VALUE) {
            start = Math.max(taken - before, end + 1);
            Arrays.fill(jolt, 0);
            seatPower = 0;
            headPower = 0;
        }
        end = taken + after;
    }

    private void correlate(long centre) {
        double s = seats[(int) Math.floorMod(centre, (long) seats.length)];
        double h = heads[(int) Math.floorMod(centre, (long) seats.length)];
        seatPower += s * s;
        headPower += h * h;
        for (int lag = -longest; lag <= longest; lag++) {
            jolt[longest + lag] += s * heads[(int) Math.floorMod(centre + lag, (long) seats.length)];
        }
    }

    /** The jolt is over. */
    private boolean count(long at) {
        double strength = Math.sqrt(seatPower * headPower);
        double whole = strength;
        for (double value : jolt) {
            whole += value;
        }
        if (!(strength > 0) || !Double.isFinite(whole)) {
            return false;
        }
        double keep = Math.exp(memory * (at - joltAt));
        joltAt = at;
        jolts++;
        weight = keep * weight + 1;
        squares = keep * keep * squares + 1;
        for (int i = 0; i < jolt.length; i++) {
            jolt[i] /= strength;
            sum[i] = keep * sum[i] + jolt[i];
        }
        for (int i = 0; i < jolt.length; i++) {
            for (int j = 0; j < 3 && i + j < jolt.length; j++) {
                products[i][j] = keep * keep * products[i][j] + jolt[i] * jolt[i + j];
            }
        }
        return true;
    }

    /** Jolts counted, however long ago. */
    public long jolts() {
        return jolts;
    }

    /** The lag; empty below three jolts, and where the two are not alike at any lag within a quarter of a second. */
    public Optional<Lag> lag() {
        double counted = weight * weight / squares;
        int best = 0;
        for (int i = 1; i < sum.length; i++) {
            best = sum[i] > sum[best] ? i : best;
        }
        if (!(counted >= FEWEST) || best == 0 || best == sum.length - 1 || !(sum[best] > 0)) {
            return Optional.empty();
        }
        double bend = sum[best - 1] - 2 * sum[best] + sum[best + 1];
        double off = 0.5 * (sum[best - 1] - sum[best + 1]) / bend;
        // A jolt's slope at the lag, (c - a) / 2 + off (a - 2b + c), is linear in its correlations at three lags.
        double a = off - 0.5;
        double b = -2 * off;
        double c = off + 0.5;
        double scatter = a * a * products[best - 1][0] + b * b * products[best][0] + c * c * products[best + 1][0]
                + 2 * (a * b * products[best - 1][1] + b * c * products[best][1] + a * c * products[best - 1][2]);
        double deviation = Math.sqrt(Math.max(0, scatter) * counted / (counted - 1)) / -bend;
        double widened = deviation * new TDistribution(counted - 1).inverseCumulativeProbability(TWO_SIGMA) / 2;
        return Optional.of(new Lag((best - longest + off) / rate, widened / rate, counted));
    }
}

package wbv.recording;

import java.io.Serializable;

/**
 * A uniform clock: sample i is at {@code start + i / rate}.
 *
 * @param start time of sample 0 [s], finite
 * @param rate  samples per second [Hz], &gt; 0
 */
public record Clock(double start, double rate) implements Serializable {

    /** Slowest sampling rate of a recording [Hz]: a sample in twelve days. */
    public static final double SLOWEST = 1e-6;
    /** Fastest sampling rate of a recording [Hz], far beyond what moves a body; seconds of samples are held in memory. */
    public static final double FASTEST = 1e5;

    public Clock {
        if (!Double.isFinite(start)) {
            throw new IllegalArgumentException("start must be a finite time in s: " + start);
        }
        if (!(rate > 0) || Double.isInfinite(rate)) {
            throw new IllegalArgumentException("sampling rate must be > 0 Hz: " + rate);
        }
    }

    /** True for a rate that a recording may have [Hz]. */
    public static boolean isRate(double rate) {
        return rate >= SLOWEST && rate <= FASTEST;
    }

    /** Time of a sample [s]. */
    public double time(long sample) {
        return start + sample / rate;
    }

    /** Time between samples [s]. */
    public double step() {
        return 1 / rate;
    }

    /** The sample nearest to a time [s]; may be negative. */
    public long nearest(double time) {
        return Math.round((time - start) * rate);
    }
}

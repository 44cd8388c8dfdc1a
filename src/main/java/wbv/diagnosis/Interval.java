package wbv.diagnosis;

import org.apache.commons.math3.distribution.TDistribution;

/**
 * Where a number lies with 95 %.
 *
 * @param low  end, in the number's unit; minus infinity where the recording sets none
 * @param high end, in the number's unit; infinity where the recording sets none
 * @param from what it was worked out from
 */
public record Interval(double low, double high, Source from) {

    /** Whence an interval comes. */
    public enum Source {
        /** The curvature of the cost at its least: good where the cost is a parabola as far as the interval reaches. */
        CURVATURE,
        /** The cost itself along the number, everything else refitted. */
        PROFILE
    }

    public Interval {
        if (!(low <= high)) {
            throw new IllegalArgumentException("an interval must have its low end below its high end: " + low + " to " + high);
        }
    }

    /**
     * Of a normal distribution.
     *
     * @param std infinite where the recording tells nothing
     */
    static Interval normal(double value, double std) {
        return new Interval(value - Z * std, value + Z * std, Source.CURVATURE);
    }

    /**
     * The same of a number that nothing takes further down.
     *
     * @param least in the number's unit, not above the high end
     */
    Interval notBelow(double least) {
        return new Interval(Math.max(least, low), high, from);
    }

    /** Quantile of the standard normal distribution that 95 % lie within. */
    static final double Z = 1.959964;

    /** The same of what is told from so many independent parts of a recording (Student). */
    static double quantile(int parts) {
        return new TDistribution(parts - 1).inverseCumulativeProbability(0.975);
    }

    /** Whether the recording bounds the number on both sides. */
    public boolean isClosed() {
        return low > Double.NEGATIVE_INFINITY && high < Double.POSITIVE_INFINITY;
    }

    /**
     * Whether a value lies in it, ends included.
     *
     * @param value in the number's unit
     */
    public boolean contains(double value) {
        return low <= value && value <= high;
    }

    /** The standard deviation of a normal distribution as wide; infinite where an end is open. */
    double std() {
        return isClosed() ? (high - low) / (2 * Z) : Double.POSITIVE_INFINITY;
    }
}

package wbv.report.page;

import wbv.signal.Envelope;

/**
 * A curve. Arrays are not copied: do not change them before the page is written.
 *
 * @param name  shown in the legend, where the reader can hide it
 * @param x     by point, in the unit of its axis, never falling, finite
 * @param y     as many, in the unit of its axis; NaN is a gap
 * @param style how it is drawn
 * @param band  a range about the curve
 */
public record Series(String name, double[] x, double[] y, Style style, Band band) {

    /** How a curve is drawn. */
    public enum Style { LINE, DASHED, POINTS, STRIP, RANGE }

    public Series {
        if (x.length != y.length || band.lower().length != 0 && band.lower().length != x.length) {
            throw new IllegalArgumentException(name + " needs as many y and band values as x: " + x.length + ", " + y.length
                    + ", " + band.lower().length);
        }
        for (int i = 0; i < x.length; i++) {
            if (!Double.isFinite(x[i]) || i > 0 && x[i] < x[i - 1]) {
                throw new IllegalArgumentException("x of " + name + " must be finite and never fall: " + x[i] + " at " + i);
            }
        }
    }

    /**
     * A solid line. Arrays are not copied, not modified.
     *
     * @param x by point, in the unit of its axis
     * @param y as many, in the unit of its axis
     */
    public static Series line(String name, double[] x, double[] y) {
        return new Series(name, x, y, Style.LINE, Band.NONE);
    }

    /**
     * A broken line: what a model says. Arrays are not copied, not modified.
     *
     * @param x by point, in the unit of its axis
     * @param y as many, in the unit of its axis
     */
    public static Series dashed(String name, double[] x, double[] y) {
        return new Series(name, x, y, Style.DASHED, Band.NONE);
    }

    /**
     * Points that are not joined. Arrays are not copied, not modified.
     *
     * @param x by point, in the unit of its axis
     * @param y as many, in the unit of its axis
     */
    public static Series points(String name, double[] x, double[] y) {
        return new Series(name, x, y, Style.POINTS, Band.NONE);
    }

    /**
     * A thick bar wherever y is there, such as a state that lasts: its first x to its last, before the next NaN. Arrays are not copied, not
     * modified.
     *
     * @param x by point, in the unit of its axis
     * @param y as many, in the unit of its axis
     */
    public static Series strip(String name, double[] x, double[] y) {
        return new Series(name, x, y, Style.STRIP, Band.NONE);
    }

    /**
     * A band without a curve: where others have found such values.
     *
     * @param x by point, in the unit of its axis. Not copied, not modified
     */
    public static Series range(String name, double[] x, Band band) {
        double[] y = new double[x.length];
        java.util.Arrays.fill(y, Double.NaN);
        return new Series(name, x, y, Style.RANGE, band);
    }

    /**
     * A long signal as its {@link Envelope}: the samples themselves while every one has its bucket, else the extremes of buckets.
     *
     * @param start time of the first sample [s]
     * @param step  time between samples [s]
     */
    public static Series envelope(String name, Envelope envelope, double start, double step) {
        int size = envelope.size();
        double[] time = new double[size];
        double[] mean = new double[size];
        double[] smallest = new double[size];
        double[] largest = new double[size];
        for (int i = 0; i < size; i++) {
            time[i] = start + envelope.centre(i) * step;
            mean[i] = envelope.mean(i);
            smallest[i] = envelope.smallest(i);
            largest[i] = envelope.largest(i);
        }
        Series line = line(name, time, mean);
        return envelope.width() == 1 ? line : line.with(Band.extremes(smallest, largest));
    }

    /** The same curve with a band. */
    public Series with(Band other) {
        return new Series(name, x, y, style, other);
    }
}

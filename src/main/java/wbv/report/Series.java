package wbv.report;

/**
 * A curve. Arrays are not copied: do not change them before the page is written.
 *
 * @param name  shown in the legend, where the reader can hide it
 * @param x     never falling, finite
 * @param y     as many; NaN is a gap
 * @param style how it is drawn
 * @param band  a range about the curve
 */
public record Series(String name, double[] x, double[] y, Style style, Band band) {

    /** How a curve is drawn. */
    public enum Style { LINE, DASHED, POINTS }

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

    public static Series line(String name, double[] x, double[] y) {
        return new Series(name, x, y, Style.LINE, Band.NONE);
    }

    /** A broken line: what a model says. */
    public static Series dashed(String name, double[] x, double[] y) {
        return new Series(name, x, y, Style.DASHED, Band.NONE);
    }

    public static Series points(String name, double[] x, double[] y) {
        return new Series(name, x, y, Style.POINTS, Band.NONE);
    }

    /** The same curve with a band. */
    public Series with(Band other) {
        return new Series(name, x, y, style, other);
    }
}

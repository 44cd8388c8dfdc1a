package wbv.report.page;

/**
 * A range about a curve. Arrays are not copied.
 *
 * @param kind    what the range is
 * @param lower   as many as the curve's x, in its unit of y, NaN is a gap; empty if there is no band
 * @param upper   as many as {@code lower}, likewise
 * @param meaning named in the legend, such as {@code ±2σ}
 */
public record Band(Kind kind, double[] lower, double[] upper, String meaning) {

    /** No band. */
    public static final Band NONE = new Band(Kind.UNCERTAINTY, new double[0], new double[0], "");

    /** What a range is. */
    public enum Kind {
        /** How far the truth may lie from the curve. A chart does not widen for the few widest places. */
        UNCERTAINTY,
        /** The smallest and largest of many samples that the curve is the mean of: a drawing of all of them. */
        EXTREMES
    }

    public Band {
        if (lower.length != upper.length) {
            throw new IllegalArgumentException("as many upper as lower values: " + upper.length + " and " + lower.length);
        }
    }

    /**
     * From {@code factor} standard deviations below the curve to as many above. Neither array is modified.
     *
     * @param y the curve, by point, in its unit
     * @param deviation as many, in that unit
     */
    public static Band deviations(double[] y, double[] deviation, double factor, String meaning) {
        double[] lower = new double[y.length];
        double[] upper = new double[y.length];
        for (int i = 0; i < y.length; i++) {
            lower[i] = y[i] - factor * deviation[i];
            upper[i] = y[i] + factor * deviation[i];
        }
        return new Band(Kind.UNCERTAINTY, lower, upper, meaning);
    }

    /**
     * The smallest and largest samples. Not copied, not modified.
     *
     * @param lower as many as the curve's x, in its unit
     * @param upper likewise
     */
    public static Band extremes(double[] lower, double[] upper) {
        return new Band(Kind.EXTREMES, lower, upper, "min to max");
    }
}

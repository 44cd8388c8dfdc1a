package wbv.report.page;

/**
 * Points in the plane, in the order in which they are joined. Arrays are not copied: do not change them before the page is
 * written.
 *
 * @param name    shown in the legend, where the reader can hide it
 * @param x       by point, in the unit of its axis, in any order; NaN parts two runs
 * @param y       as many, in the unit of its axis
 * @param whisker half-length of a bar up and down from each point, in the unit of y, as many; empty if there are none
 * @param style   how it is drawn
 * @param colour  place in the page's palette, 0 to 9, or {@link #BY_NAME}
 */
public record XySeries(String name, double[] x, double[] y, double[] whisker, Style style, int colour) {

    /** The chart chooses: the same name has the same colour in all charts of a group. */
    public static final int BY_NAME = -1;

    /** How points are drawn. */
    public enum Style {
        /** Small and faint, so that thousands show where they are dense. */
        CLOUD,
        /** Large. */
        POINTS, LINE, DASHED,
        /** Closed and filled. */
        AREA
    }

    public XySeries {
        if (x.length != y.length || whisker.length != 0 && whisker.length != x.length) {
            throw new IllegalArgumentException(name + " needs as many y and whiskers as x: " + x.length + ", " + y.length + ", "
                    + whisker.length);
        }
    }

    /**
     * Without whiskers, in a colour that the chart chooses. Arrays are not copied, not modified.
     *
     * @param x by point, in the unit of its axis
     * @param y as many, in the unit of its axis
     */
    public XySeries(String name, double[] x, double[] y, Style style) {
        this(name, x, y, new double[0], style, BY_NAME);
    }

    /** The same series in a colour of the palette. */
    public XySeries coloured(int place) {
        return new XySeries(name, x, y, whisker, style, place);
    }
}

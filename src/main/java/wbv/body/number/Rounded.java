package wbv.body.number;

/** Corners made round. */
public final class Rounded {

    private Rounded() {}

    /**
     * The greater of x and 0 in the unit of x, with a round corner: nothing far below 0, x far above, a hyperbola over the width of the
     * edge.
     *
     * @param x in whatever unit
     * @param edge in the unit of x
     */
    public static double ramp(double x, double edge) {
        return (x + Math.sqrt(x * x + edge * edge)) / 2;
    }

    /**
     * The derivative of {@link #ramp} to x [1]: 0 far below 0, 1 far above.
     *
     * @param x in any unit
     * @param edge in the unit of x
     */
    public static double slope(double x, double edge) {
        return (1 + x / Math.sqrt(x * x + edge * edge)) / 2;
    }
}

package wbv.body.law;

/** Corners made round. */
final class Rounded {

    private Rounded() {}

    /** The greater of x and 0 with a round corner: nothing far below 0, x far above, a hyperbola over the width of the edge. */
    static double ramp(double x, double edge) {
        return (x + Math.sqrt(x * x + edge * edge)) / 2;
    }

    /** The derivative of {@link #ramp} to x: 0 far below 0, 1 far above. */
    static double slope(double x, double edge) {
        return (1 + x / Math.sqrt(x * x + edge * edge)) / 2;
    }
}

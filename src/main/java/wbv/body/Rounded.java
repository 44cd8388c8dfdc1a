package wbv.body;

/** Corners made round. */
final class Rounded {

    private Rounded() { }

    /** The greater of x and 0 with a round corner: nothing far below 0, x far above, a hyperbola over the width of the edge. */
    static double ramp(double x, double edge) {
        return (x + Math.sqrt(x * x + edge * edge)) / 2;
    }
}

package wbv.rig;

import wbv.rig.platform.Axis;

/**
 * The motion platform: six independent axes, each following its command like a Butterworth low-pass of fourth order with its
 * corner at 20 Hz, and so flat within 1 % to 12 Hz. A rotation is led back to level with a time constant of 10 s (washout),
 * for a platform cannot drift away.
 */
final class Hexapod {

    /** Corner of an axis [Hz] (assumed: the thesis states flat to 12 Hz). */
    static final double CORNER = 20;
    private static final double WASHOUT = 10;

    private final LinearStep translation;
    private final LinearStep rotation;
    private final double[][] states = new double[Axis.COUNT][];
    private final double[] previous = new double[Axis.COUNT];

    /**
     * A platform at rest.
     *
     * @param h step [s]
     */
    Hexapod(double h) {
        double w = 2 * StrictMath.PI * CORNER;
        double[][] a = new double[5][5];
        double[] b = new double[5];
        for (int section = 0; section < 2; section++) {
            int i = 2 * section;
            double damping = StrictMath.cos(StrictMath.PI * (2 * section + 1) / 8);
            a[i][i + 1] = 1;
            a[i + 1][i] = -w * w;
            a[i + 1][i + 1] = -2 * damping * w;
        }
        b[1] = w * w;
        a[3][0] = w * w;
        a[4][2] = 1;
        a[4][4] = -1 / WASHOUT;
        rotation = new LinearStep(a, b, h);
        double[][] withoutAngle = new double[4][4];
        for (int i = 0; i < 4; i++) {
            System.arraycopy(a[i], 0, withoutAngle[i], 0, 4);
        }
        translation = new LinearStep(withoutAngle, new double[] {0, b[1], 0, 0}, h);
        for (int axis = 0; axis < Axis.COUNT; axis++) {
            states[axis] = new double[axis < 3 ? 4 : 5];
        }
    }

    /**
     * One step.
     *
     * @param command command of the six axes at the end of the step, in {@link Axis} order. Not modified.
     * @param platform the platform's motion there. Modified.
     */
    void step(double[] command, PlaceMotion platform) {
        for (int axis = 0; axis < Axis.COUNT; axis++) {
            double[] x = states[axis];
            (axis < 3 ? translation : rotation).apply(x, previous[axis], command[axis]);
            previous[axis] = command[axis];
            if (axis < 3) {
                platform.acceleration[axis] = x[2];
            } else {
                double rate = x[2] - x[4] / WASHOUT;
                platform.angle[axis - 3] = x[4];
                platform.rate[axis - 3] = rate;
                platform.spin[axis - 3] = x[3] - rate / WASHOUT;
            }
        }
    }
}

package wbv.sensing;

/**
 * Free acceleration from the specific force and the quaternion that a sensor gives: {@code R f - (0, 0, g)} in the world, or
 * turned
 * back into the axes of the sensor (thesis Eq. 2-31 and 2-32 as they must read: the rotation on the left, gravity taken off).
 */
public final class FreeAcceleration {

    private final Orientation orientation = new Orientation();

    /**
     * In the world's axes.
     *
     * @param quaternion sensor to world, real part first; any length but 0. Not modified.
     * @param specific   in the sensor's axes [m/s²]. Not modified. @param out NaN where something is missing. Modified.
     */
    public void inWorld(double[] quaternion, double[] specific, double[] out) {
        if (take(quaternion, out)) {
            Gravity.removeInWorld(orientation, specific, out);
        }
    }

    /** In the sensor's axes; see {@link #inWorld}. */
    public void inSensor(double[] quaternion, double[] specific, double[] out) {
        if (take(quaternion, out)) {
            Gravity.removeInWorld(orientation, specific, out);
            orientation.inward(out, out);
        }
    }

    private boolean take(double[] q, double[] out) {
        double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
        if (!(square > 0)) {
            java.util.Arrays.fill(out, Double.NaN);
            return false;
        }
        orientation.set(q[0], q[1], q[2], q[3]);
        return true;
    }
}

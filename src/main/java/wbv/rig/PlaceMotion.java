package wbv.rig;

/**
 * How a place moves at one instant, in the axes x forward, y left, z up. A mutable workspace: one object a place, filled anew
 * at every step.
 */
final class PlaceMotion {

    /** Acceleration of the place, gravity not included [m/s²]. */
    final double[] acceleration = new double[3];
    /** Small rotation about x, y, z [rad]. */
    final double[] angle = new double[3];
    /** Angular rate [rad/s]. */
    final double[] rate = new double[3];
    /** Angular acceleration [rad/s²]. */
    final double[] spin = new double[3];

    /** Takes over another motion. */
    void set(PlaceMotion other) {
        System.arraycopy(other.acceleration, 0, acceleration, 0, 3);
        System.arraycopy(other.angle, 0, angle, 0, 3);
        System.arraycopy(other.rate, 0, rate, 0, 3);
        System.arraycopy(other.spin, 0, spin, 0, 3);
    }

    /**
     * Takes over the motion of a point that is fixed to a rigid body: a + α × r + ω × (ω × r).
     *
     * @param body motion of the body's reference point. Not modified.
     * @param r    from there to the point [m], length 3. Not modified.
     */
    void setRigid(PlaceMotion body, double[] r) {
        set(body);
        double[] w = body.rate;
        double dot = w[0] * r[0] + w[1] * r[1] + w[2] * r[2];
        double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3;
            int k = (i + 2) % 3;
            acceleration[i] += body.spin[j] * r[k] - body.spin[k] * r[j] + w[i] * dot - square * r[i];
        }
    }
}

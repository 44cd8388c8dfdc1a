package wbv.rig;

import java.util.Arrays;

/**
 * A link between two rigid bodies (or the platform and one) at a point: three springs and dampers along the axes and three
 * about them. Deflections are small and linear in the coordinates (x, y, z, roll, pitch, yaw) of both bodies.
 */
final class Link {

    private static final int DIRECTIONS = 6;

    private final int from;
    private final int to;
    private final double[] below;
    private final double[] above;
    private final double[] stiffness;
    private final double[] damping;
    private final LinkLaw[] laws = new LinkLaw[DIRECTIONS];
    private final double[] deflection = new double[DIRECTIONS];
    private final double[] rate = new double[DIRECTIONS];
    private final double[] force = new double[DIRECTIONS];

    /**
     * @param from  first coordinate of the lower body; negative for the platform
     * @param to first coordinate of the upper body
     * @param below from the lower body's centre to the point [m]
     * @param above from the upper body's centre to the point [m]
     * @param stiffness along x, y, z, about x, y, z
     * @param damping in the same order
     */
    Link(int from, int to, double[] below, double[] above, double[] stiffness, double[] damping) {
        this.from = from;
        this.to = to;
        this.below = below;
        this.above = above;
        this.stiffness = stiffness;
        this.damping = damping;
        Arrays.fill(laws, LinkLaw.LINEAR);
    }

    /**
     * Adds the link's forces and moments on both bodies.
     *
     * @param x coordinates relative to the platform. Not modified.
     * @param v their rates. Not modified.
     * @param stiffnessFactor of the present
     * @param dampingFactor of the present
     * @param into forces on all coordinates. Modified.
     */
    void act(double[] x, double[] v, double stiffnessFactor, double dampingFactor, double[] into) {
        relative(x, deflection);
        relative(v, rate);
        for (int i = 0; i < DIRECTIONS; i++) {
            force[i] = -laws[i].force(deflection[i], rate[i], stiffness[i] * stiffnessFactor, damping[i] * dampingFactor);
        }
        add(into, to, above, 1);
        if (from >= 0) {
            add(into, from, below, -1);
        }
    }

    /** Motion of the point on the upper body less that on the lower: u + θ × r, with θ = (roll, pitch, yaw). */
    private void relative(double[] q, double[] into) {
        Arrays.fill(into, 0);
        move(q, to, above, 1, into);
        if (from >= 0) {
            move(q, from, below, -1, into);
        }
    }

    private static void move(double[] q, int body, double[] r, double sign, double[] into) {
        into[0] += sign * (q[body] + q[body + 4] * r[2] - q[body + 5] * r[1]);
        into[1] += sign * (q[body + 1] + q[body + 5] * r[0] - q[body + 3] * r[2]);
        into[2] += sign * (q[body + 2] + q[body + 3] * r[1] - q[body + 4] * r[0]);
        for (int i = 3; i < DIRECTIONS; i++) {
            into[i] += sign * q[body + i];
        }
    }

    /** The force on the upper body at the last {@link #act} along x, y, z [N], then the moment. Not a copy. */
    double[] force() {
        return force;
    }

    /** Force at the point and moment r × F about the centre. */
    private void add(double[] into, int body, double[] r, double sign) {
        into[body] += sign * force[0];
        into[body + 1] += sign * force[1];
        into[body + 2] += sign * force[2];
        into[body + 3] += sign * (force[3] + r[1] * force[2] - r[2] * force[1]);
        into[body + 4] += sign * (force[4] + r[2] * force[0] - r[0] * force[2]);
        into[body + 5] += sign * (force[5] + r[0] * force[1] - r[1] * force[0]);
    }
}

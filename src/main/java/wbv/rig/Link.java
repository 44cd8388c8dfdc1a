package wbv.rig;

import java.util.Arrays;

/**
 * A link between two rigid bodies (or the platform and one) at a point: three springs and dampers along the axes and two about
 * x and y. Deflections are small and linear in the coordinates (x, y, z, roll, pitch) of both bodies.
 */
final class Link {

    private static final int DIRECTIONS = 5;

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
     * @param from  first coordinate of the lower body; negative for the platform @param to first coordinate of the upper body
     * @param below from the lower body's centre to the point [m] @param above from the upper body's centre to the point [m]
     * @param stiffness along x, y, z, about x, y @param damping in the same order
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
     * @param x coordinates relative to the platform. Not modified. @param v their rates. Not modified.
     * @param stiffnessFactor of the present @param dampingFactor of the present @param into forces on all coordinates. Modified.
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

    /** Motion of the point on the upper body less that on the lower: u + θ × r, with θ = (roll, pitch, 0). */
    private void relative(double[] q, double[] into) {
        into[0] = q[to] + q[to + 4] * above[2];
        into[1] = q[to + 1] - q[to + 3] * above[2];
        into[2] = q[to + 2] + q[to + 3] * above[1] - q[to + 4] * above[0];
        into[3] = q[to + 3];
        into[4] = q[to + 4];
        if (from >= 0) {
            into[0] -= q[from] + q[from + 4] * below[2];
            into[1] -= q[from + 1] - q[from + 3] * below[2];
            into[2] -= q[from + 2] + q[from + 3] * below[1] - q[from + 4] * below[0];
            into[3] -= q[from + 3];
            into[4] -= q[from + 4];
        }
    }

    /** Force at the point and moment r × F about the centre. */
    private void add(double[] into, int body, double[] r, double sign) {
        into[body] += sign * force[0];
        into[body + 1] += sign * force[1];
        into[body + 2] += sign * force[2];
        into[body + 3] += sign * (force[3] + r[1] * force[2] - r[2] * force[1]);
        into[body + 4] += sign * (force[4] + r[2] * force[0] - r[0] * force[2]);
    }
}

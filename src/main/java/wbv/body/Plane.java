package wbv.body;

import java.util.List;

/**
 * Where bodies that move in the plane of x and z are, by which their motions go together beyond first order: bodies turn by whole angles,
 * forces act where the points are, in the axes of the lower body, sensors turn with what they sit on, and what moves on a base that turns
 * is thrown about.
 *
 * @param origin of the base: x, z [m], two long. Not copied
 * @param axes   index among the base's axes of its motion along x, along z and about y; -1 where it has none. Not copied
 * @param bodies rigid bodies
 * @param joints of links along x and z: a link about y has none
 */
public record Plane(double[] origin, int[] axes, List<Rigid> bodies, List<Joint> joints) {

    /** A motion of a rigid body. */
    public enum Motion { X, Z, PITCH }

    /**
     * A body.
     *
     * @param coordinate of each motion, -1 for none. Not copied
     * @param x of its centre of mass [m]
     * @param z likewise
     */
    public record Rigid(int[] coordinate, double x, double z) {}

    /**
     * A link at a point.
     *
     * @param along X or Z
     * @param lower index of a rigid body, -1 for the base
     * @param upper likewise
     * @param x of the point [m]
     * @param z likewise
     */
    public record Joint(int link, Motion along, int lower, int upper, double x, double z) {}

    /**
     * Where a sensor sits.
     *
     * @param body index of a rigid body
     * @param reads its axis, or PITCH
     * @param x from the body's centre [m]
     * @param z likewise
     */
    public record Mount(int body, Motion reads, double x, double z) {}

    public Plane {
        bodies = List.copyOf(bodies);
        joints = List.copyOf(joints);
    }
}

package wbv.sensing;

/**
 * How a segment is bent against the one below it, such as the head against the trunk: Cardan angles about the lower segment's
 * left
 * (flexion), the axis forward (lateral), and the upper segment's upright (axial), as in the thesis' Figure 3-13 for the neck.
 *
 * @param flexion positive forward [rad]
 * @param lateral positive to the right [rad], within ±π/2
 * @param axial positive to the left [rad]
 */
public record JointAngles(double flexion, double lateral, double axial) {

    /**
     * The angles between two segments, both against the same world.
     *
     * @param lower
     * @param upper segment to world, aligned so that both are alike in the neutral pose. Not modified.
     */
    public static JointAngles between(Orientation lower, Orientation upper) {
        double[] angles = new double[3];
        between(lower, upper, angles);
        return new JointAngles(angles[0], angles[1], angles[2]);
    }

    /**
     * The same into an array: flexion, lateral, axial [rad].
     *
     * @param out three long [rad]. Modified.
     */
    public static void between(Orientation lower, Orientation upper, double[] out) {
        // q = lower⁻¹ ⊗ upper, then R = R_y(flexion) R_x(lateral) R_z(axial).
        double a = lower.w();
        double b = -lower.x();
        double c = -lower.y();
        double d = -lower.z();
        double w = a * upper.w() - b * upper.x() - c * upper.y() - d * upper.z();
        double x = a * upper.x() + b * upper.w() + c * upper.z() - d * upper.y();
        double y = a * upper.y() - b * upper.z() + c * upper.w() + d * upper.x();
        double z = a * upper.z() + b * upper.y() - c * upper.x() + d * upper.w();
        out[0] = Math.atan2(2 * (x * z + w * y), 1 - 2 * (x * x + y * y));
        out[1] = -Math.asin(Math.max(-1, Math.min(1, 2 * (y * z - w * x))));
        out[2] = Math.atan2(2 * (x * y + w * z), 1 - 2 * (x * x + z * z));
    }
}

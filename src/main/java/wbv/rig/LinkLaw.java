package wbv.rig;

/**
 * The force of a link in one direction. Every direction of every link has its own law, and this is the one place where a
 * sitter's physics can be replaced by other physics.
 */
@FunctionalInterface
interface LinkLaw {

    /** Spring and damper. */
    LinkLaw LINEAR = (deflection, rate, stiffness, damping) -> stiffness * deflection + damping * rate;

    /**
     * The restoring force [N], or moment [N·m].
     *
     * @param deflection [m or rad]
     * @param rate [m/s or rad/s]
     * @param stiffness  of the present [N/m or N·m/rad], softening included
     * @param damping of the present
     */
    double force(double deflection, double rate, double stiffness, double damping);
}

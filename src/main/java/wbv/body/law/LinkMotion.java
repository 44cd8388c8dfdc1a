package wbv.body.law;

/**
 * One step of a link's relative motion as a law sees it: where it was, where it is, and the link's linear values. Reused from
 * step to step; r is the displacement of {@code to} relative to {@code from} [m], positive in extension.
 */
public final class LinkMotion {
    /** Linear stiffness of the link [N/m]. */
    public double stiffness;
    /** Linear damping of the link [N s/m]. */
    public double damping;
    /** Time at the end of the step [s]. */
    public double time;
    /** Length of the step [s]. */
    public double step;
    /** Displacement at the start of the step [m]. */
    public double before;
    /** Displacement at the end of the step [m]. */
    public double displacement;
    /** Velocity at the end of the step [m/s]. */
    public double velocity;
    /** What the law is multiplied by at the end of the step. */
    public double modulation = 1;
    /** The law's memory at the start of the step, in the unit that the law gives it. */
    public double memory;
    /** Displacement {@link Law#lateness} ago [m]. */
    public double lateDisplacement;
    /** Velocity {@link Law#lateness} ago [m/s]. */
    public double lateVelocity;
}

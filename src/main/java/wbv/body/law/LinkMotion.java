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

    /**
     * What follows the displacement and slips where it is stretched farther than that: a memory at the end of the step [m].
     *
     * @param most [m]
     */
    double dragged(double most) {
        return Math.max(-most, Math.min(most, memory + displacement - before));
    }

    /**
     * A series between two samples, in its own unit, by a straight line; 0 before the first.
     *
     * @param series by sample, in any unit. Not modified.
     * @param at where, counted in samples [1]
     * @param known how many of its samples count; what comes after is 0
     */
    public static double between(double[] series, double at, int known) {
        int floor = (int) Math.floor(at);
        double share = at - floor;
        return floor < 0 ? 0 : series[floor] * (1 - share) + (floor + 1 < known ? series[floor + 1] * share : 0);
    }
}

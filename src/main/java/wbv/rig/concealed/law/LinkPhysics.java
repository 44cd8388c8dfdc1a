package wbv.rig.concealed.law;

/**
 * The whole force of a link, spring and dashpot included, as it really is. An object belongs to one run; inner states, if any,
 * are integrated with the chain's own, and what cannot be written as a rate is taken on at the end of each step.
 */
public interface LinkPhysics {

    /** Number of inner states. */
    default int states() {
        return 0;
    }

    /**
     * The force that pulls the upper body towards the lower one [N].
     *
     * @param t time [s]
     * @param r extension [m]
     * @param v its rate [m/s]
     * @param y as long as all states, each in its own unit. Not modified.
     *          @param at own first state
     */
    double force(double t, double r, double v, double[] y, int at);

    /** What resists the acceleration of one end against the other, beside the force [kg]. */
    default double inertance() {
        return 0;
    }

    /**
     * Writes the rates of the inner states.
     *
     * @param t time [s]
     * @param r extension [m]
     * @param v its rate [m/s]
     * @param y as long as all states, each in its own unit. Not modified.
     * @param at own first state
     * @param into as long, in those units per second. Modified at its own places.
     */
    default void rates(double t, double r, double v, double[] y, int at, double[] into) {}

    /**
     * The end of a step.
     *
     * @param t time [s]
     * @param r extension [m]
     * @param v its rate [m/s]
     */
    default void commit(double t, double r, double v) {}
}

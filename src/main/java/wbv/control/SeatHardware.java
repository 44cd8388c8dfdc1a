package wbv.control;

/**
 * What a seat's maker knows of it.
 *
 * @param frameMass    what the suspension carries without cushion and sitter [kg], &gt; 0
 * @param stiffness    of the suspension's spring [N/m], &gt; 0
 * @param leastDamping of the adjustable damper [N·s/m], &gt; 0
 * @param mostDamping of it [N·s/m], more than the least
 * @param mostForce    of the actuator [N], &gt; 0
 * @param lag          of damper and actuator, which follow what is asked as a first-order system [s], &gt; 0
 * @param delay        from the sensors until damper and actuator begin to follow [s], &gt;= 0
 * @param stop         deflection at which the end stops begin [m], &gt; 0
 */
public record SeatHardware(double frameMass, double stiffness, double leastDamping, double mostDamping, double mostForce, double lag,
        double delay, double stop) {

    /** Mass, spring, damper and stops of a middling suspension seat, all assumed. */
    public static final SeatHardware ASSUMED = new SeatHardware(15, 6000, 100, 2500, 500, 0.010, 0.004, 0.050);

    public SeatHardware {
        if (!(frameMass > 0 && stiffness > 0 && leastDamping > 0 && mostForce > 0 && lag > 0 && delay >= 0 && stop > 0)) {
            throw new IllegalArgumentException(
                    "mass, stiffness, damping, force, lag and stop of a seat must be > 0: " + frameMass + " kg, " + stiffness
                            + " N/m, " + leastDamping + " N·s/m, " + mostForce + " N, " + lag + " s, " + stop
                            + " m; a delay >= 0: " + delay + " s");
        }
        if (!(mostDamping > leastDamping)) {
            throw new IllegalArgumentException("the most damping must be more than the least, " + leastDamping + " N·s/m: " + mostDamping);
        }
    }

    double clipDamping(double asked) {
        return asked >= leastDamping ? Math.min(asked, mostDamping) : leastDamping;
    }

    double clipForce(double asked) {
        return Double.isFinite(asked) ? Math.max(-mostForce, Math.min(mostForce, asked)) : 0;
    }
}

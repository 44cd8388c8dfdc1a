package wbv.control;

/**
 * Takes authority from an actuator that sings: forces above {@value #CORNER_HZ} Hz come of no ride, but of a loop that is later, or a
 * sitter who is lighter, than it was designed for. What is taken comes back over minutes.
 */
final class SingingGuard {

    static final int CORNER_HZ = 15;

    private static final double T = SeatController.STEP;
    private static final double SHARE = 1 / (1 + 2 * Math.PI * CORNER_HZ * T);
    /** Force above the corner that is still taken for the ride's [N], over this time [s]; assumed. */
    private static final double MOST = 40;
    private static final double TIME = 0.3;
    private static final double BACK = 300;

    private double authority = 1;
    private double before;
    private double high;
    private double higher;
    private double square;

    /** Part of what is asked that may be given, 0 to 1. */
    double authority() {
        return authority;
    }

    /** @param force that is given now [N] */
    void hear(double force) {
        double first = SHARE * (high + force - before);
        higher = SHARE * (higher + first - high);
        high = first;
        before = force;
        square += T / TIME * (higher * higher - square);
        authority += square > MOST * MOST ? -T / TIME * authority : T / BACK * (1 - authority);
    }
}

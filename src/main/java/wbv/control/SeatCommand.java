package wbv.control;

/** What a controller asks of damper and actuator. One object is filled anew at every step. */
public final class SeatCommand {

    private double damping;
    private double force;

    void set(double dampingAsked, double forceAsked) {
        damping = dampingAsked;
        force = forceAsked;
    }

    /** Of the adjustable damper [N·s/m]. */
    public double damping() {
        return damping;
    }

    /** Of the actuator on the frame, upwards [N]. */
    public double force() {
        return force;
    }
}

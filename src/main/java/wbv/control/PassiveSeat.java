package wbv.control;

/** A damper that nobody adjusts. */
public final class PassiveSeat implements SeatController {

    private final double damping;

    /**
     * A damper as it is sold.
     *
     * @param damping [N·s/m], within what the hardware can do
     */
    public PassiveSeat(SeatHardware hardware, double damping) {
        if (!(damping >= hardware.leastDamping() && damping <= hardware.mostDamping())) {
            throw new IllegalArgumentException(
                    "damping must be " + hardware.leastDamping() + " to " + hardware.mostDamping() + " N·s/m: " + damping);
        }
        this.damping = damping;
    }

    @Override
    public void step(SeatReadings readings, SeatCommand command) {
        command.set(damping, 0);
    }
}

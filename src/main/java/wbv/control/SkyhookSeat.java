package wbv.control;

/**
 * A damper adjusted so that it pulls as one between the frame and the sky would, where it can: where frame and suspension move the
 * same way (Karnopp, Crosby and Harwood 1974). Knows nothing of who sits on it.
 */
public final class SkyhookSeat implements SeatController {

    /** How the damper is adjusted. */
    public enum Kind {
        /** To the force that the sky's damper would have. */
        CONTINUOUS,
        /** To one of two values. */
        ON_OFF
    }

    /** Below this, an integrated acceleration is taken for a drift [rad/s]. */
    private static final double DRIFT = 2 * Math.PI * 0.3;

    private final SeatHardware hardware;
    private final Kind kind;
    private final double gain;
    private final RelativeMotion relative;
    private double mean;
    private double velocity;
    private double last;

    /**
     * At rest.
     *
     * @param gain damping of the sky's damper, or the higher one of two [N·s/m], &gt;= 0
     */
    public SkyhookSeat(SeatHardware hardware, Kind kind, double gain) {
        if (!(gain >= 0) || Double.isInfinite(gain)) {
            throw new IllegalArgumentException("the sky's damping must be >= 0 N·s/m: " + gain);
        }
        this.hardware = hardware;
        this.kind = kind;
        this.gain = gain;
        this.relative = new RelativeMotion(hardware);
    }

    @Override
    public void step(SeatReadings readings, SeatCommand command) {
        relative.step(readings);
        last = Double.isFinite(readings.frame()) ? readings.frame() : 0.9 * last;
        mean += DRIFT * STEP * (last - mean);
        velocity += STEP * (last - mean) - DRIFT * STEP * velocity;
        boolean together = velocity * relative.rate() > 0;
        double asked = switch (kind) {
            case ON_OFF -> together ? gain : 0;
            case CONTINUOUS -> together ? relative.damping(gain * velocity) : 0;
        };
        command.set(hardware.clipDamping(asked), 0);
    }
}

package wbv.control;

/**
 * Deflection of a suspension and its rate, from two accelerations, which know it at once, and the deflection's sensor, which knows
 * it in the long run: an observer with two equal poles. A lost reading is foreseen.
 */
final class RelativeMotion {

    private static final double T = SeatController.STEP;
    /** Of the observer [rad/s]. */
    private static final double POLE = 2 * Math.PI * 5;
    /** Time over which the mean square of the acceleration is taken [s]: two periods of a suspension of 1 Hz; assumed. */
    private static final double TIME = 2;
    /** Rate that nothing is told from [m/s]; assumed. */
    private static final double STILL = 1e-3;

    private final double late;
    private double deflection;
    private double rate;
    private double acceleration;
    private double square;

    RelativeMotion(SeatHardware hardware) {
        late = hardware.delay() + hardware.lag();
    }

    void step(SeatReadings readings) {
        double difference = readings.frame() - readings.floor();
        acceleration = Double.isFinite(difference) ? difference : 0.9 * acceleration;
        square += T / TIME * (acceleration * acceleration - square);
        double error = Double.isFinite(readings.deflection()) ? readings.deflection() - deflection : 0;
        deflection += T * (rate + 2 * POLE * error);
        rate += T * (acceleration + POLE * POLE * error);
    }

    /** [m/s] */
    double rate() {
        return rate;
    }

    /**
     * The damping that comes nearest to a force in the mean square over the rates that it may meet: a damper is late, and by then the
     * rate v has become one of variance σ², what the acceleration makes of it in that time; so {@code force v / (v² + σ²)}.
     *
     * @param force against the rate [N]
     * @return [N·s/m]
     */
    double damping(double force) {
        return force * rate / (rate * rate + late * late * square + STILL * STILL);
    }
}

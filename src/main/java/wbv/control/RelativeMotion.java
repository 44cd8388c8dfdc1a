package wbv.control;

/**
 * Deflection of a suspension and its rate, from two accelerations, which know it at once, and the deflection's sensor, which knows
 * it in the long run: an observer with two equal poles. A lost reading is foreseen.
 */
final class RelativeMotion {

    private static final double T = SeatController.STEP;
    /** Of the observer [rad/s]. */
    private static final double POLE = 2 * Math.PI * 5;

    /** Rate below which a suspension stands still [m/s]; assumed. */
    private static final double STILL = 0.005;

    private double deflection;
    private double rate;
    private double acceleration;

    void step(SeatReadings readings) {
        double difference = readings.frame() - readings.floor();
        acceleration = Double.isFinite(difference) ? difference : 0.9 * acceleration;
        double error = Double.isFinite(readings.deflection()) ? readings.deflection() - deflection : 0;
        deflection += T * (rate + 2 * POLE * error);
        rate += T * (acceleration + POLE * POLE * error);
    }

    /** [m] */
    double deflection() {
        return deflection;
    }

    /** [m/s] */
    double rate() {
        return rate;
    }

    /** Damping that a force would take at this rate, none where the suspension stands still. @param force [N] @return [N·s/m] */
    double damping(double force) {
        return force * rate / (rate * rate + STILL * STILL);
    }
}

package wbv.control.trial;

import wbv.control.SeatHardware;
import wbv.recording.Unit;
import wbv.rig.CarriedPerson;
import wbv.rig.Subject;

/**
 * The seat as it is: a frame on a spring with Coulomb friction and end stops, a leveller that brings it to the middle of its stroke,
 * and a {@link CarriedPerson}; stepped by Runge-Kutta's fourth order. Friction, stops and leveller are assumed.
 */
final class SuspendedPerson {

    /** Steps a second. */
    static final int RATE = 1000;
    static final double STEP = 1.0 / RATE;

    /** Coulomb friction [N], and the rate over which it turns [m/s]. */
    private static final double FRICTION = 40;
    private static final double TURN = 0.005;
    /** Stiffness and damping of a stop [N/m, N·s/m]. */
    private static final double STOP_STIFFNESS = 1e5;
    private static final double STOP_DAMPING = 1500;
    /** Leveller: time over which it takes the mean deflection [s], what it lets be [m], and how fast it fills or empties [N/s]. */
    private static final double LEVEL_TIME = 2;
    private static final double LEVEL_DEAD = 0.004;
    private static final double LEVEL_RATE = 150;

    private final SeatHardware hardware;
    private CarriedPerson person;
    private int n;
    private double[] state;
    private double[] trial;
    private double[] slope;
    private double[] sum;
    private double[] bodies;
    private double preload;
    private double level;
    private double frame;
    private boolean hit;
    private int hits;

    SuspendedPerson(SeatHardware hardware, Subject subject) {
        this.hardware = hardware;
        seat(subject);
        preload = weight();
    }

    /** Another sits there from now on, with his body at rest on the seat; the leveller finds out by itself. */
    void seat(Subject subject) {
        double deflection = state == null ? 0 : state[0];
        double rate = state == null ? 0 : state[n + 1];
        person = new CarriedPerson(subject, STEP);
        n = person.bodies();
        state = new double[2 * n + 2];
        trial = new double[2 * n + 2];
        slope = new double[2 * n + 2];
        sum = new double[2 * n + 2];
        bodies = new double[n];
        state[0] = deflection;
        state[n + 1] = rate;
    }

    private double weight() {
        return Unit.STANDARD_GRAVITY * (hardware.frameMass() + person.carriedMass());
    }

    /**
     * A step.
     *
     * @param before acceleration of the floor at its beginning [m/s²]
     * @param after at its end
     * @param damping of the damper [N·s/m]
     * @param force of the actuator [N]
     */
    void step(double before, double after, double damping, double force) {
        double middle = (before + after) / 2;
        System.arraycopy(state, 0, sum, 0, state.length);
        System.arraycopy(state, 0, trial, 0, state.length);
        stage(before, damping, force, STEP / 6, STEP / 2);
        stage(middle, damping, force, STEP / 3, STEP / 2);
        stage(middle, damping, force, STEP / 3, STEP);
        stage(after, damping, force, STEP / 6, 0);
        System.arraycopy(sum, 0, state, 0, state.length);
        frame = accelerate(state, damping, force);
        person.feel(frame);
        levelOut();
        count();
    }

    private void stage(double floor, double damping, double force, double weight, double ahead) {
        slopes(floor, damping, force);
        for (int i = 0; i < state.length; i++) {
            sum[i] += weight * slope[i];
            trial[i] = state[i] + ahead * slope[i];
        }
    }

    /** State: deflection, places of the bodies over the frame, then the rates of all. */
    private void slopes(double floor, double damping, double force) {
        double a = accelerate(trial, damping, force);
        System.arraycopy(trial, n + 1, slope, 0, n + 1);
        slope[n + 1] = a - floor;
        for (int i = 0; i < n; i++) {
            slope[n + 2 + i] = bodies[i] - a;
        }
    }

    /** Acceleration of the frame; that of the bodies stands in {@code bodies} afterwards. */
    private double accelerate(double[] at, double damping, double force) {
        double d = at[0];
        double v = at[n + 1];
        double onFrame = person.act(at, 1, n + 2, bodies);
        double over = Math.abs(d) - hardware.stop();
        double stop = over > 0 ? -Math.signum(d) * Math.max(0, STOP_STIFFNESS * over + STOP_DAMPING * v * Math.signum(d)) : 0;
        return (preload - weight() - hardware.stiffness() * d - damping * v - FRICTION * v / Math.sqrt(v * v + TURN * TURN) + stop + force
                + onFrame)
                / hardware.frameMass();
    }

    private void levelOut() {
        level += STEP / LEVEL_TIME * (state[0] - level);
        if (Math.abs(level) > LEVEL_DEAD) {
            double wanted = -hardware.stiffness() * level / LEVEL_TIME;
            preload += STEP * Math.max(-LEVEL_RATE, Math.min(LEVEL_RATE, wanted));
        }
    }

    private void count() {
        boolean now = Math.abs(state[0]) > hardware.stop();
        hits += now && !hit ? 1 : 0;
        hit = now || hit && Math.abs(state[0]) > 0.95 * hardware.stop();
    }

    CarriedPerson person() {
        return person;
    }

    /** Place of the frame over the floor [m]. */
    double deflection() {
        return state[0];
    }

    /** Its rate [m/s]. */
    double rate() {
        return state[n + 1];
    }

    /** Force of the spring on the frame with its preload [N]. */
    double spring() {
        return preload - hardware.stiffness() * state[0];
    }

    /** Acceleration of the frame [m/s²]. */
    double frame() {
        return frame;
    }

    /** Acceleration of the seat pan [m/s²]. */
    double seat() {
        return bodies[person.seat()];
    }

    double trunk() {
        return bodies[person.trunk()];
    }

    double head() {
        return bodies[person.head()];
    }

    /** How often a stop was reached so far. */
    int hits() {
        return hits;
    }
}

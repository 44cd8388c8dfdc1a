package wbv.rig.concealed.law;

import java.util.function.DoubleUnaryOperator;
import java.util.function.ToDoubleFunction;

/**
 * Forces beside a link's spring and dashpot that follow from the present alone and are in no library. All in newtons, positive in tension.
 */
public final class OpenLaws {

    private OpenLaws() {}

    /**
     * c ρ² / (1 + ρ²/9) v, ρ = r/x: a damper that closes as it travels.
     *
     * @param c where ρ is about 1 [N s/m]
     * @param x [m]
     */
    public static LinkPhysics travelDamping(double c, double x) {
        return (Springs.Instant) (r, v) -> {
            double rho = r / x * (r / x);
            return c * rho / (1 + rho / 9) * v;
        };
    }

    /**
     * g(t) v: damping that follows something else than the link.
     *
     * @param damping at a time in s [N s/m]
     */
    public static LinkPhysics timedDamping(DoubleUnaryOperator damping) {
        return (t, r, v, y, at) -> damping.applyAsDouble(t) * v;
    }

    /**
     * g(t) r.
     *
     * @param stiffness at a time in s [N/m]
     */
    public static LinkPhysics timedStiffness(DoubleUnaryOperator stiffness) {
        return (t, r, v, y, at) -> stiffness.applyAsDouble(t) * r;
    }

    /**
     * g(t) tanh(v/s): dry friction under a pressure that comes from elsewhere.
     *
     * @param friction at a time in s [N]
     * @param soft s [m/s]
     */
    public static LinkPhysics timedFriction(DoubleUnaryOperator friction, double soft) {
        return (t, r, v, y, at) -> friction.applyAsDouble(t) * Math.tanh(v / soft);
    }

    /**
     * N tanh(v/s): dry friction under what another link carries.
     *
     * @param pressing N from all states [N]
     * @param soft s [m/s]
     */
    public static LinkPhysics pressedFriction(ToDoubleFunction<double[]> pressing, double soft) {
        return (t, r, v, y, at) -> pressing.applyAsDouble(y) * Math.tanh(v / soft);
    }

    /**
     * k(y) r.
     *
     * @param stiffness from all states [N/m]
     */
    public static LinkPhysics loadedStiffness(ToDoubleFunction<double[]> stiffness) {
        return (t, r, v, y, at) -> stiffness.applyAsDouble(y) * r;
    }

    /**
     * F(y): a force that the link's own motion has no part in.
     *
     * @param force from all states [N]
     */
    public static LinkPhysics foreign(ToDoubleFunction<double[]> force) {
        return (t, r, v, y, at) -> force.applyAsDouble(y);
    }

    /**
     * k |r| tanh(v/s): a wedge that its own deflection presses.
     *
     * @param k friction over deflection [N/m]
     * @param soft s [m/s]
     */
    public static LinkPhysics wedge(double k, double soft) {
        return (Springs.Instant) (r, v) -> k * Math.abs(r) * Math.tanh(v / soft);
    }

    /**
     * c max(0, v): a damper that works in rebound alone.
     *
     * @param c [N s/m]
     */
    public static LinkPhysics rebound(double c) {
        return (Springs.Instant) (r, v) -> c * Math.max(0, v);
    }

    /**
     * c max(v, -s): a damper whose valve blows off in compression.
     *
     * @param c [N s/m]
     * @param speed s at which it opens [m/s]
     */
    public static LinkPhysics blowOff(double c, double speed) {
        return (Springs.Instant) (r, v) -> c * Math.max(v, -speed);
    }

    /**
     * c v / (1 + (v/s)²): an eddy-current brake.
     *
     * @param c [N s/m]
     * @param speed s of its greatest force [m/s]
     */
    public static LinkPhysics eddyBrake(double c, double speed) {
        return (Springs.Instant) (r, v) -> c * v / (1 + v / speed * (v / speed));
    }

    /**
     * b (a2 - a1): the accelerations of its two ends.
     *
     * @param b [kg]
     */
    public static LinkPhysics inerter(double b) {
        return new LinkPhysics() {
            @Override
            public double force(double t, double r, double v, double[] y, int at) {
                return 0;
            }

            @Override
            public double inertance() {
                return b;
            }
        };
    }
}

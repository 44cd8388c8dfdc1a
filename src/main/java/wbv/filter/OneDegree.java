package wbv.filter;

import java.io.Serializable;

/**
 * The body of one degree of freedom on a shaken base, {@code (2ζω s + ω²) / (s² + 2ζω s + ω²)}, at one pair of parameters.
 *
 * <p>States are {@code v = q̇} and {@code w = ω_ref q}, where {@code q̈ = -2ζω q̇ - ω² q + u}; q is the body's displacement
 * behind its base. The acceleration of the body is {@code y = 2ζω v + (ω²/ω_ref) w}. The constant ω_ref gives both states the
 * unit m/s. Parameters are 0: ln ω, 1: ln ζ.
 */
final class OneDegree implements Serializable {

    private static final long serialVersionUID = 1;
    private static final double[] INPUT = {1, 0};

    private final double reference;
    private final double time;
    private final double[] a = new double[4];
    private final double[][] slopes = new double[2][4];
    private final ExactStep step = new ExactStep(2, 2, InputWindow.POINTS - 1);
    private double damper;
    private double spring;

    /** @param reference ω_ref [rad/s], &gt; 0  @param rate [Hz], &gt; 0 */
    OneDegree(double reference, double rate) {
        this.reference = reference;
        this.time = 1 / rate;
    }

    void set(double logOmega, double logDamping) {
        double omega = Math.exp(logOmega);
        damper = 2 * Math.exp(logDamping) * omega;
        spring = omega * omega / reference;
        a[0] = -damper;
        a[1] = -spring;
        a[2] = reference;
        slopes[0][0] = -damper;
        slopes[0][1] = -2 * spring;
        slopes[1][0] = -damper;
        step.set(a, slopes, INPUT, time);
    }

    /** Exact transition and gains over one sampling interval. */
    ExactStep step() {
        return step;
    }

    /** ∂y/∂v [1/s]. */
    double damper() {
        return damper;
    }

    /** ∂y/∂w [1/s]. */
    double spring() {
        return spring;
    }

    /** Acceleration of the body [m/s²]. */
    double output(double v, double w) {
        return damper * v + spring * w;
    }

    /** Derivative of {@link #output} to a parameter, the states held. */
    double outputSlope(int parameter, double v, double w) {
        return damper * v + (parameter == 0 ? 2 * spring * w : 0);
    }

    /**
     * Moves the states over one sampling interval.
     *
     * @param c coefficients of the input on it, {@link InputWindow#POINTS} long. Not modified.
     * @param x v and w at 0 and 1. Modified.
     */
    void advance(double[] c, double[] x) {
        double[] e = step.transition();
        double v = e[0] * x[0] + e[1] * x[1];
        double w = e[2] * x[0] + e[3] * x[1];
        for (int j = 0; j < c.length; j++) {
            double[] g = step.gain(j);
            v += g[0] * c[j];
            w += g[1] * c[j];
        }
        x[0] = v;
        x[1] = w;
    }

    /** |H(f)| of a body. @param frequency f0 [Hz]  @param damping ζ  @param f [Hz] */
    static double modulus(double frequency, double damping, double f) {
        double r = f / frequency;
        double d = 2 * damping * r;
        return Math.hypot(1, d) / Math.hypot(1 - r * r, d);
    }
}

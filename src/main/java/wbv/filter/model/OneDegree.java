package wbv.filter.model;

/**
 * The body of one degree of freedom on a shaken base, {@code (2ζω s + ω²) / (s² + 2ζω s + ω²)}, at one pair of parameters.
 *
 * <p>States are {@code v = q̇} and {@code w = ω_ref q}, where {@code q̈ = -2ζω q̇ - ω² q + u}; q is the body's displacement
 * behind its base. The acceleration of the body is {@code y = 2ζω v + (ω²/ω_ref) w}. The constant ω_ref gives both states the
 * unit m/s. Parameters are 0: ln ω, 1: ln ζ.
 * Thesis: Eq. 5-5.
 */
public final class OneDegree implements BodyModel {

    private static final long serialVersionUID = 1;

    private final double reference;
    private final double startFrequency;
    private final double startDamping;
    private final ModeStep step;
    private double damper;
    private double spring;
    /** The last exponentials, which are asked for several times. */
    private double logOmega = Double.NaN;
    private double omega;
    private double logDamping = Double.NaN;
    private double damping;

    /**
     * A body at rest.
     *
     * @param spec   rate and start
     * @param slopes whether derivatives of the step will be asked for
     */
    public OneDegree(Spec spec, boolean slopes) {
        this(2 * Math.PI * spec.frequency(), spec.frequency(), spec.damping(), spec.rate(), slopes);
    }

    /**
     * A body at rest.
     *
     * @param reference ω_ref [rad/s]
     * @param frequency to start from [Hz]
     * @param damping ratio to start from
     * @param rate [Hz]
     */
    public OneDegree(double reference, double frequency, double damping, double rate, boolean slopes) {
        this.reference = reference;
        this.startFrequency = frequency;
        this.startDamping = damping;
        this.step = new ModeStep(1 / rate, slopes);
    }

    @Override
    public int modes() {
        return 1;
    }

    @Override
    public int parameters() {
        return 2;
    }

    @Override
    public void start(double[] xi) {
        xi[2] = Math.log(2 * Math.PI * startFrequency);
        xi[3] = Math.log(startDamping);
    }

    /** State equation with parameters. Thesis: Eq. 4-4. */
    @Override
    public void set(double[] xi) {
        set(xi[2], xi[3]);
    }

    @Override
    public void setOutput(double[] xi) {
        setOutput(xi[2], xi[3]);
    }

    /**
     * Takes ln ω, ω in rad/s, and ln ζ.
     *
     * @param logOmega logarithm of ω
     * @param logDamping logarithm of ζ
     */
    public void set(double logOmega, double logDamping) {
        setOutput(logOmega, logDamping);
        step.set(damper, spring, reference);
    }

    void setOutput(double logFrequency, double logRatio) {
        look(logFrequency, logRatio);
        damper = 2 * damping * omega;
        spring = omega * omega / reference;
    }

    private void look(double logFrequency, double logRatio) {
        if (logFrequency != logOmega) {
            logOmega = logFrequency;
            omega = Math.exp(logFrequency);
        }
        if (logRatio != logDamping) {
            logDamping = logRatio;
            damping = Math.exp(logRatio);
        }
    }

    @Override
    public double frequency(int mode, double[] xi) {
        look(xi[2], xi[3]);
        return omega / (2 * Math.PI);
    }

    @Override
    public double damping(int mode, double[] xi) {
        look(xi[2], xi[3]);
        return damping;
    }

    @Override
    public ModeStep step(int mode) {
        return step;
    }

    /** Measurement equation: y_k = h(x_k) + v. Thesis: Eq. 4-2, 4-5, 5-4, 6-4. */
    @Override
    public double output(double[] xi) {
        return output(xi[0], xi[1]);
    }

    /** Jacobian of the measurement. Thesis: Eq. 4-18, 6-5. */
    @Override
    public void outputRow(double[] row) {
        row[0] = damper;
        row[1] = spring;
    }

    @Override
    public double outputSlope(int parameter, double[] xi) {
        return outputSlope(parameter, xi[0], xi[1]);
    }

    @Override
    public boolean sane(double[] xi) {
        return within(0, xi);
    }

    @Override
    public double share(double[] xi) {
        return 1;
    }

    /** Transmissibility of one degree of freedom in s. Thesis: Eq. 4-22, 5-1. */
    @Override
    public double modulus(double f, double[] xi) {
        return modulus(frequency(0, xi), damping(0, xi), f);
    }

    /** ∂y/∂v [1/s]. */
    public double damper() {
        return damper;
    }

    /** ∂y/∂w [1/s]. */
    public double spring() {
        return spring;
    }

    /**
     * Acceleration of the body [m/s²].
     *
     * @param v [m/s]
     * @param w [m/s]
     */
    public double output(double v, double w) {
        return damper * v + spring * w;
    }

    /**
     * Derivative of {@link #output(double, double)} to a parameter, the states held [m/s²].
     *
     * @param v [m/s]
     * @param w [m/s]
     */
    public double outputSlope(int parameter, double v, double w) {
        return damper * v + (parameter == 0 ? 2 * spring * w : 0);
    }

    /**
     * |H(f)| of a body.
     *
     * @param frequency f0 [Hz]
     * @param damping ζ
     * @param f [Hz]
     */
    static double modulus(double frequency, double damping, double f) {
        double r = f / frequency;
        double d = 2 * damping * r;
        return Math.hypot(1, d) / Math.hypot(1 - r * r, d);
    }
}

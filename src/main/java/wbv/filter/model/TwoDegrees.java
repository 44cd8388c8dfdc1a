package wbv.filter.model;

/**
 * Any body of two degrees of freedom on a shaken base whose output follows the base at rest and in slow motion: {@code y = g
 * y₁ + (1 - g) y₂ + h (s₁ v₁ - s₂ v₂)}, two modes of {@link OneDegree} with {@code s = ω²/ω_ref}.
 *
 * <p>A chain or a fork of two masses has such an output at each of them; that its transfer function is {@code 1 + O(s²)}
 * leaves two numbers beside the poles. Proportional damping is h = 0. Parameters are ln ω and ln ζ of both modes, g, h.
 */
public final class TwoDegrees implements BodyModel {

    private static final long serialVersionUID = 1;
    /** Beyond such a share of the output an estimate has diverged [1]. */
    private static final double MOST_SHARE = 10;
    private static final int SHARE = 8;
    private static final int CROSS = 9;

    private final OneDegree slow;
    private final OneDegree fast;
    private final double startFrequency;
    private final double startSecond;
    private final double startDamping;
    private final double startShare;
    private final double reference;
    private double g;
    private double h;

    /**
     * A body at rest.
     *
     * @param slopes whether derivatives of the step will be asked for
     */
    public TwoDegrees(Spec spec, boolean slopes) {
        startFrequency = spec.frequency();
        startSecond = Math.min(Spec.MOST_FREQUENCY / 1.2, spec.adaptation().prior().apart() * spec.frequency());
        startDamping = spec.damping();
        startShare = spec.adaptation().prior().firstsShare();
        reference = 2 * Math.PI * startFrequency;
        slow = new OneDegree(reference, startFrequency, startDamping, spec.rate(), slopes);
        fast = new OneDegree(reference, startSecond, startDamping, spec.rate(), slopes);
    }

    @Override
    public int modes() {
        return 2;
    }

    @Override
    public int parameters() {
        return 6;
    }

    @Override
    public void start(double[] xi) {
        xi[4] = Math.log(reference);
        xi[5] = Math.log(startDamping);
        xi[6] = Math.log(2 * Math.PI * startSecond);
        xi[7] = Math.log(startDamping);
        xi[SHARE] = startShare;
        xi[CROSS] = 0;
    }

    @Override
    public void set(double[] xi) {
        slow.set(xi[4], xi[5]);
        fast.set(xi[6], xi[7]);
        g = xi[SHARE];
        h = xi[CROSS];
    }

    @Override
    public void setOutput(double[] xi) {
        slow.setOutput(xi[4], xi[5]);
        fast.setOutput(xi[6], xi[7]);
        g = xi[SHARE];
        h = xi[CROSS];
    }

    @Override
    public ModeStep step(int mode) {
        return (mode == 0 ? slow : fast).step(0);
    }

    @Override
    public double output(double[] xi) {
        return g * slow.output(xi[0], xi[1]) + (1 - g) * fast.output(xi[2], xi[3]) + h * cross(xi);
    }

    private double cross(double[] xi) {
        return slow.spring() * xi[0] - fast.spring() * xi[2];
    }

    @Override
    public void outputRow(double[] row) {
        row[0] = g * slow.damper() + h * slow.spring();
        row[1] = g * slow.spring();
        row[2] = (1 - g) * fast.damper() - h * fast.spring();
        row[3] = (1 - g) * fast.spring();
    }

    @Override
    public double outputSlope(int parameter, double[] xi) {
        return switch (parameter) {
            case 0 -> g * slow.outputSlope(0, xi[0], xi[1]) + 2 * h * slow.spring() * xi[0];
            case 1 -> g * slow.outputSlope(1, xi[0], xi[1]);
            case 2 -> (1 - g) * fast.outputSlope(0, xi[2], xi[3]) - 2 * h * fast.spring() * xi[2];
            case 3 -> (1 - g) * fast.outputSlope(1, xi[2], xi[3]);
            case 4 -> slow.output(xi[0], xi[1]) - fast.output(xi[2], xi[3]);
            default -> cross(xi);
        };
    }

    @Override
    public boolean sane(double[] xi) {
        return within(0, xi) && within(1, xi) && Math.abs(xi[SHARE]) < MOST_SHARE && Math.abs(xi[CROSS]) < MOST_SHARE;
    }

    @Override
    public double share(double[] xi) {
        return xi[4] <= xi[6] ? xi[SHARE] : 1 - xi[SHARE];
    }

    @Override
    public double modulus(double f, double[] xi) {
        double re = 0;
        double im = 0;
        for (int m = 0; m < 2; m++) {
            double omega = Math.exp(xi[4 + 2 * m]);
            double share = m == 0 ? xi[SHARE] : 1 - xi[SHARE];
            double cross = (m == 0 ? 1 : -1) * xi[CROSS] * omega * omega / reference;
            double s = 2 * Math.PI * f;
            double damper = 2 * Math.exp(xi[5 + 2 * m]) * omega;
            // (share (d s + ω²) + cross s) / (s² + d s + ω²) at s = jω_f
            double nr = share * omega * omega;
            double ni = (share * damper + cross) * s;
            double dr = omega * omega - s * s;
            double di = damper * s;
            double size = dr * dr + di * di;
            re += (nr * dr + ni * di) / size;
            im += (ni * dr - nr * di) / size;
        }
        return Math.hypot(re, im);
    }
}

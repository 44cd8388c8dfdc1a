package wbv.filter.model;

/**
 * The body of one degree of freedom on a shaken base of whose damping only a share κ acts against the base; the rest acts against
 * rest (a skyhook damper): {@code (2κζω s + ω²) / (s² + 2ζω s + ω²)}. It is what the slowest mode of a chain looks like from its
 * base where the faster ones are stiff: its resonance and what it lets through above it are two things, and not both told by ζ.
 *
 * <p>States are those of {@link OneDegree}; parameters are 0: ln ω, 1: ln ζ, 2: κ, which is 1 at the start.
 */
public final class SkyhookDegree implements BodyModel {

    private static final long serialVersionUID = 1;
    /** Place of κ in ξ. */
    static final int SHARE = 4;
    /** Beyond such a share an estimate has diverged [1]. */
    private static final double MOST_SHARE = 10;

    private final OneDegree body;
    private double share = 1;

    /**
     * A body at rest.
     *
     * @param slopes whether derivatives of the step will be asked for
     */
    public SkyhookDegree(Spec spec, boolean slopes) {
        this.body = new OneDegree(spec, slopes);
    }

    @Override
    public int modes() {
        return 1;
    }

    @Override
    public int parameters() {
        return 3;
    }

    @Override
    public void start(double[] xi) {
        body.start(xi);
        xi[SHARE] = 1;
    }

    @Override
    public void set(double[] xi) {
        body.set(xi);
        share = xi[SHARE];
    }

    @Override
    public void setOutput(double[] xi) {
        body.setOutput(xi);
        share = xi[SHARE];
    }

    @Override
    public ModeStep step(int mode) {
        return body.step(mode);
    }

    @Override
    public double output(double[] xi) {
        return share * body.damper() * xi[0] + body.spring() * xi[1];
    }

    @Override
    public void outputRow(double[] row) {
        row[0] = share * body.damper();
        row[1] = body.spring();
    }

    @Override
    public double outputSlope(int parameter, double[] xi) {
        double damped = body.damper() * xi[0];
        return switch (parameter) {
            case 0 -> share * damped + 2 * body.spring() * xi[1];
            case 1 -> share * damped;
            default -> damped;
        };
    }

    @Override
    public boolean sane(double[] xi) {
        return within(0, xi) && Math.abs(xi[SHARE]) < MOST_SHARE;
    }

    @Override
    public double share(double[] xi) {
        return 1;
    }

    @Override
    public double modulus(double f, double[] xi) {
        double r = f / frequency(0, xi);
        double d = 2 * damping(0, xi) * r;
        return Math.hypot(1, xi[SHARE] * d) / Math.hypot(1 - r * r, d);
    }
}

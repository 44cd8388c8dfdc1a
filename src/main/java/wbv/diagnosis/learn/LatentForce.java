package wbv.diagnosis.learn;

import java.util.Arrays;
import wbv.body.Assembly;
import wbv.body.Spectra;
import wbv.body.simulate.Excitation;
import wbv.diagnosis.fit.Windows;

/**
 * The force that a link or a body would have to feel beside the linear model for that model and the recording to agree, whatever
 * makes it: {@code F = dᴴS⁻¹ε / dᴴS⁻¹d} at every spectral line, where ε is what the linear part leaves of the measured outputs, d
 * what a unit of the force does to them, and S the noise. Stiffness, damping and masses are held as fitted, else
 * a part of them would pass for the force.
 *
 * <p>It is known between 1 Hz, below which accelerometers say nothing of forces, and the top of the fit's band. What the law that
 * was found says below 1 Hz is put in there, so that forces with a mean, such as those of a stop, stand where they belong.
 */
public final class LatentForce {

    /** Time to the end in which it is not known [s]. */
    private static final double END = 1;

    private final Excitation whole;
    private final boolean[] counted;
    private final Assembly bare;
    private final Estimate estimate;

    /**
     * How a force was worked out: spectra over all lines of the whole input.
     *
     * @param force        itself
     * @param law          what the law that was found says of it; zero where none was
     * @param seenLaw      what is left of the law in the band in which the force is known
     * @param stretch      of the link under the input and the force; empty for a force on a body
     * @param acceleration of the body; empty for a force in a link
     * @param pointNoise   standard deviation of one sample that the sensors' noise leaves [N]
     * @param lowest       frequency from which on it is known [Hz]
     */
    record Estimate(double[] force, double[] law, double[] seenLaw, double[] stretch, double[] acceleration, double pointNoise,
            double lowest) {}

    /**
     * @param counted samples at which the outputs were measured. Not modified.
     * @param bare the linear model without the force, as fitted
     */
    LatentForce(Excitation whole, boolean[] counted, Assembly bare, Estimate estimate) {
        this.whole = whole;
        this.counted = counted;
        this.bare = bare;
        this.estimate = estimate;
    }

    /** The force, by sample [N]. */
    public double[] force() {
        return whole.series(estimate.force());
    }

    /** The same [N], NaN where it is not known. */
    public double[] knownForce() {
        double[] out = force();
        Arrays.setAll(out, i -> known(i) ? out[i] : Double.NaN);
        return out;
    }

    /** What the law that was found says of it, by sample [N]; zero where none was. */
    public double[] law() {
        return whole.series(estimate.law());
    }

    /** What the force would look like if the law were perfect, by sample [N]: the law in the band in which the force is known. */
    public double[] lawInBand() {
        return whole.series(estimate.seenLaw());
    }

    /** The force at the free run's rate, by sample [N]. */
    public double[] fineForce() {
        return whole.fineSeries(estimate.force());
    }

    /** The law at the free run's rate, by sample [N]. */
    public double[] fineLaw() {
        return whole.fineSeries(estimate.law());
    }

    /** Relative displacement of the link at the free run's rate, by sample [m]. */
    public double[] fineDisplacement() {
        return whole.fineSeries(estimate.stretch());
    }

    /** Relative velocity of the link at the free run's rate, by sample [m/s]. */
    public double[] fineVelocity() {
        return whole.fineSeries(speed());
    }

    /** Samples of the free run for each of the recording. */
    public int refinement() {
        return (int) Math.round(1 / (whole.fineStep() * whole.rate()));
    }

    /** Standard deviation of one sample of the force that the sensors' noise leaves [N]. */
    public double pointNoise() {
        return estimate.pointNoise();
    }

    /** Frequency from which on the force is known [Hz]. */
    public double lowest() {
        return estimate.lowest();
    }

    /** The linear model without the force, as fitted. */
    public Assembly bare() {
        return bare;
    }

    /** Relative displacement of the link under the input and the force, by sample [m]. */
    public double[] displacement() {
        return whole.series(estimate.stretch());
    }

    /** Relative velocity of the link, by sample [m/s]. */
    public double[] velocity() {
        return whole.series(speed());
    }

    /** Acceleration of the body, by sample [m/s²]. */
    public double[] bodyAcceleration() {
        return whole.series(estimate.acceleration());
    }

    /** Force over a link's own dynamic stiffness, by sample: the displacement that would make it [m]. */
    public double[] lift(int link) {
        double[] force = estimate.force();
        double[] out = new double[force.length];
        double k = bare.structure().stiffness()[link];
        double c = bare.structure().damping()[link];
        for (int i = 0; i < whole.omega().length; i++) {
            double im = whole.omega()[i] * c;
            double size = k * k + im * im;
            out[2 * i] = -(force[2 * i] * k + force[2 * i + 1] * im) / size;
            out[2 * i + 1] = -(force[2 * i + 1] * k - force[2 * i] * im) / size;
        }
        return whole.series(out);
    }

    /** Whether the outputs were measured, and far enough from both ends of the record for the force to be known. */
    public boolean known(int sample) {
        return counted[Math.min(sample, counted.length - 1)] && (estimate.lowest() == 0
                || sample >= margin(Windows.SETTLING) && sample < whole.samples() - margin(END));
    }

    private double margin(double time) {
        return Math.min(time * whole.rate(), Windows.SETTLING_SHARE * whole.samples());
    }

    private double[] speed() {
        return Spectra.timesJOmega(whole.omega(), estimate.stretch());
    }
}

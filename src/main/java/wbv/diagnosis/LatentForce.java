package wbv.diagnosis;

import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Excitation;

/**
 * The force that a link or a body would have to feel beside the linear model for that model and the recording to agree, whatever
 * makes it: {@code F = dᴴS⁻¹ε / dᴴS⁻¹d} at every spectral line, where ε is what the linear part leaves of the measured outputs, d
 * what a unit of the force does to them, and S the noise. Stiffness, damping and masses are held as fitted, else
 * a part of them would pass for the force.
 *
 * <p>It is known between 1 Hz, below which accelerometers say nothing of forces, and the top of the fit's band. What the law that
 * was found says below 1 Hz is put in there, so that forces with a mean, such as those of a stop, stand where they belong.
 */
final class LatentForce {

    private static final double CROSSOVER = 1;
    private static final double SETTLING = 2;
    private static final double END = 1;

    private final Evidence evidence;
    private final Excitation whole;
    private final int place;
    private final Assembly bare;
    private final double[] law;
    private final double[] force;
    private final double[][] acceleration;
    private final double pointNoise;

    /**
     * @param baseline the user's model: what the fit added to it at the place is left out
     * @param place    index of a body, or of a link
     */
    LatentForce(Evidence evidence, Candidate baseline, Fitter.State fit, boolean onBody, int place) {
        this.evidence = evidence;
        this.whole = evidence.whole();
        this.place = place;
        Remainder remainder = new Remainder(whole, baseline.template(), fit.candidate().at(fit.x()), onBody, place);
        this.bare = remainder.bare();
        double noise = 0;
        double[] weight = band();
        double[] projected = new double[2 * whole.omega().length];
        double[][] direction = remainder.answer(bare);
        double[][] residual = residual(remainder.outputs(bare));
        NoiseMetric metric = new NoiseMetric(evidence, whole, remainder.full());
        for (int k = 1; k < whole.omega().length; k++) {
            double power = metric.product(direction, direction, k)[0];
            double[] share = metric.product(direction, residual, k);
            if (power > 0) {
                projected[2 * k] = share[0] / power;
                projected[2 * k + 1] = share[1] / power;
                noise += weight[k] * weight[k] / power;
            }
        }
        pointNoise = Math.sqrt(2 * noise * whole.omega()[1] / (2 * Math.PI * whole.rate()));

        this.law = remainder.force();
        this.force = new double[projected.length];
        for (int k = 0; k < weight.length; k++) {
            for (int part = 2 * k; part < 2 * k + 2; part++) {
                force[part] = weight[k] * projected[part] + (isLow(k) ? (1 - weight[k]) * law[part] : 0);
            }
        }
        Assembly bodies = new Assembly(bare.structure(), bare.laws(), bare.drives(), IntStream.range(0, bare.structure().bodies())
                .mapToObj(b -> new Assembly.Output(b, Assembly.Reading.ACCELERATION, List.of())).toList());
        this.acceleration = remainder.outputs(bodies);
        double[][] moved = remainder.answer(bodies);
        for (int b = 0; b < moved.length; b++) {
            Remainder.add(acceleration[b], moved[b], force);
        }
    }

    /** The force, by sample [N]. */
    double[] force() {
        return whole.series(force);
    }

    /** What the law that was found says of it, by sample [N]; zero where none was. */
    double[] law() {
        return whole.series(law);
    }

    /**
     * What is left of the law in the band in which the force is known, by sample [N]: what the force would look like if the law
     * were perfect.
     */
    double[] lawInBand() {
        double[] weight = band();
        double[] out = law.clone();
        for (int i = 0; i < out.length; i++) {
            out[i] *= isLow(i / 2) ? 1 : weight[i / 2];
        }
        return whole.series(out);
    }

    /** The force at the free run's rate [N]. */
    double[] fineForce() {
        return whole.fineSeries(force);
    }

    /** The law at the free run's rate [N]. */
    double[] fineLaw() {
        return whole.fineSeries(law);
    }

    /** Relative displacement of the link at the free run's rate [m]. */
    double[] fineDisplacement() {
        return whole.fineSeries(stretch());
    }

    /** Relative velocity of the link at the free run's rate [m/s]. */
    double[] fineVelocity() {
        return whole.fineSeries(speed());
    }

    /** Samples of the free run for each of the recording. */
    int refinement() {
        return (int) Math.round(1 / (whole.fineStep() * whole.rate()));
    }

    /** Standard deviation of one sample of the force that the sensors' noise leaves [N]. */
    double pointNoise() {
        return pointNoise;
    }

    /** The linear model without the force, as fitted. */
    Assembly bare() {
        return bare;
    }

    /** Relative displacement of the link under the base's motion and the force, by sample [m]. */
    double[] displacement() {
        return whole.series(stretch());
    }

    /** Relative velocity of the link, by sample [m/s]. */
    double[] velocity() {
        return whole.series(speed());
    }

    /** Acceleration of the body, by sample [m/s²]. */
    double[] bodyAcceleration() {
        return whole.series(acceleration[place]);
    }

    /** Force over the link's own dynamic stiffness, by sample: the displacement that would make it [m]. */
    double[] lift() {
        double[] out = new double[force.length];
        double k = bare.structure().stiffness()[place];
        double c = bare.structure().damping()[place];
        for (int i = 0; i < whole.omega().length; i++) {
            double im = whole.omega()[i] * c;
            double size = k * k + im * im;
            out[2 * i] = -(force[2 * i] * k + force[2 * i + 1] * im) / size;
            out[2 * i + 1] = -(force[2 * i + 1] * k - force[2 * i] * im) / size;
        }
        return whole.series(out);
    }

    /** Whether a sample is far enough from both ends of the record to be known. */
    boolean known(int sample) {
        return sample >= SETTLING * whole.rate() && sample < whole.samples() - END * whole.rate();
    }

    private double[] stretch() {
        double[] upper = acceleration[bare.structure().to()[place]];
        int from = bare.structure().from()[place];
        double[] lower = from < 0 ? whole.baseSpectrum() : acceleration[from];
        double[] out = new double[upper.length];
        for (int k = 1; k < whole.omega().length; k++) {
            double w2 = whole.omega()[k] * whole.omega()[k];
            out[2 * k] = -(upper[2 * k] - lower[2 * k]) / w2;
            out[2 * k + 1] = -(upper[2 * k + 1] - lower[2 * k + 1]) / w2;
        }
        return out;
    }

    private double[] speed() {
        double[] r = stretch();
        double[] v = new double[r.length];
        for (int k = 0; k < whole.omega().length; k++) {
            v[2 * k] = -whole.omega()[k] * r[2 * k + 1];
            v[2 * k + 1] = whole.omega()[k] * r[2 * k];
        }
        return v;
    }

    /** Measured minus simulated, faded in and out so that the ends of the record make no noise. */
    private double[][] residual(double[][] simulated) {
        double[][] out = new double[simulated.length][];
        int fade = (int) whole.rate();
        for (int o = 0; o < out.length; o++) {
            double[] series = whole.series(simulated[o]);
            for (int i = 0; i < series.length; i++) {
                double inside = Math.min(1, Math.min(i + 0.5, series.length - i - 0.5) / fade);
                double fading = Math.pow(Math.sin(Math.PI / 2 * inside), 2);
                series[i] = evidence.valid(o)[i] ? fading * (evidence.measured(o)[i] - series[i]) : 0;
            }
            out[o] = whole.spectrum(series);
        }
        return out;
    }

    private boolean isLow(int k) {
        return whole.omega()[k] < 4 * Math.PI * CROSSOVER;
    }

    /** How much of each line is taken from the recording. */
    private double[] band() {
        double top = evidence.fit().frequency(evidence.fit().lines() - 1);
        double[] out = new double[whole.omega().length];
        for (int k = 0; k < out.length; k++) {
            double f = whole.omega()[k] / (2 * Math.PI);
            double u = Math.pow(f / CROSSOVER, 8);
            out[k] = u / (1 + u) * Math.max(0, Math.min(1, (top - f) / (0.1 * top)));
        }
        return out;
    }
}

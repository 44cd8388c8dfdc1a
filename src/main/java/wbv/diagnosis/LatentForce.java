package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.Excitation;
import wbv.body.LawAt;
import wbv.body.Simulator;
import wbv.body.Structure;

/**
 * The force that a link or a body would have to feel beside the linear model for that model and the recording to agree, whatever makes
 * it: {@code F = dᴴS⁻¹ε / dᴴS⁻¹d} at every spectral line, where ε is what the linear part leaves of the measured outputs, d what a unit
 * of the force does to them, and S the noise (DIAGNOSIS 3.2). Stiffness, damping and masses are held as fitted, else a part of them would
 * pass for the force.
 *
 * <p>It is known between 1 Hz, below which accelerometers say nothing of forces, and the top of the fit's band. What the law that was
 * found says below 1 Hz is put in there, so that forces with a mean, such as those of a stop, stand where they belong.
 */
final class LatentForce {

    private static final double CROSSOVER = 1;
    private static final double SETTLING = 2;
    private static final double END = 1;

    private final Evidence evidence;
    private final Excitation whole;
    private final boolean onBody;
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
        this.onBody = onBody;
        this.place = place;
        Assembly full = fit.candidate().at(fit.x());
        Assembly user = baseline.template();
        Simulator simulator = new Simulator(whole);
        Simulator.Response response = simulator.run(full, false);
        this.bare = bare(full, user);
        List<LawAt> others = full.laws().stream().filter(at -> !at.law().isLinear()).filter(at -> !own(full, user, at)).toList();

        double[][] left = outputs(bare, others, response, full);
        double noise = 0;
        double[] weight = band();
        double[] projected = new double[2 * whole.omega().length];
        double[][] direction = answer(bare);
        double[][] gain = simulator.transmissibility(full);
        double[][] residual = residual(left);
        for (int k = 1; k < whole.omega().length; k++) {
            double power = project(residual, direction, gain, k, projected);
            noise += power > 0 ? weight[k] * weight[k] / power : 0;
        }
        pointNoise = Math.sqrt(2 * noise * whole.omega()[1] / (2 * Math.PI * whole.rate()));

        this.law = lawForce(full, user, response);
        this.force = new double[projected.length];
        for (int k = 0; k < weight.length; k++) {
            for (int part = 2 * k; part < 2 * k + 2; part++) {
                force[part] = weight[k] * projected[part] + (isLow(k) ? (1 - weight[k]) * law[part] : 0);
            }
        }
        Assembly bodies = new Assembly(bare.structure(), bare.laws(), bare.drives(), IntStream.range(0, bare.structure().bodies())
                .mapToObj(b -> new Assembly.Output(b, Assembly.Reading.ACCELERATION, List.of())).toList());
        this.acceleration = outputs(bodies, others, response, full);
        double[][] moved = answer(bodies);
        for (int b = 0; b < moved.length; b++) {
            add(acceleration[b], moved[b], force);
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

    /** What is left of the law in the band in which the force is known, by sample [N]: what a perfect law would let the force look like. */
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

    private boolean own(Assembly full, Assembly user, LawAt at) {
        return !onBody && at.link() == place && full.laws().indexOf(at) >= user.laws().size();
    }

    /** The linear part of a model without what was added at the place. */
    private Assembly bare(Assembly full, Assembly user) {
        List<LawAt> laws = full.laws().stream().filter(at -> at.law().isLinear() && !own(full, user, at)).toList();
        List<Assembly.DriveAt> drives = new ArrayList<>();
        for (int i = 0; i < full.drives().size(); i++) {
            Assembly.DriveAt at = full.drives().get(i);
            boolean own = i >= user.drives().size() && at.place() == place && at.drive() instanceof Drive.Tone == onBody;
            if (!own) {
                drives.add(at);
            }
        }
        Structure s = full.structure();
        double[] values = s.values();
        for (int l = user.structure().links(); l < s.links(); l++) {
            if (onBody && s.from()[l] == place) {
                values[l] = 1e-3;   // what swung there floats, and no longer pulls
                values[s.links() + l] = 1e-3;
            }
        }
        return new Assembly(s.with(values), laws, drives, full.outputs());
    }

    /** Outputs of a linear model with the forces that other laws had. */
    private double[][] outputs(Assembly model, List<LawAt> others, Simulator.Response response, Assembly full) {
        Simulator simulator = new Simulator(whole);
        double[][] out = simulator.run(model, false).outputs();
        Simulator.Linearised linear = simulator.linearised(model);
        for (LawAt at : others) {
            double[][] direction = linear.ofLinkForce(at.link());
            for (int o = 0; o < out.length; o++) {
                add(out[o], direction[o], response.forces()[full.laws().indexOf(at)]);
            }
        }
        return out;
    }

    private double[][] answer(Assembly model) {
        Simulator.Linearised linear = new Simulator(whole).linearised(model);
        return onBody ? linear.ofBodyForce(place) : linear.ofLinkForce(place);
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

    /** One line of F into {@code out}. @return dᴴS⁻¹d, with S⁻¹ by Sherman and Morrison (1950) */
    private double project(double[][] residual, double[][] direction, double[][] gain, int k, double[] out) {
        double b = evidence.inputNoise() * evidence.inputNoise();
        double gg = 1 / b;
        double dd = 0;
        double[] de = new double[2];
        double[] dg = new double[2];
        double[] ge = new double[2];
        for (int o = 0; o < residual.length; o++) {
            double s = evidence.noise()[o] * evidence.noise()[o];
            dd += product(direction[o], direction[o], k, s, new double[2]);
            gg += product(gain[o], gain[o], k, s, new double[2]);
            product(direction[o], residual[o], k, s, de);
            product(direction[o], gain[o], k, s, dg);
            product(gain[o], residual[o], k, s, ge);
        }
        double power = dd - (dg[0] * dg[0] + dg[1] * dg[1]) / gg;
        if (power > 0) {
            out[2 * k] = (de[0] - (dg[0] * ge[0] - dg[1] * ge[1]) / gg) / power;
            out[2 * k + 1] = (de[1] - (dg[0] * ge[1] + dg[1] * ge[0]) / gg) / power;
        }
        return power;
    }

    /** Adds conj(x) y / s at a line to {@code sum}. @return its real part */
    private static double product(double[] x, double[] y, int k, double s, double[] sum) {
        double re = (x[2 * k] * y[2 * k] + x[2 * k + 1] * y[2 * k + 1]) / s;
        sum[0] += re;
        sum[1] += (x[2 * k] * y[2 * k + 1] - x[2 * k + 1] * y[2 * k]) / s;
        return re;
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

    /** The force of what was added at the place, as the fit has it. */
    private double[] lawForce(Assembly full, Assembly user, Simulator.Response response) {
        double[] out = new double[2 * whole.omega().length];
        double[] one = new double[out.length];
        for (int k = 0; k < out.length; k += 2) {
            one[k] = 1;
        }
        for (int i = 0; i < full.laws().size(); i++) {
            if (own(full, user, full.laws().get(i))) {
                add(out, one, response.forces()[i]);
            }
        }
        Structure s = full.structure();
        for (int l = user.structure().links(); l < s.links(); l++) {
            if (onBody && s.from()[l] == place) {
                double[] stiffness = new double[out.length];
                for (int k = 0; k < whole.omega().length; k++) {
                    stiffness[2 * k] = s.stiffness()[l];
                    stiffness[2 * k + 1] = whole.omega()[k] * s.damping()[l];
                }
                add(out, stiffness, response.stretch()[l]);
            }
        }
        for (int i = user.drives().size(); i < full.drives().size(); i++) {
            if (onBody && full.drives().get(i).place() == place && full.drives().get(i).drive() instanceof Drive.Tone tone) {
                add(out, one, whole.spectrum(series(tone)));
            }
        }
        return out;
    }

    private double[] series(Drive.Tone tone) {
        return IntStream.range(0, whole.samples()).mapToDouble(i -> 2 * Math.PI * tone.frequency() * i / whole.rate())
                .map(phase -> tone.cosine() * Math.cos(phase) + tone.sine() * Math.sin(phase)).toArray();
    }

    /** target += x y, line by line. */
    private static void add(double[] target, double[] x, double[] y) {
        for (int i = 0; i < x.length; i += 2) {
            target[i] += x[i] * y[i] - x[i + 1] * y[i + 1];
            target[i + 1] += x[i] * y[i + 1] + x[i + 1] * y[i];
        }
    }
}

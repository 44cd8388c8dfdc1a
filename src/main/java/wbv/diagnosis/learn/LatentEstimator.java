package wbv.diagnosis.learn;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Spectra;
import wbv.body.simulate.Excitation;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Readings;
import wbv.diagnosis.fit.Remainder;
import wbv.diagnosis.search.NoiseMetric;

/** Works out a {@link LatentForce} from a recording and a fit. */
public final class LatentEstimator {

    private static final double CROSSOVER = 1;

    private final Evidence evidence;
    private final Excitation whole;
    private final boolean onBody;
    private final int place;
    private final Remainder remainder;
    private final Assembly bare;

    /**
     * Takes what was found out of the model; the force is worked out when asked for.
     *
     * @param baseline the user's model: what the fit added to it at the place is left out
     * @param place    index of a body, or of a link
     */
    public LatentEstimator(Evidence evidence, Candidate baseline, Fitter.State fit, boolean onBody, int place) {
        this.evidence = evidence;
        this.whole = evidence.whole();
        this.onBody = onBody;
        this.place = place;
        this.remainder = new Remainder(whole, baseline.template(), fit.candidate().at(fit.x()), onBody, place);
        this.bare = remainder.bare();
    }

    /** The force at the place by sample, without a law for it. */
    public LatentForce force() {
        boolean[] counted = new boolean[whole.samples()];
        for (int i = 0; i < counted.length; i++) {
            int at = i;
            counted[i] = IntStream.range(0, evidence.outputs().size()).allMatch(o -> evidence.valid(o)[at]);
        }
        return new LatentForce(whole, counted, bare, remainder.full().structure().held() ? measured() : projected());
    }

    /** In a driven link the force is what its sensor reads beside the linear part, and the motion is the stroke. */
    private LatentForce.Estimate measured() {
        int output = IntStream.range(0, bare.outputs().size()).filter(o -> bare.outputs().get(o).place() == place).findFirst()
                .orElseThrow();
        double[] series = whole.series(remainder.outputs(bare)[output]);
        for (int i = 0; i < series.length; i++) {
            series[i] = evidence.measured(output)[i] - series[i];
        }
        double[] law = remainder.force();
        return new LatentForce.Estimate(whole.spectrum(series), law, law, remainder.stretch(place), new double[0],
                evidence.noise()[output], 0);
    }

    private LatentForce.Estimate projected() {
        double noise = 0;
        double[] weight = band();
        double[] law = remainder.force();
        double[] force = new double[law.length];
        double[] seenLaw = new double[law.length];
        double[][] direction = remainder.answer(bare);
        double[][] residual = residual(remainder.outputs(bare));
        NoiseMetric metric = new NoiseMetric(evidence, whole, remainder.full());
        for (int k = 1; k < weight.length; k++) {
            double power = metric.product(direction, direction, k)[0];
            double[] share = metric.product(direction, residual, k);
            double rest = whole.omega()[k] < 4 * Math.PI * CROSSOVER ? 1 - weight[k] : 0;
            for (int part = 0; part < 2; part++) {
                double own = power > 0 ? share[part] / power : 0;
                force[2 * k + part] = weight[k] * own + rest * law[2 * k + part];
                seenLaw[2 * k + part] = (weight[k] + rest) * law[2 * k + part];
            }
            noise += power > 0 ? weight[k] * weight[k] / power : 0;
        }
        force[0] = law[0];
        seenLaw[0] = law[0];
        double pointNoise = Math.sqrt(2 * noise * whole.omega()[1] / (2 * Math.PI * whole.rate()));
        double[][] moved = moved(force);
        return new LatentForce.Estimate(force, law, seenLaw, onBody ? new double[0] : stretch(moved), onBody ? moved[place]
                : new double[0],
                pointNoise, CROSSOVER);
    }

    /** Accelerations of all bodies under the input and the force. */
    private double[][] moved(double[] force) {
        Assembly bodies = new Assembly(bare.structure(), bare.laws(), bare.drives(), IntStream.range(0, bare.structure().bodies())
                .mapToObj(b -> new Assembly.Output(b, Assembly.Reading.ACCELERATION, List.of())).toList());
        double[][] out = remainder.outputs(bodies);
        double[][] answer = remainder.answer(bodies);
        for (int b = 0; b < out.length; b++) {
            Spectra.addProduct(answer[b], force, 1, out[b]);
        }
        return out;
    }

    private double[] stretch(double[][] acceleration) {
        double[] velocity = Spectra.overJOmega(whole.omega(), whole.stretching(bare.structure(), place, acceleration));
        return Spectra.overJOmega(whole.omega(), velocity);
    }

    /** Measured minus simulated, spectra. */
    private double[][] residual(double[][] simulated) {
        return new Readings(evidence).beyond(Arrays.stream(simulated).map(whole::series).toArray(double[][]::new));
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

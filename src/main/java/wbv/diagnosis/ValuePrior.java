package wbv.diagnosis;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * What is known beforehand of numbers. All stiffness and damping of a model as given share one scale of error, itself known to a factor; how
 * strong an effect is, in its own unit, is normal about nothing; all else of a mechanism is as likely anywhere between its bounds.
 */
final class ValuePrior {

    /** Steps of the scale: enough for a sum, since a likelihood of a dozen numbers changes little between two. */
    private static final double[] SPREADS = {-2, -1.5, -1, -0.5, 0, 0.5, 1, 1.5, 2, 2.5};

    private final double[] scales;
    private final double[] logs;
    private final double amplitude;

    ValuePrior(Priors priors) {
        scales = Arrays.stream(SPREADS).map(z -> priors.values() * Math.pow(priors.valuesSpread(), z)).toArray();
        double[] raw = Arrays.stream(SPREADS).map(z -> -0.5 * z * z).toArray();
        double sum = LogSum.of(raw);
        logs = Arrays.stream(raw).map(log -> log - sum).toArray();
        amplitude = priors.amplitude();
    }

    int count() {
        return scales.length;
    }

    /** The candidate with what is known of its knobs, at one scale of the given numbers' error. */
    Candidate at(Candidate candidate, int scale) {
        boolean[] strong = amplitudes(candidate);
        List<Knob> knobs = IntStream.range(0, strong.length).mapToObj(i -> {
            Knob knob = candidate.knobs().get(i);
            return shares(candidate, i) ? known(knob, scales[scale]) : strong[i] ? known(knob, amplitude) : knob;
        }).toList();
        return new Candidate(candidate.template(), knobs, candidate.added());
    }

    private static Knob known(Knob knob, double deviation) {
        return new Knob(knob.name(), knob.slot(), knob.reference(), knob.unit(), knob.low(), knob.high(), deviation);
    }

    /** Whether a knob is a stiffness or a damping as it was given. */
    private static boolean shares(Candidate candidate, int i) {
        Knob knob = candidate.knobs().get(i);
        boolean link = knob.slot().kind() == Slot.Kind.STIFFNESS || knob.slot().kind() == Slot.Kind.DAMPING;
        return link && knob.unit() == 0 && i < own(candidate);
    }

    /** Number of knobs that no hypothesis brought. */
    private static int own(Candidate candidate) {
        return candidate.knobs().size() - candidate.added().stream().mapToInt(h -> h.numbers().size()).sum();
    }

    /** Which knobs say how strong an effect is, in a unit of its own, and mean none at 0. */
    private static boolean[] amplitudes(Candidate candidate) {
        boolean[] out = new boolean[candidate.knobs().size()];
        for (Hypothesis hypothesis : candidate.added()) {
            int[] at = candidate.positions(hypothesis);
            for (int[] column : hypothesis.starts().get(0).columns()) {
                for (int i : column) {
                    Hypothesis.Number number = hypothesis.numbers().get(i);
                    out[at[i]] = number.unit() > 0 && number.low() <= 0;
                }
            }
        }
        return out;
    }

    /** Log of the density of a candidate's coordinates; bounded ones lie within their bounds. @param candidate as {@link #at} gives it */
    double log(Candidate candidate, double[] x) {
        double sum = 0;
        for (int i = 0; i < x.length; i++) {
            Knob knob = candidate.knobs().get(i);
            double deviation = knob.deviation();
            sum -= Double.isInfinite(deviation) ? Math.log(knob.high() - knob.low()) : 0.5 * Math.pow(x[i] / deviation, 2) + Math.log(deviation * Math.sqrt(2 * Math.PI))
                    + Math.log(0.5 * (org.apache.commons.math3.special.Erf.erf(knob.low() / deviation / Math.sqrt(2), knob.high() / deviation / Math.sqrt(2))));
        }
        return sum;
    }

    /**
     * Evidence of a fit, over all scales.
     *
     * @param likelihood log of it at the fit @param normal equations there, priors included @param fit of a candidate as {@link #at} gives it
     */
    Summed evidence(double likelihood, Normal normal, Fitter.State fit) {
        double[] terms = new double[scales.length];
        for (int scale = 0; scale < terms.length; scale++) {
            terms[scale] = logs[scale] + at(likelihood, normal, fit, at(fit.candidate(), scale));
        }
        return new Summed(LogSum.of(terms), LogSum.greatest(terms));
    }

    /** @param best the likeliest scale */
    record Summed(double log, int best) { }

    private double at(double likelihood, Normal normal, Fitter.State fit, Candidate other) {
        int n = fit.x().length;
        double[] gradient = normal.gradient().clone();
        double[][] curvature = Arrays.stream(normal.curvature()).map(double[]::clone).toArray(double[][]::new);
        double[] low = new double[n];
        double[] high = new double[n];
        for (int i = 0; i < n; i++) {
            double more = precision(other.knobs().get(i)) - precision(fit.candidate().knobs().get(i));
            gradient[i] += more * fit.x()[i];
            curvature[i][i] += more;
            low[i] = Math.min(0, other.knobs().get(i).low() - fit.x()[i]);
            high[i] = Math.max(0, other.knobs().get(i).high() - fit.x()[i]);
        }
        return LaplaceEvidence.log(likelihood + log(other, fit.x()), gradient, curvature, low, high);
    }

    private static double precision(Knob knob) {
        return 1 / (knob.deviation() * knob.deviation());
    }
}

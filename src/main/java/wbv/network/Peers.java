package wbv.network;

import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import wbv.filter.AccompaniedEstimator;
import wbv.filter.BodyEstimate;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.drift.Alarm;
import wbv.filter.model.Spec;
import wbv.identify.Pole;
import wbv.identify.RefinedInstruments;
import wbv.identify.Samples;
import wbv.signal.Fft;
import wbv.signal.Taper;

/** What the networks are measured against: methods that know the physics and need no training. */
public final class Peers {

    private static final double TAU = 2 * Math.PI;
    private static final int WHITTLE = 256;

    private Peers() {}

    /**
     * The thesis' benchmark: refined instrumental variables, a transfer function of twice as many poles as modes.
     *
     * @param motion excitation and answer, each a series [m/s²], at {@value Imaging#RATE} Hz. Not modified.
     */
    public static Estimate instruments(double[][] motion, int modes) {
        double[] value = nothing(modes);
        double[] unknown = nothing(modes);
        try {
            Samples samples = Samples.of(Imaging.RATE, withoutMean(motion[0]), withoutMean(motion[1]));
            List<Pole> found = new RefinedInstruments(2 * modes, 2 * modes - 1, TAU * 5).fit(samples).model().poles().modes();
            for (int i = 0; i < modes && found.size() >= modes; i++) {
                value[2 * i] = found.get(i).damping();
                value[2 * i + 1] = TAU * found.get(i).frequency();
            }
        } catch (ArithmeticException | IllegalArgumentException | IllegalStateException withoutAnswer) {
            return new Estimate(value, unknown);
        }
        return new Estimate(value, unknown);
    }

    /**
     * A streaming estimator, from its usual start (5 Hz, ζ 0.4) to the end of the stretch.
     *
     * @param motion excitation, answer, and what else moves the base, each a series in its own unit: that is learned and taken away. Not
     *               modified.
     * @param alarms of the filters in it
     */
    public static Estimate stream(double[][] motion, int modes, Method method, Supplier<? extends Alarm> alarms) {
        double[] others = new double[motion.length - 2];
        AccompaniedEstimator accompanied = new AccompaniedEstimator(EstimatorDesign.of(method).withDegrees(modes)
                .estimator(Spec.at(Imaging.RATE), alarms), others.length);
        for (int i = 0; i < motion[0].length; i++) {
            for (int j = 0; j < others.length; j++) {
                others[j] = motion[2 + j][i];
            }
            accompanied.step(motion[0][i], others, motion[1][i]);
        }
        BodyEstimate track = accompanied.estimator().track();
        double[] value = new double[2 * modes];
        double[] deviation = new double[2 * modes];
        for (int i = 0; i < modes; i++) {
            value[2 * i] = track.damping(i);
            value[2 * i + 1] = TAU * track.frequency(i);
            deviation[2 * i] = track.dampingDeviation(i);
            deviation[2 * i + 1] = TAU * track.frequencyDeviation(i);
        }
        return new Estimate(value, deviation);
    }

    /**
     * Least squares in frequency from the streaming estimators' usual start (5 Hz, ζ 0.4; the next mode at twice that).
     *
     * @param motion excitation, answer, and what else moves the base, by channel and sample, each in its own unit. Not modified.
     */
    public static Estimate fit(double[][] motion, int modes) {
        double[] start = new double[2 * modes];
        for (int i = 0; i < modes; i++) {
            start[2 * i] = 0.4;
            start[2 * i + 1] = TAU * 5 * (i + 1);
        }
        return fit(motion, new Estimate(start, nothing(modes)));
    }

    /**
     * The same from what is known of all bodies, or of this one.
     *
     * @param motion excitation, answer, and what else moves the base, by channel and sample, each in its own unit. Not modified.
     * @param known  mean and deviation of each target
     */
    public static Estimate fit(double[][] motion, Estimate known) {
        FrequencyFit.Found found = new FrequencyFit(known.value().length / 2, motion.length - 2).from(motion, known);
        return new Estimate(found.value(), found.deviation());
    }

    /**
     * One mode from its answer alone, as if its excitation were white from 0.5 to 10 Hz: the likelihood of the spectrum (Whittle
     * 1953), over a grid of 0.05 to 0.8 and 1.5 to 10 Hz.
     *
     * @param answer series as networks read it [m/s²]. Not modified.
     */
    public static Estimate spectrum(double[] answer) {
        double[] centred = withoutMean(answer);
        Taper.hann(Imaging.SAMPLES).apply(centred);
        double[] segment = Arrays.copyOf(centred, WHITTLE);
        new Fft(WHITTLE).forward(segment);
        double step = Imaging.RATE / WHITTLE;
        double[] value = nothing(1);
        double least = Double.POSITIVE_INFINITY;
        for (double zeta = 0.05; zeta <= 0.8; zeta += 0.01) {
            for (double natural = 1.5; natural <= 10; natural += 0.05) {
                double logs = 0;
                double scale = 0;
                int lines = 0;
                for (int k = (int) Math.ceil(0.5 / step); k * step <= 10; k++) {
                    double ratio = k * step / natural;
                    double slope = 4 * zeta * zeta * ratio * ratio;
                    double gain = (1 + slope) / ((1 - ratio * ratio) * (1 - ratio * ratio) + slope);
                    logs += Math.log(gain);
                    scale += (segment[2 * k] * segment[2 * k] + segment[2 * k + 1] * segment[2 * k + 1]) / gain;
                    lines++;
                }
                double cost = logs / lines + Math.log(scale / lines);
                if (cost < least) {
                    least = cost;
                    value[0] = zeta;
                    value[1] = TAU * natural;
                }
            }
        }
        return new Estimate(value, nothing(1));
    }

    private static double[] nothing(int modes) {
        double[] nothing = new double[2 * modes];
        Arrays.fill(nothing, Double.NaN);
        return nothing;
    }

    private static double[] withoutMean(double[] x) {
        double mean = Arrays.stream(x).average().orElse(0);
        return Arrays.stream(x).map(value -> value - mean).toArray();
    }
}

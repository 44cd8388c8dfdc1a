package wbv.network;

import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import wbv.filter.Alarm;
import wbv.filter.Estimator;
import wbv.filter.Method;
import wbv.filter.Recipe;
import wbv.filter.Spec;
import wbv.filter.Track;
import wbv.identify.Pole;
import wbv.identify.RefinedInstruments;
import wbv.identify.Samples;

/** What the networks are measured against: methods that know the physics and need no training. */
public final class Peers {

    private static final double TAU = 2 * Math.PI;

    private Peers() { }

    /**
     * The thesis' benchmark: refined instrumental variables, a transfer function of twice as many poles as modes.
     *
     * @param motion excitation and answer at {@value Imaging#RATE} Hz. Not modified.
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
     * @param alarms of the filters in it
     */
    public static Estimate stream(double[][] motion, int modes, Method method, Supplier<? extends Alarm> alarms) {
        Estimator estimator = Recipe.of(method).withDegrees(modes).estimator(Spec.at(Imaging.RATE), alarms);
        for (int i = 0; i < motion[0].length; i++) {
            estimator.step(motion[0][i], motion[1][i]);
        }
        Track track = estimator.track();
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

    /** Least squares in frequency from the streaming estimators' usual start (5 Hz, ζ 0.4; the next mode at twice that). */
    public static Estimate fit(double[][] motion, int modes) {
        double[] start = new double[2 * modes];
        for (int i = 0; i < modes; i++) {
            start[2 * i] = 0.4;
            start[2 * i + 1] = TAU * 5 * (i + 1);
        }
        FrequencyFit.Found found = new FrequencyFit(modes).from(motion, new Estimate(start, nothing(modes)));
        return new Estimate(found.value(), found.deviation());
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

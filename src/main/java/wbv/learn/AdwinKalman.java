package wbv.learn;

import com.github.javacliparser.FloatOption;
import com.github.javacliparser.StringOption;
import com.yahoo.labs.samoa.instances.Instance;
import java.util.Locale;
import moa.classifiers.AbstractClassifier;
import moa.core.Measurement;
import moa.core.StringUtils;
import wbv.filter.BodyEstimator;
import wbv.filter.Spec;
import wbv.filter.Track;

/**
 * MOA's face of {@link BodyEstimator}: the class attribute is the body's acceleration, one attribute that of its base, and an
 * attribute {@code t} [s], if there is one, says how fast samples come and where some are missing.
 */
public final class AdwinKalman extends AbstractClassifier implements BodyLearner {

    private static final long serialVersionUID = 1;
    private static final String TIME = "t";
    private static final String FIRST = "first";
    private static final int UNKNOWN = -2;
    private static final int NONE = -1;
    /** Missing samples past this many tell the estimator nothing more [s]. */
    private static final double LONGEST_FILL = 2;

    public final StringOption inputOption = new StringOption("input", 'i',
            "Attribute with the acceleration of the base [m/s²]: its name, its number from 1, or 'first' for the first that is "
            + "neither t nor the class.", FIRST);
    public final FloatOption frequencyOption = new FloatOption("frequency", 'f',
            "Natural frequency to start from [Hz].", 5, Spec.LEAST_FREQUENCY, Spec.MOST_FREQUENCY);
    public final FloatOption dampingOption = new FloatOption("damping", 'd',
            "Damping ratio to start from [1].", 0.4, Spec.LEAST_DAMPING, Spec.MOST_DAMPING);
    public final FloatOption rateOption = new FloatOption("rate", 'r',
            "Sampling rate [Hz] of streams without an attribute t [s].", 60, 1, 100000);
    public final FloatOption noiseOption = new FloatOption("noise", 'n',
            "Noise density of both sensors [m/s²/√Hz].", Spec.NOISE_DENSITY, 1e-9, 1e3);
    public final FloatOption driftOption = new FloatOption("drift", 'w',
            "How far the parameters may wander in one second, as a share of their value.", Spec.DRIFT, 0, 1);
    public final FloatOption deltaOption = new FloatOption("delta", 'a',
            "Probability of a false cut at one look of ADWIN.", 0.002, 1e-12, 0.5);

    private BodyEstimator estimator = estimator(60);
    private SampleTiming timing = new SampleTiming(60);
    private int input = UNKNOWN;
    private int time = UNKNOWN;
    private double firstInput;
    private double firstOutput;

    @Override
    public String getPurposeString() {
        return "Natural frequency and damping ratio of a body on a shaken base: an extended Kalman filter adapted by ADWIN.";
    }

    @Override
    public void resetLearningImpl() {
        timing = new SampleTiming(rateOption.getValue());
        estimator = estimator(rateOption.getValue());
        input = UNKNOWN;
        time = UNKNOWN;
    }

    private BodyEstimator estimator(double rate) {
        double noise = noiseOption.getValue() * Math.sqrt(rate / 2);
        return new BodyEstimator(new Spec(rate, frequencyOption.getValue(), dampingOption.getValue(), noise, noise,
                driftOption.getValue()), new AdwinAlarm(deltaOption.getValue()));
    }

    @Override
    public void trainOnInstanceImpl(Instance instance) {
        locate(instance);
        double t = time == NONE ? Double.NaN : instance.value(time);
        double u = instance.value(input);
        double y = instance.classValue();
        if (timing.learnsRate(t)) {
            estimator = estimator(timing.rate());
            estimator.step(firstInput, firstOutput);
        }
        firstInput = u;
        firstOutput = y;
        long missing = Math.min(timing.missingBefore(t), (long) (LONGEST_FILL * timing.rate()));
        for (long i = 0; i < missing; i++) {
            estimator.step(Double.NaN, Double.NaN);
        }
        estimator.step(u, y);
    }

    /** The output as foreseen from the input of this instance and everything before it. */
    @Override
    public double[] getVotesForInstance(Instance instance) {
        locate(instance);
        return new double[] {estimator.predict(instance.value(input))};
    }

    /** Finds the attributes by the header of the first instance. */
    private void locate(Instance instance) {
        if (input != UNKNOWN) {
            return;
        }
        time = NONE;
        int first = NONE;
        int named = NONE;
        String wanted = inputOption.getValue();
        for (int i = 0; i < instance.numAttributes(); i++) {
            String name = instance.attribute(i).name();
            if (i == instance.classIndex()) {
                continue;
            }
            if (name.equals(TIME)) {
                time = i;
            } else if (first == NONE) {
                first = i;
            }
            if (name.equals(wanted) || wanted.equals(String.valueOf(i + 1))) {
                named = i;
            }
        }
        int found = wanted.equals(FIRST) ? first : named;
        if (found == NONE) {
            throw new IllegalArgumentException("no attribute '" + wanted + "' beside the class in " + instance.dataset()
                    .getRelationName());
        }
        input = found;
    }

    @Override
    public Track track() {
        return estimator.track();
    }

    @Override
    public Spec spec() {
        return estimator.spec();
    }

    /** |H(f)| of the body as now known. @param f [Hz] */
    public double modulus(double f) {
        return estimator.modulus(f);
    }

    /** Covariance of the estimator's state, 5 by 5. A copy. */
    public double[] covariance() {
        return estimator.covariance();
    }

    @Override
    protected Measurement[] getModelMeasurementsImpl() {
        return TrackMeasurements.of(estimator.track());
    }

    @Override
    public void getModelDescription(StringBuilder out, int indent) {
        Track track = estimator.track();
        StringUtils.appendIndented(out, indent, String.format(Locale.ROOT,
                "One degree of freedom at %.4g Hz: natural frequency %.3f ± %.3f Hz, damping ratio %.3f ± %.3f (one standard "
                + "deviation)%s; %.3g m/s² of the output is not explained; %d cuts, %d divergences, %d gaps.",
                estimator.spec().rate(), track.frequency(), track.frequencyDeviation(), track.damping(),
                track.dampingDeviation(), track.settled() ? "" : ", not settled", track.outputNoise(), track.cuts(),
                track.divergences(), track.gaps()));
    }

    @Override
    public boolean isRandomizable() {
        return false;
    }
}

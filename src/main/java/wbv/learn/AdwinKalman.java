package wbv.learn;

import com.github.javacliparser.ClassOption;
import com.github.javacliparser.FloatOption;
import com.github.javacliparser.StringOption;
import moa.classifiers.core.driftdetection.ChangeDetector;
import wbv.filter.BodyEstimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.model.Spec;

/**
 * MOA's face of {@link BodyEstimator}: the class attribute is the body's acceleration, one attribute that of its base, and an
 * attribute {@code t} [s], if there is one, says how fast samples come and where some are missing.
 */
public non-sealed class AdwinKalman extends BodyRegressor {

    private static final long serialVersionUID = 1;

    public final StringOption inputOption = new StringOption("input", 'i',
            "Attribute with the acceleration of the base [m/s²]: its name, its number from 1, or 'first' for the first that is "
                    + "neither t nor the class.",
            InstanceFeed.FIRST);
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
    public final ClassOption detectorOption = new ClassOption("detector", 'a', Detectors.PURPOSE, ChangeDetector.class,
            Detectors.USUAL, Detectors.NONE);

    @Override
    public String getPurposeString() {
        return "Natural frequency and damping ratio of a body on a shaken base: a bank of extended Kalman filters, with a change "
                + "detector listening.";
    }

    @Override
    InstanceFeed freshFeed() {
        return new InstanceFeed(new BodySetup(EstimatorDesign.of(Method.EKF_ADWIN), frequencyOption.getValue(), dampingOption.getValue(),
                noiseOption.getValue(), driftOption.getValue(), detectorOption.getValueAsCLIString()), inputOption.getValue(),
                "", rateOption.getValue());
    }
}

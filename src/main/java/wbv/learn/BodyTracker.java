package wbv.learn;

import com.github.javacliparser.ClassOption;
import com.github.javacliparser.FloatOption;
import com.github.javacliparser.IntOption;
import com.github.javacliparser.MultiChoiceOption;
import com.github.javacliparser.StringOption;
import java.util.Arrays;
import moa.classifiers.core.driftdetection.ChangeDetector;
import wbv.filter.EstimatorDesign;
import wbv.filter.FixedBounds;
import wbv.filter.Method;
import wbv.filter.model.Spec;

/**
 * MOA's face of every estimator by its name: the class attribute is the body's motion, one attribute that of its base, two
 * accelerations or two angular rates; an attribute {@code t} [s], if there is one, says how fast samples come.
 */
public non-sealed class BodyTracker extends BodyRegressor {

    private static final long serialVersionUID = 1;
    private static final double USUAL_RATE = 60;

    public final MultiChoiceOption estimatorOption = new MultiChoiceOption("estimator", 'm', "How the body is estimated.",
            Method.words().toArray(String[]::new), Arrays.stream(Method.values()).map(Method::description).toArray(String[]::new),
            Method.FUSED.ordinal());
    public final StringOption inputOption = new StringOption("input", 'i',
            "Attribute with the motion of the base: its name, its number from 1, or 'first' for the first that is neither t nor "
                    + "the class.",
            InstanceFeed.FIRST);
    public final StringOption crossOption = new StringOption("cross", 'x',
            "Attributes with other motions of the base, separated by commas: what they do to the output is learned and taken away.",
            "");
    public final IntOption degreesOption = new IntOption("degrees", 'g', "Degrees of freedom of the body.", 1, 1, 2);
    public final FloatOption frequencyOption = new FloatOption("frequency", 'f',
            "Natural frequency to start from [Hz].", 5, Spec.LEAST_FREQUENCY, Spec.MOST_FREQUENCY);
    public final FloatOption dampingOption = new FloatOption("damping", 'd',
            "Damping ratio to start from [1].", 0.4, Spec.LEAST_DAMPING, Spec.MOST_DAMPING);
    public final FloatOption noiseOption = new FloatOption("noise", 'n',
            "Noise density of both sensors [m/s²/√Hz, or rad/s/√Hz].", Spec.NOISE_DENSITY, 1e-9, 1e3);
    public final IntOption particlesOption = new IntOption("particles", 'p', "Particles of a particle filter.",
            EstimatorDesign.USUAL_PARTICLES, EstimatorDesign.LEAST_PARTICLES, EstimatorDesign.MOST_PARTICLES);
    public final IntOption seedOption = new IntOption("seed", 'r', "Seed of a particle filter's random numbers.", 1, 0,
            Integer.MAX_VALUE);
    public final StringOption boundsOption = new StringOption("bounds", 'b',
            "Bounds for the constrained estimator, such as frequency=3:6,damping=0.2:0.5.", "");
    public final ClassOption detectorOption = new ClassOption("detector", 'a', Detectors.PURPOSE, ChangeDetector.class,
            Detectors.USUAL, Detectors.NONE);

    @Override
    public String getPurposeString() {
        return "Natural frequency and damping ratio of a body on a shaken base, by any of wbv's estimators.";
    }

    @Override
    InstanceFeed freshFeed() {
        EstimatorDesign design = new EstimatorDesign(Method.values()[estimatorOption.getChosenIndex()], degreesOption.getValue(),
                particlesOption.getValue(), seedOption.getValue(), FixedBounds.parse(boundsOption.getValue()));
        return new InstanceFeed(new BodySetup(design, frequencyOption.getValue(), dampingOption.getValue(),
                noiseOption.getValue(),
                Spec.DRIFT, detectorOption.getValueAsCLIString()), inputOption.getValue(), crossOption.getValue(), USUAL_RATE);
    }
}

package wbv.learn;

import com.yahoo.labs.samoa.instances.Instance;
import java.io.Serializable;
import wbv.filter.Estimator;

/**
 * Feeds an estimator with instances: the class attribute is the body's motion, one attribute that of its base, and an
 * attribute {@code t} [s], if there is one, says how fast samples come and where some are missing.
 */
final class InstanceFeed implements Serializable {

    private static final long serialVersionUID = 1;

    /** The input that is the first attribute which is neither t nor the class. */
    static final String FIRST = "first";

    private static final String TIME = "t";
    private static final int UNKNOWN = -2;
    private static final int NONE = -1;
    /** Missing samples past this many tell the estimator nothing more [s]. */
    private static final double LONGEST_FILL = 2;

    private final BodySetup setup;
    private final String wanted;
    private final SampleTiming timing;
    private Estimator estimator;
    private int input = UNKNOWN;
    private int time = UNKNOWN;
    private double firstInput;
    private double firstOutput;

    /**
     * @param wanted name or number (from 1) of the input attribute, or {@link #FIRST}
     * @param rate where there are no times [Hz]
     */
    InstanceFeed(BodySetup setup, String wanted, double rate) {
        this.setup = setup;
        this.wanted = wanted;
        this.timing = new SampleTiming(rate);
        this.estimator = setup.estimator(rate);
    }

    Estimator estimator() {
        return estimator;
    }

    void train(Instance instance) {
        locate(instance);
        double t = time == NONE ? Double.NaN : instance.value(time);
        double u = instance.value(input);
        double y = instance.classValue();
        if (timing.learnsRate(t)) {
            estimator = setup.estimator(timing.rate());
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
    double predict(Instance instance) {
        locate(instance);
        return estimator.predict(instance.value(input));
    }

    /** Finds the attributes by the header of the first instance. */
    private void locate(Instance instance) {
        if (input != UNKNOWN) {
            return;
        }
        time = NONE;
        int first = NONE;
        int named = NONE;
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
}

package wbv.learn;

import com.yahoo.labs.samoa.instances.Instance;
import java.io.Serializable;
import java.util.Arrays;
import wbv.filter.AccompaniedEstimator;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.ShareExplained;

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
    private final String[] crossing;
    private final SampleTiming timing;
    private final int[] cross;
    private final double[] others;
    private final double[] firstOthers;
    private final double[] noOthers;
    private final ShareExplained explained = new ShareExplained();
    private AccompaniedEstimator estimator;
    private int input = UNKNOWN;
    private int time = UNKNOWN;
    private double firstInput;
    private double firstOutput;

    /**
     * @param wanted name or number (from 1) of the input attribute, or {@link #FIRST}
     * @param crossing names or numbers of attributes with other motions of the base, separated by commas; may be empty
     * @param rate where there are no times [Hz]
     */
    InstanceFeed(BodySetup setup, String wanted, String crossing, double rate) {
        this.setup = setup;
        this.wanted = wanted;
        this.crossing = crossing.isBlank() ? new String[0] : Arrays.stream(crossing.split(",")).map(String::strip).toArray(String[]::new);
        this.cross = new int[this.crossing.length];
        this.others = new double[cross.length];
        this.firstOthers = new double[cross.length];
        this.noOthers = new double[cross.length];
        Arrays.fill(noOthers, Double.NaN);
        this.timing = new SampleTiming(rate);
        this.estimator = accompanied(rate);
    }

    private AccompaniedEstimator accompanied(double rate) {
        return new AccompaniedEstimator(setup.estimator(rate), cross.length);
    }

    Estimator estimator() {
        return estimator.estimator();
    }

    void train(Instance instance) {
        locate(instance);
        double t = time == NONE ? Double.NaN : instance.value(time);
        double u = instance.value(input);
        double y = instance.classValue();
        if (timing.learnsRate(t)) {
            estimator = accompanied(timing.rate());
            estimator.step(firstInput, firstOthers, firstOutput);
        }
        readOthers(instance);
        firstInput = u;
        firstOutput = y;
        System.arraycopy(others, 0, firstOthers, 0, others.length);
        long missing = Math.min(timing.missingBefore(t), (long) (LONGEST_FILL * timing.rate()));
        for (long i = 0; i < missing; i++) {
            estimator.step(Double.NaN, noOthers, Double.NaN);
        }
        BodyEstimate track = estimator.step(u, others, y);
        explained.accept(track.prediction(), y, timing.rate(), track.excited());
    }

    /** What the predictions explained so far. */
    ShareExplained explained() {
        return explained;
    }

    /** The output as foreseen from the input of this instance and everything before it. */
    double predict(Instance instance) {
        locate(instance);
        readOthers(instance);
        return estimator.predict(instance.value(input), others);
    }

    private void readOthers(Instance instance) {
        for (int i = 0; i < cross.length; i++) {
            others[i] = instance.value(cross[i]);
        }
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
            throw missing(wanted, instance);
        }
        for (int i = 0; i < cross.length; i++) {
            cross[i] = indexOf(crossing[i], instance);
            if (cross[i] == found) {
                throw new IllegalArgumentException("'" + crossing[i] + "' is the input already; a crossing motion is another");
            }
        }
        input = found;
    }

    private static int indexOf(String name, Instance instance) {
        for (int i = 0; i < instance.numAttributes(); i++) {
            if (i != instance.classIndex() && (name.equals(instance.attribute(i).name()) || name.equals(String.valueOf(i + 1)))) {
                return i;
            }
        }
        throw missing(name, instance);
    }

    private static IllegalArgumentException missing(String name, Instance instance) {
        return new IllegalArgumentException("no attribute '" + name + "' beside the class in "
                + instance.dataset().getRelationName());
    }
}

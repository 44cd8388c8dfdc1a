package wbv.state;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import wbv.state.markov.Forecast;
import wbv.state.markov.HiddenMarkov;

/**
 * A trained recogniser of motion states. What is done to the sitter is a hidden chain, seen by how the seat shakes, surges and
 * sways; in a jolt a state of the chain says too which way seat and head jerk, and is seen by their jerks.
 *
 * <p>A jerk of j m/s³ was read with an error of some standard deviation, so it is beyond the threshold with a probability (a
 * logistic one, which is normal within a hundredth), and the states of a jolt that agree with it are raised by that over how often
 * they are met. Outside of jolts the jerks say nothing: strong vibration jerks as well.
 *
 * @param features   from which channels
 * @param thresholds by which samples were named
 * @param mixture    how the mixtures were found, such as {@code message-length}
 * @param chain      over {@link #activity the last three features}
 * @param activities of the chain's states, K
 * @param names of the chain's states, K
 * @param shares     by state, how often it is met among those of its jolt, K long; 1 for others. Not copied; do not change them.
 * @param error      standard deviation of a jerk that is read [m/s³], &gt; 0
 * @param trials     names of the recordings it was trained on
 * @param rows       of every named state in the training
 */
public record StateModel(FeatureSpec features, Thresholds thresholds, String mixture, HiddenMarkov chain,
        List<Activity> activities, List<MotionState> names, double[] shares, double error, List<String> trials,
        Map<MotionState, Integer> rows) implements Serializable {

    public StateModel {
        activities = List.copyOf(activities);
        names = List.copyOf(names);
        trials = List.copyOf(trials);
        rows = new LinkedHashMap<>(rows);
        int k = chain.states();
        if (names.size() != k || activities.size() != k || shares.length != k || chain.dimensions() != FeatureSpec.OF_ACTIVITY) {
            throw new IllegalArgumentException("a state model needs a name, an activity and a share for each of " + k
                    + " states and " + FeatureSpec.OF_ACTIVITY + " dimensions: " + names.size() + ", " + activities.size() + ", "
                    + shares.length + ", " + chain.dimensions());
        }
        for (int i = 0; i < k; i++) {
            if (names.get(i).jerk() && activities.get(i) != Activity.JOLT || !(shares[i] > 0 && shares[i] <= 1)) {
                throw new IllegalArgumentException("state " + i + " must jerk in jolts alone, with a share > 0 to 1: " + names.get(i)
                        + ", " + activities.get(i) + ", " + shares[i]);
            }
        }
        if (!(error > 0) || Double.isInfinite(error)) {
            throw new IllegalArgumentException("the error of a jerk must be > 0 m/s³: " + error);
        }
    }

    /**
     * The features that tell the activity.
     *
     * @param row as {@link FeatureSpec#NAMES}. Not modified.
     * @param into 3. Modified.
     */
    static void activity(double[] row, double[] into) {
        System.arraycopy(row, row.length - into.length, into, 0, into.length);
    }

    /** The named states that the model knows, in their order. */
    public Set<MotionState> known() {
        return EnumSet.copyOf(names);
    }

    /**
     * Adds up the chain's states by name.
     *
     * @param chain probabilities, K long. Not modified.
     * @param into probabilities, one for each {@link MotionState}. Modified.
     */
    public void byName(double[] chain, double[] into) {
        java.util.Arrays.fill(into, 0);
        for (int k = 0; k < chain.length; k++) {
            into[names.get(k).ordinal()] += chain[k];
        }
    }

    /** Which states of the chain jerk. */
    public boolean[] jerks() {
        boolean[] jerks = new boolean[names.size()];
        for (int k = 0; k < jerks.length; k++) {
            jerks[k] = names.get(k).jerk();
        }
        return jerks;
    }

    /**
     * Probabilities of going from one named state to another in one sample, in the order of {@link #known}, when the chain has
     * run
     * for long: its components weighted by how often they are met.
     */
    public double[][] transitions() {
        double[] often = stationary();
        List<MotionState> order = new ArrayList<>(known());
        double[][] named = new double[order.size()][order.size()];
        double[] whole = new double[order.size()];
        for (int i = 0; i < often.length; i++) {
            int from = order.indexOf(names.get(i));
            whole[from] += often[i];
            for (int j = 0; j < often.length; j++) {
                named[from][order.indexOf(names.get(j))] += often[i] * chain.transition()[i][j];
            }
        }
        for (int i = 0; i < named.length; i++) {
            for (int j = 0; j < named.length; j++) {
                named[i][j] /= whole[i];
            }
        }
        return named;
    }

    /** Shares of time of the chain's states in the long run, K long. */
    public double[] stationary() {
        double[] now = new double[chain.states()];
        java.util.Arrays.fill(now, 1.0 / now.length);
        for (int round = 0; round < 5000; round++) {
            now = Forecast.ahead(chain, now, 1);
        }
        return now;
    }

    /** Share of time in every named state in the long run, in the order of {@link #known}. */
    public double[] longRun() {
        double[] byName = new double[MotionState.values().length];
        byName(stationary(), byName);
        return known().stream().mapToDouble(state -> byName[state.ordinal()]).toArray();
    }
}

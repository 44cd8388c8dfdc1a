package wbv.state;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A trained recogniser of motion states. Every named state is a mixture, and every component of it is a state of the hidden
 * chain, so that what comes next may depend on more than the name.
 *
 * @param features   from which channels @param thresholds by which samples were named
 * @param mixture    how the mixtures were found, such as {@code message-length}
 * @param chain      the hidden Markov model over all components, one normal density a state
 * @param names      of the chain's states, K
 * @param trials     names of the recordings it was trained on
 * @param rows       of every named state in the training
 */
public record StateModel(FeatureSpec features, Thresholds thresholds, String mixture, HiddenMarkov chain,
                         List<MotionState> names, List<String> trials, Map<MotionState, Integer> rows) implements Serializable {

    public StateModel {
        names = List.copyOf(names);
        trials = List.copyOf(trials);
        rows = new LinkedHashMap<>(rows);
        if (names.size() != chain.states() || chain.dimensions() != FeatureSpec.NAMES.size()) {
            throw new IllegalArgumentException("a state model needs a name for each of " + chain.states() + " states and "
                    + FeatureSpec.NAMES.size() + " dimensions: " + names.size() + ", " + chain.dimensions());
        }
    }

    /** The named states that the model knows, in their order. */
    public Set<MotionState> known() {
        return EnumSet.copyOf(names);
    }

    /**
     * Adds up the chain's states by name. @param chain K. Not modified. @param into one for each {@link MotionState}. Modified.
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

    /** How often the chain's states are met in the long run, K. */
    public double[] stationary() {
        double[] now = new double[chain.states()];
        java.util.Arrays.fill(now, 1.0 / now.length);
        for (int round = 0; round < 5000; round++) {
            now = Forecast.ahead(chain, now, 1);
        }
        return now;
    }

    /** Share of time in every named state in the long run, in the order of {@link #known}. */
    public double[] shares() {
        double[] byName = new double[MotionState.values().length];
        byName(stationary(), byName);
        return known().stream().mapToDouble(state -> byName[state.ordinal()]).toArray();
    }
}

package wbv.state.markov;

import java.io.Serializable;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.state.mixture.Mixture;

/**
 * A hidden Markov model with a mixture of normal densities in every state; a mixture of one is a normal density.
 * Thesis: Eq. 7-3, 7-4.
 *
 * @param initial    probabilities of the first state, K long. Not copied; do not change them.
 * @param transition probabilities from state (row) to state (column), K by K, rows sum to one. Not copied; do not change them.
 * @param emissions  density of a row in every state, K
 */
public record HiddenMarkov(double[] initial, double[][] transition, List<Mixture> emissions) implements Serializable {

    private static final double ROUNDING = 1e-6;

    public HiddenMarkov {
        emissions = List.copyOf(emissions);
        int k = emissions.size();
        if (k == 0 || initial.length != k || transition.length != k) {
            throw new IllegalArgumentException("a hidden Markov model needs one initial probability, transition row and emission"
                    + " for each state: " + initial.length + ", " + transition.length + ", " + k);
        }
        requireSum("initial probabilities", initial, k);
        for (int i = 0; i < k; i++) {
            requireSum("transitions from state " + i, transition[i], k);
            if (emissions.get(i).dimensions() != emissions.get(0).dimensions()) {
                throw new IllegalArgumentException("all states must have " + emissions.get(0).dimensions() + " dimensions");
            }
        }
    }

    private static void requireSum(String what, double[] shares, int count) {
        double sum = 0;
        for (double share : shares) {
            sum += share >= 0 ? share : Double.NaN;
        }
        if (shares.length != count || !(Math.abs(sum - 1) < ROUNDING)) {
            throw new IllegalArgumentException(what + " must be " + count + " shares that sum to 1: sum " + sum);
        }
    }

    /** Number of states. */
    public int states() {
        return initial.length;
    }

    /** Length d of a row. */
    public int dimensions() {
        return emissions.get(0).dimensions();
    }

    /** Largest number of components in a state. */
    int mostComponents() {
        return emissions.stream().mapToInt(Mixture::size).max().orElseThrow();
    }

    /**
     * A random sequence; returns its states.
     *
     * @param into T by d, each column in its own unit. Modified.
     */
    public int[] sample(RandomGenerator random, double[][] into) {
        int[] states = new int[into.length];
        for (int t = 0; t < into.length; t++) {
            states[t] = draw(random, t == 0 ? initial : transition[states[t - 1]]);
            emissions.get(states[t]).sample(random, into[t]);
        }
        return states;
    }

    private static int draw(RandomGenerator random, double[] shares) {
        double u = random.nextDouble();
        int i = 0;
        while (i + 1 < shares.length && u >= shares[i]) {
            u -= shares[i];
            i++;
        }
        return i;
    }

    /**
     * A model whose states are the components of a mixture, with transitions counted between the likeliest components of
     * neighbouring rows.
     *
     * @param sequences rows with NaN are passed over
     * @param pseudo counts [1] that every transition has beforehand, &gt; 0
     */
    public static HiddenMarkov of(Mixture mixture, List<double[][]> sequences, double pseudo) {
        int k = mixture.size();
        double[] initial = new double[k];
        double[][] transition = new double[k][k];
        java.util.Arrays.fill(initial, pseudo);
        for (double[] row : transition) {
            java.util.Arrays.fill(row, pseudo);
        }
        for (double[][] sequence : sequences) {
            int[] labels = mixture.labels(sequence);
            int before = -1;
            for (int t = 0; t < labels.length; t++) {
                int label = Rows.complete(sequence[t]) ? labels[t] : -1;
                if (label >= 0 && before >= 0) {
                    transition[before][label]++;
                } else if (label >= 0 && t == 0) {
                    initial[label]++;
                }
                before = label;
            }
        }
        normalise(initial);
        for (double[] row : transition) {
            normalise(row);
        }
        return new HiddenMarkov(initial, transition, mixture.components().stream().map(Mixture::of).toList());
    }

    /**
     * Makes shares add up to 1.
     *
     * @param shares as many as wanted. Modified.
     */
    public static void normalise(double[] shares) {
        double sum = 0;
        for (double share : shares) {
            sum += share;
        }
        for (int i = 0; i < shares.length; i++) {
            shares[i] /= sum;
        }
    }
}

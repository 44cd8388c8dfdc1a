package wbv.state.markov;

import java.io.Serializable;
import java.util.Arrays;

/**
 * How probabilities of a chain's states go on to the next row, {@code Σ_i p_i T_ij}. Of a chain that was learned most transitions were
 * seen never and have what their row has at least; then that least is counted for the row as a whole, and what is above it one by
 * one: of the 1296 products of 36 states that ship remain 212. Nothing cancels, since nothing is below the least.
 */
final class Transitions implements Serializable {

    private static final long serialVersionUID = 1;
    /** A product by itself costs as much as this many in a row. */
    private static final int DEARER = 3;

    private final int states;
    /** Row by row; empty where most are the least of their row. */
    private final double[] whole;
    /** Least of each row. */
    private final double[] least;
    /** Where each row begins among what is above the least, and where the last one ends. */
    private final int[] begins;
    private final int[] to;
    private final double[] more;

    Transitions(double[][] transition) {
        int k = transition.length;
        states = k;
        least = new double[k];
        int above = 0;
        for (int i = 0; i < k; i++) {
            least[i] = Double.POSITIVE_INFINITY;
            for (double each : transition[i]) {
                least[i] = Math.min(least[i], each);
            }
            for (double each : transition[i]) {
                above += each > least[i] ? 1 : 0;
            }
        }
        boolean sparse = DEARER * above < k * k;
        whole = new double[sparse ? 0 : k * k];
        begins = new int[sparse ? k + 1 : 0];
        to = new int[sparse ? above : 0];
        more = new double[sparse ? above : 0];
        if (!sparse) {
            for (int i = 0; i < k; i++) {
                System.arraycopy(transition[i], 0, whole, i * k, k);
            }
            return;
        }
        int at = 0;
        for (int i = 0; i < k; i++) {
            begins[i] = at;
            for (int j = 0; j < k; j++) {
                if (transition[i][j] > least[i]) {
                    to[at] = j;
                    more[at++] = transition[i][j] - least[i];
                }
            }
        }
        begins[k] = at;
    }

    /** The least of all transitions. */
    double least() {
        double all = 1;
        for (double each : least) {
            all = Math.min(all, each);
        }
        return all;
    }

    /**
     * @param now K long. Not modified.
     * @param next K long, another array. Modified.
     */
    void advance(double[] now, double[] next) {
        if (whole.length > 0) {
            products(now, next);
            return;
        }
        Arrays.fill(next, 0);
        double everywhere = 0;
        for (int i = 0; i < states; i++) {
            double p = now[i];
            if (p == 0) {
                continue; // most states are, where one is plain
            }
            everywhere += p * least[i];
            for (int e = begins[i]; e < begins[i + 1]; e++) {
                next[to[e]] += p * more[e];
            }
        }
        for (int j = 0; j < states; j++) {
            next[j] += everywhere;
        }
    }

    private void products(double[] now, double[] next) {
        Arrays.fill(next, 0);
        for (int i = 0; i < states; i++) {
            double p = now[i];
            if (p == 0) {
                continue;
            }
            int at = i * states;
            for (int j = 0; j < states; j++) {
                next[j] += p * whole[at + j];
            }
        }
    }
}

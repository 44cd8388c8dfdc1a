package wbv.state.markov;

import java.util.Arrays;

/**
 * How likely one of some states is to be met within the next rows: one minus the probability of every path that avoids them. With
 * A restricted to all other states, P = 1 - p A' A' … 1; the product to the right of p is worked out once.
 */
public final class Forecast {

    private final double[] avoid;

    /**
     * Works the product out.
     *
     * @param wanted whether a state is one of those that are looked out for, K. Not modified.
     * @param from first row that counts, 1 is the next
     * @param to last row that counts, &gt;= from
     */
    public Forecast(HiddenMarkov model, boolean[] wanted, int from, int to) {
        if (!(from >= 1 && to >= from)) {
            throw new IllegalArgumentException("rows ahead must be >= 1 and rise: " + from + ", " + to);
        }
        int k = model.states();
        double[] value = new double[k];
        Arrays.fill(value, 1);
        for (int step = to; step >= 1; step--) {
            double[] before = new double[k];
            for (int i = 0; i < k; i++) {
                for (int j = 0; j < k; j++) {
                    before[i] += step >= from && wanted[j] ? 0 : model.transition()[i][j] * value[j];
                }
            }
            value = before;
        }
        avoid = value;
    }

    /**
     * Probability P(a wanted state within the rows).
     *
     * @param probabilities of the states now, K long. Not modified.
     */
    public double probability(double[] probabilities) {
        double avoided = 0;
        for (int i = 0; i < avoid.length; i++) {
            avoided += probabilities[i] * avoid[i];
        }
        return Math.max(0, Math.min(1, 1 - avoided));
    }

    /**
     * Probabilities of the states so many rows ahead, K long.
     *
     * @param probabilities of the states now, K long. Not modified.
     */
    public static double[] ahead(HiddenMarkov model, double[] probabilities, int rows) {
        double[] now = probabilities.clone();
        for (int step = 0; step < rows; step++) {
            double[] next = new double[now.length];
            for (int i = 0; i < now.length; i++) {
                for (int j = 0; j < now.length; j++) {
                    next[j] += now[i] * model.transition()[i][j];
                }
            }
            now = next;
        }
        return now;
    }
}

package wbv.state;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A hidden Markov model that grows with labelled rows, one normal density a label, and says how likely every label is given all
 * rows. Labels teach densities and transitions; where the chain is, it tells from the rows, or is told too.
 */
public final class GrowingChain implements Serializable {

    private static final long serialVersionUID = 1;
    /** The model is made anew when the rows have grown by this share, so that its cost per row stays level. */
    private static final double GROWTH = 1.05;
    private static final double PSEUDO = 0.1;
    private static final double FLOOR = 1e-6;

    private final Shape shape;
    private final int labels;
    private final int d;
    private final double[] rows;
    private final double[][] mean;
    private final double[][] products;
    private final double[][] transitions;
    private final double[] away;
    private List<ForwardFilter> filter = new ArrayList<>();
    private int[] known = new int[0];
    private double[] byState = new double[0];
    private double total;
    private double due = 2;
    private int before = -1;

    /** @param labels how many there may be @param d dimensions of a row */
    public GrowingChain(int labels, int d, Shape shape) {
        this.shape = shape;
        this.labels = labels;
        this.d = d;
        rows = new double[labels];
        mean = new double[labels][d];
        products = new double[labels][d * d];
        transitions = new double[labels][labels];
        away = new double[d];
    }

    /**
     * Takes a row with its label; one with a missing value counts for the transitions only. @param row length d. Not modified.
     */
    public void learn(double[] row, int label) {
        learn(row, label, false);
    }

    /** The same. @param told whether the label says where the chain is; otherwise it teaches only, and the rows say that */
    public void learn(double[] row, int label, boolean told) {
        if (before >= 0) {
            transitions[before][label]++;
        }
        before = label;
        if (Rows.complete(row)) {
            total++;
            double n = ++rows[label];
            for (int i = 0; i < d; i++) {
                away[i] = row[i] - mean[label][i];
            }
            for (int i = 0; i < d; i++) {
                mean[label][i] += away[i] / n;
                for (int j = 0; j < d; j++) {
                    products[label][i * d + j] += away[i] * away[j] * (n - 1) / n;
                }
            }
        }
        if (total >= due) {
            grow();
            due = total * GROWTH + 1;
        }
        if (!filter.isEmpty()) {
            filter.get(0).step(row);
        }
        int state = Arrays.binarySearch(known, label);
        if (told && state >= 0) {
            Arrays.fill(byState, 0);
            byState[state] = 1;
            filter.get(0).know(byState);
        }
    }

    /** Takes a row without a label. @param row length d. Not modified. */
    public void follow(double[] row) {
        if (!filter.isEmpty()) {
            filter.get(0).step(row);
        }
    }

    /** How likely every label is after this row, which is not taken. @param into one for each label. Modified. */
    public void votes(double[] row, double[] into) {
        Arrays.fill(into, 0);
        if (filter.isEmpty()) {
            return;
        }
        filter.get(0).look(row, byState);
        for (int k = 0; k < known.length; k++) {
            into[known[k]] += byState[k];
        }
    }

    /** Number of labels that have rows enough for a density. */
    public int known() {
        return known.length;
    }

    private void grow() {
        int[] fresh = java.util.stream.IntStream.range(0, labels).filter(label -> rows[label] >= 2).toArray();
        if (fresh.length == 0) {
            return;
        }
        double[] floor = floor();
        double[] initial = new double[fresh.length];
        double[][] to = new double[fresh.length][fresh.length];
        List<Mixture> emissions = new ArrayList<>();
        double[] was = new double[labels];
        for (int k = 0; k < known.length && !filter.isEmpty(); k++) {
            was[known[k]] = filter.get(0).probability(k);
        }
        for (int k = 0; k < fresh.length; k++) {
            int label = fresh[k];
            initial[k] = filter.isEmpty() ? rows[label] : was[label] + 1e-6;
            for (int j = 0; j < fresh.length; j++) {
                to[k][j] = transitions[label][fresh[j]] + PSEUDO;
            }
            HiddenMarkov.normalise(to[k]);
            double n = rows[label];
            // Shrunk towards the spread of all by one row, so that a label seen twice has a density.
            double[] covariance = new double[d * d];
            for (int i = 0; i < d; i++) {
                for (int j = 0; j < d; j++) {
                    covariance[i * d + j] = products[label][i * d + j] / n + (i == j ? floor[i] / FLOOR / (n * n) : 0);
                }
            }
            emissions.add(Mixture.of(Gaussian.of(shape, mean[label], covariance, floor)));
        }
        HiddenMarkov.normalise(initial);
        // A chain that goes on where the old one was: its first row is foreseen by the transitions.
        double[] ahead = new double[fresh.length];
        for (int k = 0; k < fresh.length; k++) {
            for (int j = 0; j < fresh.length; j++) {
                ahead[j] += initial[k] * to[k][j];
            }
        }
        filter = new ArrayList<>(List.of(new ForwardFilter(new HiddenMarkov(ahead, to, emissions))));
        known = fresh;
        byState = new double[fresh.length];
    }

    /** A millionth of the variance of all rows. */
    private double[] floor() {
        double[] floor = new double[d];
        for (int i = 0; i < d; i++) {
            double centre = 0;
            for (int label = 0; label < labels; label++) {
                centre += rows[label] / total * mean[label][i];
            }
            double variance = 0;
            for (int label = 0; label < labels; label++) {
                double off = mean[label][i] - centre;
                variance += (products[label][i * d + i] + rows[label] * off * off) / total;
            }
            floor[i] = FLOOR * Math.max(variance, 1e-12 * (1 + centre * centre));
        }
        return floor;
    }
}

package wbv.state.markov;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import wbv.state.mixture.CovarianceShape;
import wbv.state.mixture.Gaussian;
import wbv.state.mixture.Mixture;

/**
 * A hidden Markov model that grows with labelled rows, up to eight normal densities a label, each a state of the chain, and says how
 * likely every label is given all rows. A row goes to the density of its label that it is likeliest under; one that is farther from
 * all of them than one in a thousand would be begins another. Labels teach densities and transitions; where the chain is, it tells
 * from the rows, or is told too.
 */
public final class GrowingChain implements Serializable {

    private static final long serialVersionUID = 2;
    /** The model is made anew when the rows have grown by this share, so that its cost per row stays level. */
    private static final double GROWTH = 1.05;
    private static final double PSEUDO = 0.02;
    private static final double FLOOR = 1e-6;
    /** Densities of a label at most. */
    private static final int PARTS = 8;
    private static final double FAR = 0.999;
    /** Rows for each dimension that a density needs before another is begun beside it. */
    private static final int RIPE = 5;

    private final CovarianceShape shape;
    private final int d;
    private final double far;
    /** By label and part. */
    private final double[] rows;
    private final double[][] mean;
    private final double[][] products;
    private final double[][] transitions;
    private final double[] away;
    private List<ForwardFilter> filter = new ArrayList<>();
    /** Places, by label and part, of the chain's states; rising. */
    private int[] known = new int[0];
    private double[] byState = new double[0];
    private double[] peaks = new double[0];
    private double total;
    private double due = 2;
    private int before = -1;

    /**
     * A chain of no state yet.
     *
     * @param labels how many there may be
     * @param d dimensions of a row
     */
    public GrowingChain(int labels, int d, CovarianceShape shape) {
        this.shape = shape;
        this.d = d;
        int places = labels * PARTS;
        far = new ChiSquaredDistribution(d).inverseCumulativeProbability(FAR);
        rows = new double[places];
        mean = new double[places][d];
        products = new double[places][d * d];
        transitions = new double[places][places];
        away = new double[d];
    }

    /**
     * Takes a row with its label, which teaches only.
     *
     * @param row length d, each number in its own unit. Not modified.
     */
    public void learn(double[] row, int label) {
        learn(row, label, false);
    }

    /**
     * Takes a row with its label; one with a missing value counts for the transitions only.
     *
     * @param row length d, each number in its own unit. Not modified.
     * @param told whether the label says where the chain is; otherwise the rows say that
     */
    public void learn(double[] row, int label, boolean told) {
        int place = place(row, label);
        if (before >= 0) {
            transitions[before][place]++;
        }
        before = place;
        if (Rows.complete(row)) {
            total++;
            double n = ++rows[place];
            for (int i = 0; i < d; i++) {
                away[i] = row[i] - mean[place][i];
            }
            for (int i = 0; i < d; i++) {
                mean[place][i] += away[i] / n;
                for (int j = 0; j < d; j++) {
                    products[place][i * d + j] += away[i] * away[j] * (n - 1) / n;
                }
            }
        }
        if (total >= due) {
            grow();
            due = total * GROWTH + 1;
        }
        follow(row);
        if (told) {
            know(label);
        }
    }

    /**
     * Takes a row without a label.
     *
     * @param row length d, each number in its own unit. Not modified.
     */
    public void follow(double[] row) {
        if (!filter.isEmpty()) {
            filter.get(0).step(row);
        }
    }

    private void know(int label) {
        double sum = 0;
        for (int k = 0; k < known.length; k++) {
            byState[k] = known[k] / PARTS == label ? filter.get(0).probability(k) + Double.MIN_NORMAL : 0;
            sum += byState[k];
        }
        if (sum > 0) {
            for (int k = 0; k < known.length; k++) {
                byState[k] /= sum;
            }
            filter.get(0).know(byState);
        }
    }

    /** The part of its label that a row belongs to. */
    private int place(double[] row, int label) {
        int first = label * PARTS;
        int best = -1;
        int free = first;
        double most = Double.NEGATIVE_INFINITY;
        boolean near = !Rows.complete(row);
        while (free < first + PARTS && rows[free] > 0) {
            int k = Arrays.binarySearch(known, free);
            if (k < 0) {
                return free;   // it is not a state yet: first let it become one
            }
            Gaussian gaussian = filter.get(0).model().emissions().get(k).components().get(0);
            double log = near ? 0 : gaussian.logDensity(row, away);
            near |= rows[free] < RIPE * d || 2 * (peaks[k] - log) < far;
            if (best < 0 || log > most) {
                most = log;
                best = free;
            }
            free++;
        }
        return best < 0 || !near && free < first + PARTS ? free : best;
    }

    /**
     * How likely every label is after this row, which is not taken.
     *
     * @param row length d, each number in its own unit. Not modified.
     * @param into probabilities, one for each label. Modified.
     */
    public void votes(double[] row, double[] into) {
        Arrays.fill(into, 0);
        if (filter.isEmpty()) {
            return;
        }
        filter.get(0).look(row, byState);
        for (int k = 0; k < known.length; k++) {
            into[known[k] / PARTS] += byState[k];
        }
    }

    /** Number of densities, each a state of the chain. */
    public int known() {
        return known.length;
    }

    private void grow() {
        int[] fresh = java.util.stream.IntStream.range(0, rows.length).filter(place -> rows[place] >= 2).toArray();
        if (fresh.length == 0) {
            return;
        }
        double[] floor = floor();
        double[] initial = new double[fresh.length];
        double[][] to = new double[fresh.length][fresh.length];
        List<Mixture> emissions = new ArrayList<>();
        double[] was = new double[rows.length];
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
        peaks = emissions.stream().mapToDouble(each -> each.components().get(0).logDensity(each.components().get(0).mean(), away))
                .toArray();
    }

    /** A millionth of the variance of all rows. */
    private double[] floor() {
        double[] floor = new double[d];
        for (int i = 0; i < d; i++) {
            double centre = 0;
            for (int label = 0; label < rows.length; label++) {
                centre += rows[label] / total * mean[label][i];
            }
            double variance = 0;
            for (int label = 0; label < rows.length; label++) {
                double off = mean[label][i] - centre;
                variance += (products[label][i * d + i] + rows[label] * off * off) / total;
            }
            floor[i] = FLOOR * Math.max(variance, 1e-12 * (1 + centre * centre));
        }
        return floor;
    }
}

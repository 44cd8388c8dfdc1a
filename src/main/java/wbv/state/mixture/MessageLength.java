package wbv.state.mixture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleConsumer;
import org.apache.commons.math3.random.RandomGenerator;

/**
 * A normal mixture and the number of its components by minimum message length: component-wise expectation and maximisation that
 * begins with too many components and annihilates those that the data do not support (M. A. T. Figueiredo and A. K. Jain,
 * IEEE Trans. PAMI 24 (2002) 381-396, equation 17 and figure 2).
 *
 * <p>Of all mixtures on the way from most to fewest components the one with the shortest message is kept:
 * L = N/2 Σ ln(n α_m) + k/2 ln n - ln p(Y) + Σ (½ ln(|V| / |C_m|) + d ln ln(1 / floor)), N free numbers a component, V the
 * covariance of all rows. Equation 15 has (N + 1)(1 - ln 12) / 2 for each component in place of the last sum. The authors' own
 * program leaves that out, as it is negative and so rewards splinters: few rows that happen to lie along a line. Two things
 * differ from that program, and both follow from what a message is:
 *
 * <ul><li>The last sum. The paper's prior of a component, that of Jeffreys, has no bounds, so where the component lies costs
 * nothing more if it is narrow. Here the mean lies anywhere within V, and the logarithms of the variances anywhere from the floor
 * to V: what those priors add is that sum. The covariance of the shortest message is then that over rows less one.
 * <li>After every convergence the component goes whose loss lengthens the message least. The paper takes the least weight,
 * which loses a small true component before one of two that share a large one.</ul>
 *
 * @param fewest components at the end of the search, &gt;= 1
 * @param most components to begin with
 * @param shape  of the covariances
 * @param tolerance relative change of L at which a number of components is done
 * @param floor  ratio of the least variance to that of the data, &lt; 1
 */
public record MessageLength(int fewest, int most, CovarianceShape shape, double tolerance, double floor) {

    /** Up to 25 components with full covariances. */
    public static final MessageLength USUAL = new MessageLength(1, 25, CovarianceShape.FULL, 1e-5, 1e-6);

    private static final int LONGEST = 500;
    private static final int STARTS = 3;

    public MessageLength {
        if (!(fewest >= 1 && most >= fewest)) {
            throw new IllegalArgumentException("components must be >= 1 at fewest, and as many at most: " + fewest + ", " + most);
        }
        if (!(tolerance > 0 && floor > 0 && floor < 1)) {
            throw new IllegalArgumentException("tolerance must be > 0, floor from 0 to 1: " + tolerance + ", " + floor);
        }
    }

    /** The same with other bounds for the number of components. */
    public MessageLength between(int few, int many) {
        return new MessageLength(few, many, shape, tolerance, floor);
    }

    /**
     * What was found.
     *
     * @param length of the message [nats]
     * @param sweeps through all components
     */
    public record Result(Mixture mixture, double length, int sweeps) {}

    /**
     * Fits.
     *
     * @param rows     n by d, each column in its own unit, finite, n &gt;= 1. Not modified.
     * @param random chooses where components begin
     * @param progress hears the share of components that are done
     * @throws IllegalArgumentException if there are no rows
     */
    public Result fit(double[][] rows, RandomGenerator random, DoubleConsumer progress) {
        // Where none may go, where components begin decides: the shortest message of several searches counts.
        int starts = most == fewest && most > 1 ? STARTS : 1;
        Result best = new Run(rows, random, share -> progress.accept(share / starts)).best();
        for (int start = 1; start < starts; start++) {
            int done = start;
            Result other = new Run(rows, random, share -> progress.accept((done + share) / starts)).best();
            best = other.length() < best.length() ? other : best;
        }
        return best;
    }

    /** One fit. */
    private final class Run {
        private final double[][] rows;
        private final int n;
        private final int d;
        private final double parameters;
        private final double[] least;
        /** What a component costs for where it lies and how wide it is, but for its own volume [nats]. */
        private final double place;
        private final DoubleConsumer progress;
        private final double[] weights;
        private final Gaussian[] components;
        private final double[][] logs;
        private final double[][] scaled;
        private final double[] reference;
        /** Density of a row in the mixture, over the reference. */
        private final double[] whole;
        private final double[] scratch;
        private int sweeps;

        Run(double[][] rows, RandomGenerator random, DoubleConsumer progress) {
            this.rows = rows;
            this.n = rows.length;
            this.least = Spread.floor(rows, floor);
            this.d = rows[0].length;
            this.progress = progress;
            this.parameters = d + (shape == CovarianceShape.FULL ? d * (d + 1) / 2.0 : d);
            int k = Math.min(most, Math.max(fewest, n));
            // Figueiredo and Jain begin with a tenth of the mean variance in every direction; by dimension, units do not matter.
            Spread all = Spread.of(shape, rows);
            place = Gaussian.of(shape, all.mean(), all.covariance(), least).logVolume() + d * Math.log(Math.log(1 / floor));
            double[] start = Arrays.stream(Spread.of(CovarianceShape.DIAGONAL, rows).covariance()).map(v -> v / 10).toArray();
            weights = new double[k];
            Arrays.fill(weights, 1.0 / k);
            components = new Gaussian[k];
            int[] order = draw(k, random);
            for (int m = 0; m < k; m++) {
                components[m] = Gaussian.of(shape, rows[order[m]], start, least);
            }
            logs = new double[k][n];
            scaled = new double[k][n];
            reference = new double[n];
            whole = new double[n];
            scratch = new double[d];
            for (int m = 0; m < k; m++) {
                evaluate(m);
            }
        }

        private int[] draw(int k, RandomGenerator random) {
            int[] order = new int[n];
            Arrays.setAll(order, i -> i);
            for (int i = 0; i < k; i++) {
                int j = i + random.nextInt(n - i);
                int kept = order[i];
                order[i] = order[j];
                order[j] = kept;
            }
            return order;
        }

        Result best() {
            Mixture best = null;
            double shortest = Double.POSITIVE_INFINITY;
            int begun = alive();
            while (true) {
                double length = converge();
                if (length < shortest || best == null) {
                    shortest = length;
                    best = mixture();
                }
                progress.accept(1 - (alive() - fewest) / (double) Math.max(1, begun - fewest));
                if (alive() <= fewest) {
                    return new Result(best, shortest, sweeps);
                }
                leave();
            }
        }

        /** Sweeps until the message no longer shortens. */
        private double converge() {
            double before = Double.POSITIVE_INFINITY;
            for (int sweep = 0; sweep < LONGEST; sweep++) {
                sweep();
                double length = length();
                if (Math.abs(before - length) <= tolerance * Math.abs(length)) {
                    return length;
                }
                before = length;
            }
            return before;
        }

        private void sweep() {
            sweeps++;
            rescale();
            for (int m = 0; m < weights.length; m++) {
                if (weights[m] == 0) {
                    continue;
                }
                Spread spread = new Spread(shape, components[m].mean());
                for (int i = 0; i < n; i++) {
                    double own = weights[m] * scaled[m][i];
                    if (own > 0) {
                        spread.add(Math.min(1, own / whole[i]), rows[i]);
                    }
                    whole[i] -= own;
                }
                boolean needed = alive() <= fewest;
                double support = needed ? Math.max(1, spread.weight()) : spread.weight() - parameters / 2;
                weights[m] = Math.max(0, support) / n;
                if (weights[m] > 0 && spread.weight() > 0) {
                    components[m] = Gaussian.of(shape, spread.mean(), unbiased(spread), least);
                    evaluate(m);
                }
                double sum = normalise();
                for (int i = 0; i < n; i++) {
                    whole[i] = Math.max(Double.MIN_NORMAL, Math.max(0, whole[i]) / sum + weights[m] * scaled[m][i]);
                }
            }
        }

        private static double[] unbiased(Spread spread) {
            double[] covariance = spread.covariance();
            double factor = spread.weight() / Math.max(1, spread.weight() - 1);
            for (int i = 0; i < covariance.length; i++) {
                covariance[i] *= factor;
            }
            return covariance;
        }

        private void evaluate(int m) {
            for (int i = 0; i < n; i++) {
                logs[m][i] = components[m].logDensity(rows[i], scratch);
                scaled[m][i] = Math.exp(Math.min(700, logs[m][i] - reference[i]));
            }
        }

        /** Densities relative to the greatest of their row, so that none under- or overflows. */
        private void rescale() {
            for (int i = 0; i < n; i++) {
                double greatest = Double.NEGATIVE_INFINITY;
                for (int m = 0; m < weights.length; m++) {
                    greatest = weights[m] > 0 ? Math.max(greatest, logs[m][i]) : greatest;
                }
                reference[i] = greatest;
                whole[i] = 0;
                for (int m = 0; m < weights.length; m++) {
                    scaled[m][i] = weights[m] > 0 ? Math.exp(logs[m][i] - greatest) : 0;
                    whole[i] += weights[m] * scaled[m][i];
                }
            }
        }

        private double length() {
            rescale();
            double likelihood = 0;
            for (int i = 0; i < n; i++) {
                likelihood += reference[i] + Math.log(whole[i]);
            }
            double sum = 0;
            for (int m = 0; m < weights.length; m++) {
                if (weights[m] > 0) {
                    sum += parameters / 2 * Math.log(n * weights[m]) + Math.log(n) / 2 + place - components[m].logVolume();
                }
            }
            return sum - likelihood;
        }

        /** Returns what the weights were over what they are. */
        private double normalise() {
            double sum = Arrays.stream(weights).sum();
            for (int m = 0; m < weights.length; m++) {
                weights[m] /= sum;
            }
            return sum;
        }

        private int alive() {
            return (int) Arrays.stream(weights).filter(weight -> weight > 0).count();
        }

        /** The component whose loss lengthens the message least goes. */
        private void leave() {
            double[] kept = weights.clone();
            int idle = -1;
            double shortest = Double.POSITIVE_INFINITY;
            for (int m = 0; m < kept.length; m++) {
                if (kept[m] > 0) {
                    weights[m] = 0;
                    normalise();
                    double length = length();
                    if (idle < 0 || length < shortest) {
                        idle = m;
                        shortest = length;
                    }
                    System.arraycopy(kept, 0, weights, 0, kept.length);
                }
            }
            weights[idle] = 0;
            normalise();
        }

        private Mixture mixture() {
            List<Gaussian> kept = new ArrayList<>();
            double[] shares = Arrays.stream(weights).filter(weight -> weight > 0).toArray();
            for (int m = 0; m < weights.length; m++) {
                if (weights[m] > 0) {
                    kept.add(components[m]);
                }
            }
            return new Mixture(shares, kept);
        }
    }
}

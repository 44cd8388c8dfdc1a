package wbv.state.mixture;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.DoubleConsumer;
import org.apache.commons.math3.distribution.BetaDistribution;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.signal.LogSum;

/**
 * A normal mixture with a Dirichlet process for its weights, by collapsed Gibbs sampling: cluster by cluster mean and covariance
 * are integrated out (R. M. Neal, J. Comp. Graph. Stat. 9 (2000) 249-265, algorithm 3), and the concentration α ~ Gamma(a, b) is
 * resampled (M. D. Escobar and M. West, J. Am. Stat. Assoc. 90 (1995) 577-588, section 6).
 *
 * <p>One instance is one chain. {@link #sweep} leaves the posterior of assignments and concentration as it is, so a chain of
 * sweeps samples it.
 */
public final class DirichletProcess {

    private final NormalWishart prior;
    private final double shape;
    private final double rate;
    private final RandomGenerator random;
    private final double[][] rows;
    private final int[] assigned;
    private final List<Cluster> clusters = new ArrayList<>();
    private final Cluster fresh;
    private double[] logs = new double[16];
    private double concentration;

    /**
     * A chain that begins with all rows in one cluster.
     *
     * @param rows n by d, each column in its own unit, finite, n &gt;= 1. Neither copied nor modified: a caller may change them between
     *             sweeps if he calls {@link #rebuild}.
     * @param a shape [1] and
     * @param b rate [1] of the concentration's gamma prior, &gt; 0
     */
    public DirichletProcess(double[][] rows, NormalWishart prior, double a, double b, RandomGenerator random) {
        if (rows.length == 0 || !(a > 0 && b > 0)) {
            throw new IllegalArgumentException("a Dirichlet process needs rows, and a, b > 0: " + rows.length + ", " + a + ", "
                    + b);
        }
        this.rows = rows;
        this.prior = prior;
        this.shape = a;
        this.rate = b;
        this.random = random;
        this.assigned = new int[rows.length];
        this.fresh = new Cluster(prior);
        this.concentration = a / b;
        rebuild();
    }

    /** Number of clusters now. */
    public int size() {
        return clusters.size();
    }

    /** α now [1]. */
    public double concentration() {
        return concentration;
    }

    /** The cluster of a row now. */
    public int assigned(int row) {
        return assigned[row];
    }

    /**
     * Sets the state of the chain.
     *
     * @param labels 0, 1, … without holes. Not modified, not kept.
     * @param alpha α [1], &gt; 0
     */
    public void set(int[] labels, double alpha) {
        System.arraycopy(labels, 0, assigned, 0, assigned.length);
        concentration = alpha;
        rebuild();
    }

    /** Gathers all clusters anew from the rows: after the rows have changed, and now and then against rounding. */
    public void rebuild() {
        int most = 0;
        for (int label : assigned) {
            most = Math.max(most, label);
        }
        clusters.clear();
        for (int k = 0; k <= most; k++) {
            clusters.add(new Cluster(prior));
        }
        for (int i = 0; i < rows.length; i++) {
            clusters.get(assigned[i]).add(rows[i]);
        }
    }

    /** Draws every row's cluster given all others, then the concentration. Thesis: Eq. 7-2. */
    public void sweep() {
        for (int i = 0; i < rows.length; i++) {
            leave(i);
            join(i, draw(rows[i]));
        }
        drawConcentration();
        rebuild();
    }

    private void leave(int row) {
        int k = assigned[row];
        Cluster cluster = clusters.get(k);
        if (cluster.rows() == 1) {
            int last = clusters.size() - 1;
            clusters.set(k, clusters.get(last));
            clusters.remove(last);
            for (int i = 0; i < assigned.length && k != last; i++) {
                assigned[i] = assigned[i] == last ? k : assigned[i];
            }
            assigned[row] = -1;
        } else {
            assigned[row] = -1;
            if (!cluster.remove(rows[row])) {
                cluster.clear();
                for (int i = 0; i < assigned.length; i++) {
                    if (assigned[i] == k) {
                        cluster.add(rows[i]);
                    }
                }
            }
        }
    }

    /** P(k) ∝ n_k t_k(x) for a cluster that is there, α t_0(x) for a new one. */
    private int draw(double[] x) {
        int k = clusters.size();
        if (logs.length < k + 1) {
            logs = new double[2 * k + 1];
        }
        for (int j = 0; j < k; j++) {
            logs[j] = Math.log(clusters.get(j).rows()) + clusters.get(j).logPredictive(x);
        }
        logs[k] = Math.log(concentration) + fresh.logPredictive(x);
        LogSum.share(logs, k + 1);
        double u = random.nextDouble();
        int chosen = 0;
        while (chosen < k && u >= logs[chosen]) {
            u -= logs[chosen];
            chosen++;
        }
        return chosen;
    }

    private void join(int row, int k) {
        if (k == clusters.size()) {
            clusters.add(new Cluster(prior));
        }
        clusters.get(k).add(rows[row]);
        assigned[row] = k;
    }

    /** Escobar and West: η ~ Beta(α + 1, n), then α from a mixture of two gamma distributions. */
    private void drawConcentration() {
        int n = rows.length;
        int k = clusters.size();
        double eta = new BetaDistribution(random, concentration + 1, n).sample();
        double left = rate - Math.log(Math.max(Double.MIN_NORMAL, eta));
        double odds = (shape + k - 1) / (n * left);
        boolean more = random.nextDouble() < odds / (1 + odds);
        concentration = Math.max(1e-12, NormalWishart.gamma(random, more ? shape + k : shape + k - 1, left));
    }

    /** ln of the joint probability of the rows and their clusters given α, up to a constant. */
    double logJoint() {
        double sum = clusters.size() * Math.log(concentration);
        for (int k = 0; k < clusters.size(); k++) {
            Cluster cluster = new Cluster(prior);
            for (int i = 0; i < rows.length; i++) {
                if (assigned[i] == k) {
                    sum += cluster.logPredictive(rows[i]) + (cluster.rows() > 0 ? Math.log(cluster.rows()) : 0);
                    cluster.add(rows[i]);
                }
            }
        }
        return sum;
    }

    /** The clusters now as a mixture, largest first; clusters of fewer rows than this are left out, but not the largest. */
    public Mixture mixture(CovarianceShape form, int fewest) {
        double[] floor = Spread.floor(rows, 1e-6);
        List<Cluster> kept = clusters.stream().sorted(Comparator.comparingInt(Cluster::rows).reversed()).toList();
        kept = kept.stream().filter(cluster -> cluster.rows() >= Math.min(fewest, clusters.stream().mapToInt(Cluster::rows).max()
                .orElseThrow())).toList();
        double all = kept.stream().mapToInt(Cluster::rows).sum();
        return new Mixture(kept.stream().mapToDouble(cluster -> cluster.rows() / all).toArray(),
                kept.stream().map(cluster -> cluster.gaussian(form, floor)).toList());
    }

    /**
     * The likeliest of the mixtures that a chain visits.
     *
     * @param rows n by d, each column in its own unit, finite. Not modified.
     * @param share of the rows' variances that a component is thought to have
     * @param sweeps of the chain; the first half is not looked at
     * @param fewest rows of a component that is kept
     * @param progress hears the share of sweeps done
     */
    public static Mixture fit(double[][] rows, double share, int sweeps, int fewest, CovarianceShape form, RandomGenerator random,
            DoubleConsumer progress) {
        DirichletProcess chain = new DirichletProcess(rows, NormalWishart.about(rows, share), 1, 1, random);
        Mixture best = chain.mixture(form, fewest);
        double likeliest = Double.NEGATIVE_INFINITY;
        for (int sweep = 0; sweep < sweeps; sweep++) {
            chain.sweep();
            double joint = sweep < sweeps / 2 ? Double.NEGATIVE_INFINITY : chain.logJoint();
            if (joint > likeliest) {
                likeliest = joint;
                best = chain.mixture(form, fewest);
            }
            progress.accept((sweep + 1.0) / sweeps);
        }
        return best;
    }
}

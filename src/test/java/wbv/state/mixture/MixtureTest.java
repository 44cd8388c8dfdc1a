package wbv.state.mixture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.distribution.MultivariateNormalDistribution;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Mixtures against closed forms, another library, and the conditions that their samplers must keep. */
class MixtureTest {

    @Test
    void densityIsThatOfCommonsMath() {
        double[] mean = {1, -2, 0.5};
        double[][] covariance = {{2, 0.3, -0.4}, {0.3, 1, 0.2}, {-0.4, 0.2, 0.7}};
        double[] flat = {2, 0.3, -0.4, 0.3, 1, 0.2, -0.4, 0.2, 0.7};
        MultivariateNormalDistribution other = new MultivariateNormalDistribution(mean, covariance);
        Gaussian gaussian = Gaussian.exact(CovarianceShape.FULL, mean, flat);
        RandomGenerator random = new Well19937c(1);
        double[] x = new double[3];
        for (int i = 0; i < 50; i++) {
            gaussian.sample(random, x);
            assertEquals(Math.log(other.density(x)), gaussian.logDensity(x, new double[3]), 1e-11);
        }
        assertThrows(IllegalArgumentException.class,
                () -> Gaussian.exact(CovarianceShape.FULL, new double[2], new double[] {1, 2, 2, 1}));
    }

    @Test
    void singularCovarianceIsLiftedToItsFloor() {
        double[] floor = {1e-4, 1e-4};
        Gaussian gaussian = Gaussian.of(CovarianceShape.FULL, new double[2], new double[] {1, 1, 1, 1}, floor);
        assertTrue(gaussian.covariance(0, 0) > 1 && gaussian.covariance(0, 0) < 1.001);
        assertTrue(Double.isFinite(gaussian.logDensity(new double[] {1, -1}, new double[2])));
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource(ClassicalMixtures.class)
    void shortestMessageHasTheRightNumberOfComponents(ClassicalMixtures mixture) {
        int right = 0;
        for (int seed = 0; seed < 3; seed++) {
            right += mixture.found(1000 + seed) == mixture.components() ? 1 : 0;
        }
        // wbv.state.MessageLengthProof counts a hundred.
        assertEquals(3, right, "of 3");
    }

    @Test
    void predictiveDensityIsTheRatioOfMarginalLikelihoods() {
        // One dimension: the marginal likelihood of normal rows under the conjugate prior has a closed form (a product of t's
        // is one
        // way to write it); here it is integrated over mean and variance by brute force instead.
        NormalWishart prior = new NormalWishart(new double[] {0.3}, 0.7, new double[] {2}, 4);
        double[] rows = {0.5, -1.2, 2.0};
        Cluster cluster = new Cluster(prior);
        cluster.add(new double[] {rows[0]});
        cluster.add(new double[] {9});
        cluster.add(new double[] {rows[1]});
        assertTrue(cluster.remove(new double[] {9}));
        double expected = Math.log(marginal(rows, 3) / marginal(rows, 2));
        assertEquals(expected, cluster.logPredictive(new double[] {rows[2]}), 1e-4);
    }

    /** ∫∫ Π N(x; μ, v) N(μ; 0.3, v / 0.7) IG(v; 2, 1) dμ dv; an inverse Wishart of Ψ 2, ν 4 is an inverse gamma of 2, 1. */
    private static double marginal(double[] rows, int count) {
        double sum = 0;
        double step = 0.01;
        for (double logV = -7; logV < 9; logV += step) {
            double v = Math.exp(logV);
            double inner = 0;
            double width = Math.sqrt(v) * 0.02;
            for (double mu = 0.3 - 10 * Math.sqrt(v); mu < 0.3 + 10 * Math.sqrt(v); mu += width) {
                double log = -0.7 * (mu - 0.3) * (mu - 0.3) / (2 * v) - 0.5 * Math.log(2 * Math.PI * v / 0.7);
                for (int i = 0; i < count; i++) {
                    log += -(rows[i] - mu) * (rows[i] - mu) / (2 * v) - 0.5 * Math.log(2 * Math.PI * v);
                }
                inner += Math.exp(log) * width;
            }
            sum += inner * Math.pow(v, -3) * Math.exp(-1 / v) * v * step;
        }
        return sum;
    }

    /**
     * J. Geweke, Getting it right, J. Am. Stat. Assoc. 99 (2004) 799-804: rows and parameters drawn forward from the prior, and a
     * chain that alternates the sampler with rows drawn anew given its state, must agree in everything.
     */
    @Tag("slow")
    @Test
    void gibbsSamplerGetsItRight() {
        NormalWishart prior = new NormalWishart(new double[] {0.5, -0.5}, 0.5, new double[] {6, 1, 1, 5}, 9);
        int n = 5;
        int draws = 25_000;
        RandomGenerator random = new Well19937c(11);
        double[][] forward = new double[draws][];
        double[][] chained = new double[draws][];
        for (int i = 0; i < draws; i++) {
            double alpha = NormalWishart.gamma(random, 1, 1);
            int[] labels = restaurant(n, alpha, random);
            double[][] rows = new double[n][2];
            fill(rows, labels, prior, random);
            forward[i] = statistics(rows, labels, alpha);
        }
        double[][] rows = new double[n][2];
        int[] labels = restaurant(n, 1, random);
        fill(rows, labels, prior, random);
        DirichletProcess chain = new DirichletProcess(rows, prior, 1, 1, random);
        chain.set(labels, 1);
        for (int i = 0; i < draws; i++) {
            chain.sweep();
            for (int j = 0; j < n; j++) {
                labels[j] = chain.assigned(j);
            }
            fill(rows, labels, prior, random);
            chain.rebuild();
            chained[i] = statistics(rows, labels, chain.concentration());
        }
        for (int s = 0; s < forward[0].length; s++) {
            double[] a = summary(forward, s);
            double[] b = summary(chained, s);
            double z = (a[0] - b[0]) / Math.sqrt(a[1] + b[1]);
            assertTrue(Math.abs(z) < 4, "statistic " + s + ": " + a[0] + " forward, " + b[0] + " chained, z " + z);
        }
    }

    private static int[] restaurant(int n, double alpha, RandomGenerator random) {
        int[] labels = new int[n];
        int[] counts = new int[n];
        int tables = 0;
        for (int i = 0; i < n; i++) {
            double u = random.nextDouble() * (i + alpha);
            int k = 0;
            while (k < tables && u >= counts[k]) {
                u -= counts[k];
                k++;
            }
            labels[i] = k;
            counts[k]++;
            tables = Math.max(tables, k + 1);
        }
        return labels;
    }

    private static void fill(double[][] rows, int[] labels, NormalWishart prior, RandomGenerator random) {
        Gaussian[] clusters = new Gaussian[rows.length];
        for (int i = 0; i < rows.length; i++) {
            if (clusters[labels[i]] == null) {
                clusters[labels[i]] = prior.sample(random);
            }
            clusters[labels[i]].sample(random, rows[i]);
        }
    }

    private static double[] statistics(double[][] rows, int[] labels, double alpha) {
        boolean[] used = new boolean[rows.length];
        int together = 0;
        for (int label : labels) {
            used[label] = true;
        }
        int clusters = 0;
        for (boolean each : used) {
            clusters += each ? 1 : 0;
        }
        for (int i = 1; i < labels.length; i++) {
            together += labels[i] == labels[0] ? 1 : 0;
        }
        double x = Math.tanh(rows[0][0]);
        double y = Math.tanh(rows[1][1]);
        double product = Math.tanh(rows[0][0] * rows[0][1]);
        double near = Math.tanh(Math.abs(rows[0][0] - rows[1][0]));
        return new double[] {clusters, together, Math.log(alpha), alpha / (1 + alpha), x, y, x * x, product, near};
    }

    /** Mean and its variance by the means of a hundred batches. */
    private static double[] summary(double[][] draws, int statistic) {
        int batches = 100;
        double[] means = new double[batches];
        for (int i = 0; i < draws.length; i++) {
            means[i * batches / draws.length] += draws[i][statistic] * batches / draws.length;
        }
        double mean = Arrays.stream(means).average().orElseThrow();
        double squares = Arrays.stream(means).map(m -> (m - mean) * (m - mean)).sum();
        return new double[] {mean, squares / (batches - 1) / batches};
    }

    @Test
    void dirichletProcessFindsThreeClustersFarApart() {
        double[][] rows = ClassicalMixtures.UEDA_NAKANO.rows(3);
        for (double[] row : rows) {
            row[1] *= 3;
        }
        Mixture mixture = DirichletProcess.fit(rows, 0.1, 60, 20, CovarianceShape.FULL, new Well19937c(4), share -> {});
        for (int m = 0; m < 3; m++) {
            Gaussian gaussian = mixture.components().get(m);
            assertEquals(1.0 / 3, mixture.weights()[m], 0.05);
            assertEquals(0, Math.min(Math.abs(gaussian.mean(1)), Math.abs(Math.abs(gaussian.mean(1)) - 6)), 0.5);
        }
        double[][] few = Arrays.copyOf(rows, 90);
        assertArrayEquals(DirichletProcess.fit(few, 0.1, 9, 3, CovarianceShape.FULL, new Well19937c(4), share -> {}).weights(),
                DirichletProcess.fit(few, 0.1, 9, 3, CovarianceShape.FULL, new Well19937c(4), share -> {}).weights(),
                "the same seed gives the same mixture");
    }

    @Test
    void weightsAndDimensionsMustFit() {
        Gaussian one = Gaussian.exact(CovarianceShape.FULL, new double[] {0}, new double[] {1});
        Gaussian two = Gaussian.exact(CovarianceShape.FULL, new double[2], new double[] {1, 0, 0, 1});
        assertThrows(IllegalArgumentException.class, () -> new Mixture(new double[] {0.5, 0.4}, List.of(one, one)));
        assertThrows(IllegalArgumentException.class, () -> new Mixture(new double[] {0.5, 0.5}, List.of(one, two)));
        assertThrows(IllegalArgumentException.class, () -> new MessageLength(3, 2, CovarianceShape.FULL, 1e-5, 1e-6));
    }
}

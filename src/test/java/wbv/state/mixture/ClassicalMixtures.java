package wbv.state.mixture;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.random.Well19937c;
import wbv.state.markov.HiddenMarkov;

/**
 * Test mixtures of Figueiredo and Jain's method. The first and the last are those of its authors' two demonstrations (N. Ueda and
 * R. Nakano 1998; G. McLachlan and D. Peel 2000, p. 218); the parameters of the second, with two components about one mean, are
 * assumed.
 */
enum ClassicalMixtures {
    UEDA_NAKANO(900, new double[] {1, 1, 1}, new double[][] {{0, 0}, {0, 2}, {0, -2}},
            new double[][] {{2, 0, 0, 0.2}, {2, 0, 0, 0.2}, {2, 0, 0, 0.2}}),
    OVERLAPPING(1000, new double[] {0.3, 0.3, 0.3, 0.1}, new double[][] {{-4, -4}, {-4, -4}, {2, 2}, {-1, -6}},
            new double[][] {{1, 0.5, 0.5, 1}, {6, -2, -2, 6}, {2, -1, -1, 2}, {0.125, 0, 0, 0.125}}),
    MCLACHLAN_PEEL(300, new double[] {200, 50, 50}, new double[][] {{0, 0, 0}, {-6, 3, 6}, {6, 6, 4}},
            new double[][] {{9, 0, 0, 0, 4, 0, 0, 0, 1}, {4, -3.2, -0.2, -3.2, 4, 0, -0.2, 0, 1},
                {4, 3.2, 2.8, 3.2, 4, 2.4, 2.8, 2.4, 2}});

    private final int samples;
    private final Mixture mixture;

    ClassicalMixtures(int samples, double[] weights, double[][] means, double[][] covariances) {
        this.samples = samples;
        double[] shares = weights.clone();
        HiddenMarkov.normalise(shares);
        List<Gaussian> components = new ArrayList<>();
        for (int m = 0; m < means.length; m++) {
            components.add(Gaussian.exact(CovarianceShape.FULL, means[m], covariances[m]));
        }
        mixture = new Mixture(shares, components);
    }

    int components() {
        return mixture.size();
    }

    double[][] rows(int seed) {
        Well19937c random = new Well19937c(seed);
        double[][] rows = new double[samples][mixture.dimensions()];
        for (double[] row : rows) {
            mixture.sample(random, row);
        }
        return rows;
    }

    /** The number of components found in a fresh sample. */
    int found(int seed) {
        return MessageLength.USUAL.fit(rows(seed), new Well19937c(seed), share -> {}).mixture().size();
    }
}

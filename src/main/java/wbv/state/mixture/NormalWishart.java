package wbv.state.mixture;

import java.io.Serializable;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.distribution.GammaDistribution;
import org.apache.commons.math3.random.RandomGenerator;

/**
 * A normal inverse Wishart distribution of a mean and a covariance: C ~ IW(Ψ, ν), μ ~ N(m, C / κ). Conjugate to normal rows.
 *
 * @param mean  m, length d, each number in its own unit. Not copied; do not change it.
 * @param strength κ, a number of rows, &gt; 0
 * @param scale Ψ, d by d, by rows, in products of those units. Not copied; do not change it.
 * @param freedom ν, number of degrees of freedom, &gt; d - 1
 */
public record NormalWishart(double[] mean, double strength, double[] scale, double freedom) implements Serializable {

    public NormalWishart {
        if (!(strength > 0 && freedom > mean.length - 1) || scale.length != mean.length * mean.length) {
            throw new IllegalArgumentException("strength must be > 0 and freedom > " + (mean.length - 1) + ": " + strength + ", "
                    + freedom);
        }
    }

    /**
     * A vague one for rows: their mean with the weight of a hundredth of a row, and covariances about this share of theirs,
     * with the weight of as few rows as a mean covariance needs.
     *
     * @param rows n by d, each column in its own unit. Not modified.
     * @param share of the rows' variances that a component is thought to have
     */
    public static NormalWishart about(double[][] rows, double share) {
        Spread spread = Spread.of(CovarianceShape.DIAGONAL, rows);
        double[] floor = Spread.floor(rows, 1e-9);
        double[] scale = spread.covariance();
        int d = floor.length;
        for (int i = 0; i < d; i++) {
            scale[i * d + i] = share * Math.max(floor[i], scale[i * d + i]);
        }
        return new NormalWishart(spread.mean(), 0.01, scale, d + 2.0);
    }

    /** Length d of the mean. */
    public int dimensions() {
        return mean.length;
    }

    /** A random mean and covariance. */
    public Gaussian sample(RandomGenerator random) {
        int d = mean.length;
        double[] floor = new double[d];
        java.util.Arrays.fill(floor, Double.MIN_NORMAL);
        // C⁻¹ = L⁻ᵀ B Bᵀ L⁻¹ with Ψ = L Lᵀ and Bartlett's B, so C = (L B⁻ᵀ)(L B⁻ᵀ)ᵀ.
        double[] factor = new double[d * (d + 1) / 2];
        if (!Cholesky.factor(scale, d, floor, factor)) {
            throw new IllegalArgumentException("the scale of a Wishart distribution must be positive definite");
        }
        double[] bartlett = new double[factor.length];
        for (int i = 0; i < d; i++) {
            for (int j = 0; j < i; j++) {
                bartlett[Cholesky.at(i, j)] = random.nextGaussian();
            }
            bartlett[Cholesky.at(i, i)] = Math.sqrt(new ChiSquaredDistribution(random, freedom - i).sample());
        }
        double[] inverse = Cholesky.inverse(bartlett, d);
        double[][] root = new double[d][d];
        for (int i = 0; i < d; i++) {
            for (int j = 0; j < d; j++) {
                for (int k = 0; k <= Math.min(i, j); k++) {
                    root[i][j] += factor[Cholesky.at(i, k)] * inverse[Cholesky.at(j, k)];
                }
            }
        }
        double[] covariance = new double[d * d];
        double[] centre = mean.clone();
        double[] white = new double[d];
        for (int j = 0; j < d; j++) {
            white[j] = random.nextGaussian() / Math.sqrt(strength);
        }
        for (int i = 0; i < d; i++) {
            for (int j = 0; j < d; j++) {
                centre[i] += root[i][j] * white[j];
                for (int k = 0; k < d; k++) {
                    covariance[i * d + j] += root[i][k] * root[j][k];
                }
            }
        }
        return Gaussian.of(CovarianceShape.FULL, centre, covariance, floor);
    }

    /**
     * A random number of the gamma distribution.
     *
     * @param rate one over the scale
     */
    static double gamma(RandomGenerator random, double shape, double rate) {
        return new GammaDistribution(random, shape, 1 / rate).sample();
    }
}

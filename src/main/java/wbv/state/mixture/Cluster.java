package wbv.state.mixture;

import org.apache.commons.math3.special.Gamma;

/**
 * The rows of one cluster under a normal inverse Wishart prior: what their mean and covariance are after them, kept by updates
 * of rank one, and how likely one more row is, with mean and covariance integrated out (a multivariate t).
 */
final class Cluster {

    private static final double LOG_PI = Math.log(Math.PI);

    private final NormalWishart prior;
    private final int d;
    private final double[] mean;
    private final double[] factor;
    private final double[] away;
    private int rows;
    private double constant;

    Cluster(NormalWishart prior) {
        this.prior = prior;
        this.d = prior.dimensions();
        this.mean = new double[d];
        this.factor = new double[d * (d + 1) / 2];
        this.away = new double[d];
        clear();
    }

    /** Leaves the prior alone. */
    void clear() {
        double[] floor = new double[d];
        java.util.Arrays.fill(floor, Double.MIN_NORMAL);
        System.arraycopy(prior.mean(), 0, mean, 0, d);
        if (!Cholesky.factor(prior.scale(), d, floor, factor)) {
            throw new IllegalArgumentException("the scale of a Wishart distribution must be positive definite");
        }
        rows = 0;
        prepare();
    }

    int rows() {
        return rows;
    }

    /** κ_{n+1} = κ_n + 1, m_{n+1} = (κ_n m_n + x) / κ_{n+1}, Ψ_{n+1} = Ψ_n + κ_n / κ_{n+1} (x - m_n)(x - m_n)ᵀ. */
    void add(double[] x) {
        double k = prior.strength() + rows;
        double root = Math.sqrt(k / (k + 1));
        for (int i = 0; i < d; i++) {
            double step = x[i] - mean[i];
            away[i] = root * step;
            mean[i] += step / (k + 1);
        }
        Cholesky.update(factor, away, d, 1);
        rows++;
        prepare();
    }

    /**
     * Takes a row away again.
     *
     * @return false if rounding has spoilt the covariance; then {@link #clear} and add anew
     */
    boolean remove(double[] x) {
        double k = prior.strength() + rows;
        double root = Math.sqrt(k / (k - 1));
        for (int i = 0; i < d; i++) {
            double step = x[i] - mean[i];
            away[i] = root * step;
            mean[i] -= step / (k - 1);
        }
        rows--;
        boolean whole = Cholesky.update(factor, away, d, -1);
        if (whole) {
            prepare();
        }
        return whole;
    }

    private void prepare() {
        double k = prior.strength() + rows;
        double t = prior.freedom() + rows - d + 1;
        double logDeterminant = 0;
        for (int i = 0; i < d; i++) {
            logDeterminant += Math.log(factor[Cholesky.at(i, i)]);
        }
        constant = Gamma.logGamma((t + d) / 2) - Gamma.logGamma(t / 2) - 0.5 * d * (LOG_PI + Math.log((k + 1) / k))
                - logDeterminant;
    }

    /** ln t(x; m_n, Ψ_n (κ_n + 1) / (κ_n (ν_n - d + 1)), ν_n - d + 1). */
    double logPredictive(double[] x) {
        double square = 0;
        for (int i = 0; i < d; i++) {
            double sum = x[i] - mean[i];
            for (int j = 0; j < i; j++) {
                sum -= factor[Cholesky.at(i, j)] * away[j];
            }
            away[i] = sum / factor[Cholesky.at(i, i)];
            square += away[i] * away[i];
        }
        double k = prior.strength() + rows;
        return constant - 0.5 * (prior.freedom() + rows + 1) * Math.log1p(square * k / (k + 1));
    }

    /** The mean and the mean covariance after the rows. */
    Gaussian gaussian(CovarianceShape shape, double[] floor) {
        double[] covariance = new double[d * d];
        double divisor = Math.max(1, prior.freedom() + rows - d - 1);
        for (int i = 0; i < d; i++) {
            for (int j = 0; j < d; j++) {
                for (int k = 0; k <= Math.min(i, j); k++) {
                    covariance[i * d + j] += factor[Cholesky.at(i, k)] * factor[Cholesky.at(j, k)] / divisor;
                }
            }
        }
        return Gaussian.of(shape, mean, covariance, floor);
    }
}

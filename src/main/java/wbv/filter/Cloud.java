package wbv.filter;

import java.io.Serializable;

/** Mean, covariance and its root of weighted points. */
final class Cloud implements Serializable {

    private static final long serialVersionUID = 1;
    /** Variance that a collapsed cloud is taken to have, as a share of its mean square and in itself. */
    private static final double LEAST = 1e-12;

    private final int n;
    private final double[][] covariance;
    private final double[][] root;
    private final double[] variance;

    Cloud(int n) {
        this.n = n;
        this.covariance = new double[n][n];
        this.root = new double[n][n];
        this.variance = new double[n];
    }

    /** @param mean the first n numbers are replaced */
    void meanOf(double[][] points, double[] weights, double[] mean) {
        for (int i = 0; i < n; i++) {
            mean[i] = 0;
        }
        for (int k = 0; k < points.length; k++) {
            double w = weights[k];
            for (int i = 0; i < n; i++) {
                mean[i] += w * points[k][i];
            }
        }
    }

    /**
     * Variances alone.
     *
     * @param walk added to those of the last numbers. Not modified.
     */
    void spreadOf(double[][] points, double[] weights, double[] mean, double[] walk) {
        for (int i = 0; i < n; i++) {
            double sum = 0;
            for (int k = 0; k < points.length; k++) {
                double e = points[k][i] - mean[i];
                sum += weights[k] * e * e;
            }
            variance[i] = sum + LEAST + (i < n - walk.length ? 0 : walk[i - n + walk.length]);
        }
    }

    void widen(int i, double by) {
        variance[i] += by;
    }

    /** The variance is known to be this. */
    void know(int i, double value) {
        variance[i] = value;
    }

    double variance(int i) {
        return variance[i];
    }

    void covarianceOf(double[][] points, double[] weights, double[] mean) {
        for (int i = 0; i < n; i++) {
            for (int j = 0; j <= i; j++) {
                double sum = 0;
                for (int k = 0; k < points.length; k++) {
                    sum += weights[k] * (points[k][i] - mean[i]) * (points[k][j] - mean[j]);
                }
                covariance[i][j] = sum;
                covariance[j][i] = sum;
            }
            covariance[i][i] += LEAST * (1 + mean[i] * mean[i]);
        }
    }

    double covariance(int i, int j) {
        return covariance[i][j];
    }

    /** Cholesky factor of the last covariance. */
    void factor() {
        for (int i = 0; i < n; i++) {
            for (int j = 0; j <= i; j++) {
                double sum = covariance[i][j];
                for (int k = 0; k < j; k++) {
                    sum -= root[i][k] * root[j][k];
                }
                root[i][j] = i == j ? Math.sqrt(Math.max(0, sum)) : root[j][j] > 0 ? sum / root[j][j] : 0;
            }
        }
    }

    /** Number i of the factor times a vector. */
    double rootTimes(int i, double[] normal) {
        double sum = 0;
        for (int k = 0; k <= i; k++) {
            sum += root[i][k] * normal[k];
        }
        return sum;
    }
}

package wbv.state.mixture;

import java.io.Serializable;
import java.util.Arrays;
import org.apache.commons.math3.random.RandomGenerator;

/** A normal density in d dimensions, ready to be evaluated: the covariance is factorised once, C = L Lᵀ, and L⁻¹ is kept. */
public final class Gaussian implements Serializable {

    private static final long serialVersionUID = 1;
    private static final double LOG_TWO_PI = Math.log(2 * Math.PI);

    private final CovarianceShape shape;
    private final double[] mean;
    private final double[] covariance;
    /** L⁻¹ by rows of the lower triangle, or one over the deviations. */
    private final double[] whitening;
    private final double[] factor;
    private final double logScale;

    private Gaussian(CovarianceShape shape, double[] mean, double[] covariance, double[] factor) {
        int d = mean.length;
        this.shape = shape;
        this.mean = mean;
        this.covariance = covariance;
        this.factor = factor;
        double logDeterminant = 0;
        if (shape == CovarianceShape.DIAGONAL) {
            whitening = new double[d];
            for (int i = 0; i < d; i++) {
                whitening[i] = 1 / factor[i];
                logDeterminant += Math.log(factor[i]);
            }
        } else {
            whitening = Cholesky.inverse(factor, d);
            for (int i = 0; i < d; i++) {
                logDeterminant += Math.log(factor[Cholesky.at(i, i)]);
            }
        }
        logScale = -0.5 * d * LOG_TWO_PI - logDeterminant;
    }

    /**
     * A density with a covariance that is lifted where it is too narrow: no variance falls below the floor, and a matrix that
     * is not positive definite gets the floor added to its diagonal until it is.
     *
     * @param mean length d, each number in its own unit. Copied.
     * @param covariance d by d, by rows, in products of those units, symmetric;
     * off its diagonal not looked at where the shape is diagonal. Copied.
     * @param floor least variance by dimension, in the square of its unit, &gt; 0. Not modified.
     * @throws IllegalArgumentException if a number is not finite or the sizes do not fit
     */
    public static Gaussian of(CovarianceShape shape, double[] mean, double[] covariance, double[] floor) {
        int d = mean.length;
        if (covariance.length != d * d || floor.length != d) {
            throw new IllegalArgumentException("covariance must be " + d + " by " + d + ": " + covariance.length + " values");
        }
        double[] c = new double[d * d];
        for (int i = 0; i < d; i++) {
            if (!Double.isFinite(mean[i]) || !(floor[i] > 0)) {
                throw new IllegalArgumentException("mean must be finite and floor > 0: " + mean[i] + ", " + floor[i]);
            }
            for (int j = 0; j < d; j++) {
                double value = covariance[i * d + j];
                if (!Double.isFinite(value)) {
                    throw new IllegalArgumentException("covariance must be finite: " + value);
                }
                c[i * d + j] = i == j ? Math.max(floor[i], value) : shape == CovarianceShape.DIAGONAL ? 0 : value;
            }
        }
        if (shape == CovarianceShape.DIAGONAL) {
            double[] deviation = new double[d];
            for (int i = 0; i < d; i++) {
                deviation[i] = Math.sqrt(c[i * d + i]);
            }
            return new Gaussian(shape, mean.clone(), c, deviation);
        }
        double[] factor = new double[d * (d + 1) / 2];
        double lift = 1;
        while (!Cholesky.factor(c, d, floor, factor)) {
            for (int i = 0; i < d; i++) {
                c[i * d + i] += lift * floor[i];
            }
            lift *= 2;
        }
        return new Gaussian(shape, mean.clone(), c, factor);
    }

    /**
     * A density with exactly this covariance.
     *
     * @param mean       length d, each number in its own unit. Not modified.
     * @param covariance d by d, by rows, in products of those units. Not modified.
     * @throws IllegalArgumentException if it is not positive definite
     */
    public static Gaussian exact(CovarianceShape shape, double[] mean, double[] covariance) {
        double[] floor = new double[mean.length];
        Arrays.fill(floor, Double.MIN_NORMAL);
        double[] factor = new double[mean.length * (mean.length + 1) / 2];
        if (covariance.length != mean.length * mean.length
                || shape == CovarianceShape.FULL && !Cholesky.factor(covariance, mean.length, floor, factor)) {
            throw new IllegalArgumentException("a covariance must be positive definite, " + mean.length + " by " + mean.length);
        }
        return of(shape, mean, covariance, floor);
    }

    /** All that a density is evaluated by: the mean, L⁻¹ by rows or one over the deviations, and the logarithm of the scale. */
    public double[] numbers() {
        double[] all = Arrays.copyOf(mean, mean.length + whitening.length + 1);
        System.arraycopy(whitening, 0, all, mean.length, whitening.length);
        all[all.length - 1] = logScale;
        return all;
    }

    /** ½ ln |C|. */
    double logVolume() {
        return -logScale - 0.5 * mean.length * LOG_TWO_PI;
    }

    /** d. */
    public int dimensions() {
        return mean.length;
    }

    /** What of the covariance may differ from 0. */
    public CovarianceShape shape() {
        return shape;
    }

    /** Mean of a dimension, in its unit. */
    public double mean(int i) {
        return mean[i];
    }

    /** Covariance of two dimensions, in the product of their units. */
    public double covariance(int i, int j) {
        return covariance[i * mean.length + j];
    }

    /** A copy of the mean, length d, each number in its own unit. */
    public double[] mean() {
        return mean.clone();
    }

    /** A copy of the covariance, by rows, in products of the means' units. */
    public double[] covariance() {
        return covariance.clone();
    }

    /**
     * ln p(x) [nat].
     *
     * @param x length d, in the means' units. Not modified.
     * @param scratch room of no unit, at least d long. Modified.
     */
    public double logDensity(double[] x, double[] scratch) {
        return logDensity(x, scratch, 0);
    }

    /**
     * The same.
     *
     * @param x likewise. Not modified.
     * @param scratch likewise. Modified.
     * @param from first of the d places of the scratch
     */
    public double logDensity(double[] x, double[] scratch, int from) {
        int d = mean.length;
        double even = 0;
        double odd = 0;
        if (shape == CovarianceShape.DIAGONAL) {
            int i = 0;
            for (; i + 1 < d; i += 2) {
                double a = (x[i] - mean[i]) * whitening[i];
                double b = (x[i + 1] - mean[i + 1]) * whitening[i + 1];
                even += a * a;
                odd += b * b;
            }
            if (i < d) {
                double a = (x[i] - mean[i]) * whitening[i];
                even += a * a;
            }
            return logScale - 0.5 * (even + odd);
        }
        for (int i = 0; i < d; i++) {
            scratch[from + i] = x[i] - mean[i];
        }
        int at = 0;
        for (int i = 0; i < d; i++) {
            double a = 0;
            double b = 0;
            int j = 0;
            for (; j + 1 <= i; j += 2) {
                a += whitening[at + j] * scratch[from + j];
                b += whitening[at + j + 1] * scratch[from + j + 1];
            }
            if (j <= i) {
                a += whitening[at + j] * scratch[from + j];
            }
            at += i + 1;
            even += (a + b) * (a + b);
        }
        return logScale - 0.5 * even;
    }

    /**
     * A random point.
     *
     * @param into length d, in the means' units. Modified.
     */
    public void sample(RandomGenerator random, double[] into) {
        int d = mean.length;
        double[] white = new double[d];
        for (int i = 0; i < d; i++) {
            white[i] = random.nextGaussian();
        }
        for (int i = 0; i < d; i++) {
            into[i] = mean[i];
            if (shape == CovarianceShape.DIAGONAL) {
                into[i] += factor[i] * white[i];
            } else {
                for (int j = 0; j <= i; j++) {
                    into[i] += factor[Cholesky.at(i, j)] * white[j];
                }
            }
        }
    }
}

package wbv.state.mixture;

/**
 * Mean and covariance of weighted rows, gathered one by one about a point near them so that little is lost to rounding.
 */
public final class Spread {

    private final int d;
    private final double[] about;
    private final double[] sum;
    private final double[] products;
    private final double[] away;
    private final CovarianceShape shape;
    private double weight;

    /**
     * No rows yet.
     *
     * @param about a point near the rows, length d, each number in its own unit. Copied, not modified.
     */
    public Spread(CovarianceShape shape, double[] about) {
        this.shape = shape;
        this.d = about.length;
        this.about = about.clone();
        this.sum = new double[d];
        this.away = new double[d];
        this.products = new double[d * d];
    }

    /**
     * Adds a row.
     *
     * @param w its weight [1]
     * @param x length d, each number in its own unit. Not modified.
     */
    public void add(double w, double[] x) {
        weight += w;
        for (int i = 0; i < d; i++) {
            away[i] = x[i] - about[i];
            sum[i] += w * away[i];
        }
        for (int i = 0; i < d; i++) {
            double a = w * away[i];
            int row = i * d;
            if (shape == CovarianceShape.DIAGONAL) {
                products[row + i] += a * away[i];
            } else {
                for (int j = 0; j <= i; j++) {
                    products[row + j] += a * away[j];
                }
            }
        }
    }

    /** Adds what another gathered about the same point. */
    public void add(Spread other) {
        weight += other.weight;
        for (int i = 0; i < d; i++) {
            sum[i] += other.sum[i];
        }
        for (int i = 0; i < products.length; i++) {
            products[i] += other.products[i];
        }
    }

    /** Sum of the weights [1]. */
    public double weight() {
        return weight;
    }

    /** Weighted mean, length d, each number in its own unit. A new array. */
    public double[] mean() {
        double[] mean = new double[d];
        for (int i = 0; i < d; i++) {
            mean[i] = about[i] + sum[i] / weight;
        }
        return mean;
    }

    /** The covariance with the sum of weights as divisor, d by d, in products of the rows' units. */
    public double[] covariance() {
        double[] covariance = new double[d * d];
        for (int i = 0; i < d; i++) {
            for (int j = shape == CovarianceShape.DIAGONAL ? i : 0; j <= i; j++) {
                double value = products[i * d + j] / weight - sum[i] / weight * sum[j] / weight;
                covariance[i * d + j] = value;
                covariance[j * d + i] = value;
            }
        }
        return covariance;
    }

    /**
     * Of rows with equal weights.
     *
     * @throws IllegalArgumentException if there are none
     */
    static Spread of(CovarianceShape shape, double[][] rows) {
        if (rows.length == 0) {
            throw new IllegalArgumentException("mean and covariance need at least one row");
        }
        Spread spread = new Spread(shape, rows[0]);
        for (double[] row : rows) {
            spread.add(1, row);
        }
        return spread;
    }

    /**
     * Least variances for densities of these rows, by dimension, in the squares of their units: a share of the variance, and something
     * above zero where there is none.
     *
     * @param rows n by d, each column in its own unit. Not modified.
     */
    public static double[] floor(double[][] rows, double share) {
        Spread spread = of(CovarianceShape.DIAGONAL, rows);
        double[] covariance = spread.covariance();
        double[] mean = spread.mean();
        double[] floor = new double[mean.length];
        for (int i = 0; i < floor.length; i++) {
            double least = 1e-12 * Math.max(1e-6, mean[i] * mean[i]);
            floor[i] = Math.max(share * covariance[i * floor.length + i], least);
        }
        return floor;
    }
}

package wbv.filter;

import java.util.Arrays;
import wbv.filter.model.BodyModel;
import wbv.filter.model.Spec;

/**
 * Moments of the unscented Kalman filter (Julier and Uhlmann 1997) with κ = 0: the 2n points {@code ξ ± √n L e_i}, {@code P =
 * L Lᵀ}, weigh the same and the centre nothing, so that no covariance can become negative (the cubature rule of Arasaratnam
 * and Haykin 2009). L starts at the parameters: all but a few points share the mean's, and with it one step.
 */
final class Unscented implements Moments {

    private static final long serialVersionUID = 1;
    /** A covariance that rounding made indefinite is lifted by this share of its diagonal before its root is taken. */
    private static final double LIFT = 1e-9;
    /** Points are kept this far outside the bounds of a body at most (ln). */
    private static final double OUTSIDE = 1.5;

    private final BodyModel model;
    private final double decay;
    private final int n;
    private final int[] order;
    private final double[][] points;
    private final double[] outputs;
    private final double[][] root;
    private final double[] mean;
    private final double[] crossed;
    private double variance;

    /**
     * @param model one that nobody else sets; slopes are not asked for
     * @param decay of the offset over one sample
     */
    Unscented(BodyModel model, double decay) {
        this.model = model;
        this.decay = decay;
        this.n = model.size();
        this.order = new int[n];
        int states = model.states();
        for (int i = 0; i < n; i++) {
            order[i] = i < model.parameters() ? states + i : i < n - 1 ? i - model.parameters() : n - 1;
        }
        this.points = new double[2 * n][n];
        this.outputs = new double[2 * n];
        this.root = new double[n][n];
        this.mean = new double[n];
        this.crossed = new double[n];
    }

    @Override
    public void advance(double[] c, double[] forced, double[] xi, double[] p) {
        spread(xi, p);
        // points along motion and offset have the parameters of the mean
        model.set(xi);
        for (int i = 2 * model.parameters(); i < 2 * n; i++) {
            move(points[i], c);
        }
        for (int i = 0; i < 2 * model.parameters(); i++) {
            model.set(points[i]);
            move(points[i], c);
        }
        Arrays.fill(mean, 0);
        for (double[] point : points) {
            for (int k = 0; k < n; k++) {
                mean[k] += point[k] / (2 * n);
            }
        }
        for (int r = 0; r < n; r++) {
            for (int k = 0; k <= r; k++) {
                double sum = 0;
                for (double[] point : points) {
                    sum += (point[r] - mean[r]) * (point[k] - mean[k]);
                }
                p[r * n + k] = sum / (2 * n);
                p[k * n + r] = sum / (2 * n);
            }
        }
        // parameters do not move: no rounding either
        System.arraycopy(mean, 0, xi, 0, model.states());
        xi[n - 1] = mean[n - 1];
    }

    private void move(double[] point, double[] c) {
        model.advance(c, c.length, point);
        point[n - 1] *= decay;
    }

    @Override
    public double measure(double[] xi, double[] p, double[] cross) {
        spread(xi, p);
        double sum = 0;
        for (int i = 0; i < 2 * n; i++) {
            model.setOutput(points[i]);
            outputs[i] = model.output(points[i]) + points[i][n - 1];
            sum += outputs[i];
        }
        double foreseen = sum / (2 * n);
        variance = 0;
        Arrays.fill(cross, 0);
        for (int i = 0; i < 2 * n; i++) {
            double e = outputs[i] - foreseen;
            variance += e * e / (2 * n);
            for (int k = 0; k < n; k++) {
                cross[k] += e * (points[i][k] - xi[k]) / (2 * n);
            }
        }
        System.arraycopy(cross, 0, crossed, 0, n);
        return foreseen;
    }

    @Override
    public double variance() {
        return variance;
    }

    /** P = P - K P_yx - P_xy Kᵀ + K (P_yy + R) Kᵀ. */
    @Override
    public void reduce(double[] gain, double r, double[] p) {
        double s = variance + r;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j <= i; j++) {
                p[i * n + j] += s * gain[i] * gain[j] - gain[i] * crossed[j] - crossed[i] * gain[j];
            }
        }
        Linearised.mirror(p, n);
    }

    /** The points of a mean and a covariance. */
    private void spread(double[] xi, double[] p) {
        factor(p);
        double reach = Math.sqrt(n);
        for (int i = 0; i < n; i++) {
            double[] plus = points[2 * i];
            double[] minus = points[2 * i + 1];
            for (int k = 0; k < n; k++) {
                double step = reach * root[k][i];
                plus[order[k]] = xi[order[k]] + step;
                minus[order[k]] = xi[order[k]] - step;
            }
            if (i < model.parameters()) {
                confine(plus);
                confine(minus);
            }
        }
    }

    /** A point far from every body would only overflow. */
    private void confine(double[] point) {
        for (int m = 0; m < model.modes(); m++) {
            int i = model.states() + 2 * m;
            point[i] = clamp(point[i], 2 * Math.PI * Spec.LEAST_FREQUENCY, 2 * Math.PI * Spec.MOST_FREQUENCY);
            point[i + 1] = clamp(point[i + 1], Spec.LEAST_DAMPING, Spec.MOST_DAMPING);
        }
    }

    private static double clamp(double log, double least, double most) {
        return Math.max(Math.log(least) - OUTSIDE, Math.min(Math.log(most) + OUTSIDE, log));
    }

    /** Cholesky factor of P in this order. */
    private void factor(double[] p) {
        for (int i = 0; i < n; i++) {
            for (int j = 0; j <= i; j++) {
                double sum = p[order[i] * n + order[j]];
                for (int k = 0; k < j; k++) {
                    sum -= root[i][k] * root[j][k];
                }
                if (i == j) {
                    root[i][i] = Math.sqrt(Math.max(sum, LIFT * p[order[i] * (n + 1)]));
                } else {
                    root[i][j] = root[j][j] > 0 ? sum / root[j][j] : 0;
                }
            }
        }
    }
}

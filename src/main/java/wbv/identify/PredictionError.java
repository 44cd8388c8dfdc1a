package wbv.identify;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;

/**
 * ARMAX in one go: the coefficients and the initial state with the least squared one-step prediction error, by Levenberg's and
 * Marquardt's method from a start of two linear regressions (Hannan and Rissanen 1982). Gradients are those of Ljung, System
 * Identification, 1999, (10.53): regressors filtered by 1/C. C keeps its roots inside the unit circle.
 */
public final class PredictionError {

    private static final int MOST_ITERATIONS = 60;
    private static final double SMALL_STEP = 1e-10;
    private static final double MOST_DAMPING = 1e8;
    private static final double EDGE = 0.999;

    private final Orders orders;

    /** For models of these orders. */
    public PredictionError(Orders orders) {
        this.orders = orders;
    }

    /** Fewest samples from which {@link #fit} makes a model with this many inputs. */
    public int fewest(int inputs) {
        return 3 * (orders.coefficients(inputs) + orders.memory()) + longOrder(inputs);
    }

    /**
     * Fits.
     *
     * @throws IllegalArgumentException if there are too few samples
     */
    public ArmaxFit fit(Samples samples) {
        if (samples.length() < fewest(samples.inputs())) {
            throw new IllegalArgumentException("ARMAX of these orders needs at least " + fewest(samples.inputs()) + " samples: "
                    + samples.length());
        }
        return new Run(samples).fit();
    }

    private int longOrder(int inputs) {
        return Math.max(orders.memory() + 4, 2 * orders.memory()) + inputs;
    }

    /** One fit. The unknowns are a, b of each input, c, x0. */
    private final class Run {
        private final Samples samples;
        private final int na = orders.na();
        private final int nb = orders.nb();
        private final int nc = orders.nc();
        private final int m;
        private final int n = orders.memory();
        private final int coefficients;
        private final int unknowns;
        private final double[][] past;
        private final double[] row;
        private final double[] work = new double[nc];
        private final LeastSquares normal;

        Run(Samples samples) {
            this.samples = samples;
            this.m = samples.inputs();
            this.coefficients = orders.coefficients(m);
            this.unknowns = coefficients + n;
            this.past = new double[Math.max(1, nc)][unknowns];
            this.row = new double[unknowns];
            this.normal = new LeastSquares(unknowns);
        }

        ArmaxFit fit() {
            double[] theta = start();
            double[] errors = new double[samples.length()];
            double loss = errors(theta, errors);
            double damping = 1e-3;
            boolean converged = false;
            int iteration = 0;
            while (iteration < MOST_ITERATIONS && !converged && damping < MOST_DAMPING) {
                iteration++;
                gather(theta, errors, BatchScatter.Sink.NONE);
                boolean better = false;
                while (!better && damping < MOST_DAMPING) {
                    double[] step = normal.solve(damping);
                    double[] trial = theta.clone();
                    for (int i = 0; i < unknowns; i++) {
                        trial[i] += step[i];
                    }
                    double[] trialErrors = new double[errors.length];
                    double trialLoss = stable(trial) ? errors(trial, trialErrors) : Double.POSITIVE_INFINITY;
                    better = trialLoss < loss;
                    // Gains of this size lie below the accuracy of the sum itself.
                    converged = Math.abs(loss - trialLoss) <= SMALL_STEP * loss;
                    if (better) {
                        theta = trial;
                        errors = trialErrors;
                        loss = trialLoss;
                        damping = Math.max(1e-12, damping / 10);
                    } else if (converged) {
                        break;
                    } else {
                        damping *= 10;
                    }
                }
            }
            return result(theta, errors, loss, iteration, converged);
        }

        private ArmaxFit result(double[] theta, double[] errors, double loss, int iterations, boolean converged) {
            double variance = loss / Math.max(1, samples.length() - unknowns);
            BatchScatter scatter = new BatchScatter(unknowns, samples.length());
            gather(theta, errors, scatter::add);
            DMatrixRMaj inverse = normal.inverse();
            double[] deviations = new double[coefficients];
            for (int i = 0; i < coefficients; i++) {
                deviations[i] = Math.sqrt(variance * inverse.get(i, i));
            }
            return new ArmaxFit(model(theta, variance), Arrays.copyOfRange(theta, coefficients, unknowns), deviations,
                    scatter.covariance(inverse, na), samples.length(), iterations, converged);
        }

        private Armax model(double[] theta, double variance) {
            double[][] b = new double[m][];
            for (int i = 0; i < m; i++) {
                b[i] = Arrays.copyOfRange(theta, na + i * nb, na + (i + 1) * nb);
            }
            return new Armax(samples.rate(), Arrays.copyOf(theta, na), b, orders.delay(),
                    Arrays.copyOfRange(theta, na + m * nb, coefficients), variance);
        }

        private boolean stable(double[] theta) {
            return Polynomial.inside(Arrays.copyOfRange(theta, na + m * nb, coefficients), EDGE, work);
        }

        /** A long ARX for the errors, then a regression on outputs, inputs and those errors. */
        private double[] start() {
            double[] errors = longErrors();
            int from = longOrder(m) + Math.max(nc, 1);
            LeastSquares regression = new LeastSquares(coefficients);
            double[] phi = new double[coefficients];
            for (int k = from; k < samples.length(); k++) {
                regressors(k, errors, phi);
                regression.add(phi, samples.y()[k]);
            }
            double[] theta = Arrays.copyOf(regression.solve(0), unknowns);
            double shrink = 1;
            while (!stable(theta)) {
                shrink *= 0.9;
                double power = 1;
                for (int i = 0; i < nc; i++) {
                    power *= shrink;
                    theta[na + m * nb + i] *= power;
                }
            }
            return theta;
        }

        private double[] longErrors() {
            int order = longOrder(m);
            LeastSquares regression = new LeastSquares(order * (1 + m) + m);
            double[] phi = new double[order * (1 + m) + m];
            double[] errors = new double[samples.length()];
            if (nc == 0) {
                return errors;
            }
            for (int k = order; k < samples.length(); k++) {
                longRegressors(k, order, phi);
                regression.add(phi, samples.y()[k]);
            }
            double[] theta = regression.solve(0);
            for (int k = order; k < samples.length(); k++) {
                longRegressors(k, order, phi);
                double error = samples.y()[k];
                for (int i = 0; i < phi.length; i++) {
                    error -= theta[i] * phi[i];
                }
                errors[k] = error;
            }
            return errors;
        }

        private void longRegressors(int k, int order, double[] phi) {
            int at = 0;
            for (int i = 1; i <= order; i++) {
                phi[at++] = -samples.y()[k - i];
            }
            for (double[] u : samples.u()) {
                for (int i = 0; i <= order; i++) {
                    phi[at++] = u[k - i];
                }
            }
        }

        /** What the output is linear in, given the errors; before the first sample all is 0, which x0 makes good. */
        private void regressors(int k, double[] errors, double[] phi) {
            int at = 0;
            for (int i = 1; i <= na; i++) {
                phi[at++] = k >= i ? -samples.y()[k - i] : 0;
            }
            for (double[] u : samples.u()) {
                for (int j = 0; j < nb; j++) {
                    int lag = k - j - orders.delay();
                    phi[at++] = lag >= 0 ? u[lag] : 0;
                }
            }
            for (int i = 1; i <= nc; i++) {
                phi[at++] = k >= i ? errors[k - i] : 0;
            }
        }

        /** Prediction errors into the array; the sum of their squares. */
        private double errors(double[] theta, double[] into) {
            double loss = 0;
            double[] y = samples.y();
            for (int k = 0; k < y.length; k++) {
                double foreseen = k < n ? theta[coefficients + k] : 0;
                for (int i = 0; i < na && i < k; i++) {
                    foreseen -= theta[i] * y[k - 1 - i];
                }
                for (int i = 0; i < m; i++) {
                    double[] u = samples.u()[i];
                    int first = na + i * nb;
                    for (int j = 0; j < nb && j + orders.delay() <= k; j++) {
                        foreseen += theta[first + j] * u[k - j - orders.delay()];
                    }
                }
                int first = na + m * nb;
                for (int i = 0; i < nc && i < k; i++) {
                    foreseen += theta[first + i] * into[k - 1 - i];
                }
                into[k] = y[k] - foreseen;
                loss += into[k] * into[k];
            }
            return Double.isFinite(loss) ? loss : Double.POSITIVE_INFINITY;
        }

        /** Normal equations of the linearised problem: every regressor, and the pulse of every initial state, over C. */
        private void gather(double[] theta, double[] errors, BatchScatter.Sink sink) {
            normal.clear();
            for (double[] psi : past) {
                Arrays.fill(psi, 0);
            }
            int firstC = na + m * nb;
            for (int k = 0; k < samples.length(); k++) {
                regressors(k, errors, row);
                for (int j = 0; j < n; j++) {
                    row[coefficients + j] = k == j ? 1 : 0;
                }
                for (int i = 0; i < nc; i++) {
                    double c = theta[firstC + i];
                    double[] before = past[Math.floorMod(k - 1 - i, nc)];
                    for (int j = 0; j < unknowns; j++) {
                        row[j] -= c * before[j];
                    }
                }
                if (nc > 0) {
                    System.arraycopy(row, 0, past[k % nc], 0, unknowns);
                }
                normal.add(row, errors[k]);
                sink.add(k, row, errors[k]);
            }
        }
    }
}

package wbv.identify;

import java.util.Arrays;
import org.ejml.data.Complex_F64;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * The simplified refined instrumental variable method for models in continuous time, SRIVC (Young and Jakeman 1980; Young,
 * Recursive Estimation and Time-Series Analysis, 2011, chapter 8): signals and their derivatives filtered by the last A(s), and
 * as instruments the output that the last model simulates, which noise of the output cannot bias. The initial state is estimated
 * with the rest.
 */
public final class RefinedInstruments {

    private static final int MOST_ITERATIONS = 100;
    private static final double SMALL_STEP = 1e-9;

    private final int poles;
    private final int zeros;
    private final double centre;

    /**
     * For models of these orders.
     *
     * @param poles  order of A, &gt;= 1
     * @param zeros  order of every numerator, 0 to {@code poles}
     * @param centre pulsation about which the system is active [rad/s], &gt; 0: scales time and filters the start
     */
    public RefinedInstruments(int poles, int zeros, double centre) {
        if (poles < 1 || zeros < 0 || zeros > poles) {
            throw new IllegalArgumentException("orders must be poles >= 1, zeros 0 to poles: " + poles + ", " + zeros);
        }
        if (!(centre > 0)) {
            throw new IllegalArgumentException("central pulsation must be > 0 rad/s: " + centre);
        }
        this.poles = poles;
        this.zeros = zeros;
        this.centre = centre;
    }

    /**
     * Fits.
     *
     * @throws IllegalArgumentException if there are too few samples
     */
    public TransferFit fit(Samples samples) {
        int fewest = 4 * (2 * poles + samples.inputs() * (zeros + 1));
        if (samples.length() < fewest) {
            throw new IllegalArgumentException("instruments of these orders need at least " + fewest
                    + " samples: " + samples.length());
        }
        return new Run(samples).fit();
    }

    /** One fit, in time times {@link #centre}. The unknowns are a, b of each input, T, each highest power first. */
    private final class Run {
        private final Samples samples;
        private final double step;
        private final int m;
        private final int nb = zeros + 1;
        private final int unknowns;

        Run(Samples samples) {
            this.samples = samples;
            this.step = centre / samples.rate();
            this.m = samples.inputs();
            this.unknowns = 2 * poles + m * nb;
        }

        TransferFit fit() {
            double[] a = new double[poles];
            double binomial = 1;
            for (int i = 0; i < poles; i++) {
                binomial *= (poles - i) / (i + 1.0);
                a[i] = binomial; // (s + 1)^n
            }
            double[] theta = solve(a, samples.y());
            boolean converged = false;
            int iteration = 0;
            while (iteration < MOST_ITERATIONS && !converged) {
                iteration++;
                double[] stable = stable(Arrays.copyOf(theta, poles));
                System.arraycopy(stable, 0, theta, 0, poles);
                double[] next = solve(stable, model(theta, 1).simulate(samples.u(), 1 / step, initial(theta)));
                double change = 0;
                double size = 0;
                for (int i = 0; i < poles; i++) {
                    change = Math.max(change, Math.abs(next[i] - theta[i]));
                    size = Math.max(size, Math.abs(next[i]));
                }
                converged = change <= SMALL_STEP * size;
                theta = next;
            }
            return result(theta, iteration, converged);
        }

        private TransferFit result(double[] theta, int iterations, boolean converged) {
            double[] stable = stable(Arrays.copyOf(theta, poles));
            System.arraycopy(stable, 0, theta, 0, poles);
            double[] y = model(theta, 1).simulate(samples.u(), 1 / step, initial(theta));
            double squares = 0;
            for (int t = 0; t < y.length; t++) {
                squares += (samples.y()[t] - y[t]) * (samples.y()[t] - y[t]);
            }
            double variance = squares / Math.max(1, y.length - unknowns);
            BatchScatter scatter = new BatchScatter(unknowns, y.length);
            DMatrixRMaj inverse = information(stable, y, scatter);
            double[] scales = scales(centre);
            double[] deviations = new double[poles + m * nb];
            double[] initial = new double[poles];
            for (int i = 0; i < unknowns; i++) {
                if (i < deviations.length) {
                    deviations[i] = Math.sqrt(variance * inverse.get(i, i)) * scales[i];
                } else {
                    initial[i - deviations.length] = theta[i] * scales[i];
                }
            }
            double[][] covariance = scatter.covariance(inverse, poles);
            for (int i = 0; i < poles; i++) {
                for (int j = 0; j < poles; j++) {
                    covariance[i][j] *= scales[i] * scales[j];
                }
            }
            return new TransferFit(model(theta, centre), initial, deviations, covariance, variance, iterations, converged);
        }

        /** Factors from scaled time to seconds. T gains one power more: a pulse has the unit of 1/time. */
        private double[] scales(double unit) {
            double[] scales = new double[unknowns];
            for (int i = 0; i < poles; i++) {
                scales[i] = Math.pow(unit, i + 1);
                scales[poles + m * nb + i] = Math.pow(unit, i);
            }
            for (int i = 0; i < m * nb; i++) {
                scales[poles + i] = Math.pow(unit, poles - zeros + i % nb);
            }
            return scales;
        }

        private TransferModel model(double[] theta, double unit) {
            double[] scales = scales(unit);
            double[] a = new double[poles];
            Arrays.setAll(a, i -> theta[i] * scales[i]);
            double[][] b = new double[m][nb];
            for (int i = 0; i < m * nb; i++) {
                b[i / nb][i % nb] = theta[poles + i] * scales[poles + i];
            }
            return new TransferModel(a, b);
        }

        private double[] initial(double[] theta) {
            return Arrays.copyOfRange(theta, poles + m * nb, unknowns);
        }

        /**
         * Coefficients by instruments: {@code (Σ z φᵀ) θ = Σ z s^n y/A}.
         *
         * @param instrument in place of the output in z
         */
        private double[] solve(double[] a, double[] instrument) {
            CompanionForm filter = new CompanionForm(a, step);
            double[][] y = filter.filter(samples.y());
            double[][] x = instrument == samples.y() ? y : filter.filter(instrument);
            double[][] rest = rest(filter, a);
            DMatrixRMaj normal = new DMatrixRMaj(unknowns, unknowns);
            DMatrixRMaj right = new DMatrixRMaj(unknowns, 1);
            double[] phi = new double[unknowns];
            double[] z = new double[unknowns];
            for (int t = 0; t < samples.length(); t++) {
                double highest = samples.y()[t];
                for (int i = 0; i < poles; i++) {
                    phi[i] = -y[poles - 1 - i][t];
                    z[i] = -x[poles - 1 - i][t];
                    highest += a[i] * phi[i];
                }
                for (int i = 0; i < rest.length; i++) {
                    phi[poles + i] = rest[i][t];
                    z[poles + i] = rest[i][t];
                }
                for (int i = 0; i < unknowns; i++) {
                    right.data[i] += z[i] * highest;
                    int at = i * unknowns;
                    for (int j = 0; j < unknowns; j++) {
                        normal.data[at + j] += z[i] * phi[j];
                    }
                }
            }
            double[] scale = new double[unknowns];
            Arrays.setAll(scale, i -> 1 / Math.sqrt(Math.max(Math.abs(normal.get(i, i)), Double.MIN_NORMAL)));
            for (int i = 0; i < unknowns; i++) {
                right.data[i] *= scale[i];
                for (int j = 0; j < unknowns; j++) {
                    normal.data[i * unknowns + j] *= scale[i] * scale[j];
                }
            }
            LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.qr(unknowns, unknowns);
            DMatrixRMaj theta = new DMatrixRMaj(unknowns, 1);
            if (!solver.setA(normal)) {
                throw new ArithmeticException("instruments do not tell " + unknowns + " coefficients apart");
            }
            solver.solve(right, theta);
            double[] solved = theta.data.clone();
            for (int i = 0; i < unknowns; i++) {
                solved[i] *= scale[i];
            }
            return solved;
        }

        /**
         * Inverse of {@code Σ z zᵀ}.
         *
         * @param x simulated output
         * @param scatter hears z and what the simulation leaves
         */
        private DMatrixRMaj information(double[] a, double[] x, BatchScatter scatter) {
            CompanionForm filter = new CompanionForm(a, step);
            double[][] states = filter.filter(x);
            double[][] rest = rest(filter, a);
            LeastSquares sum = new LeastSquares(unknowns);
            double[] z = new double[unknowns];
            for (int t = 0; t < samples.length(); t++) {
                for (int i = 0; i < poles; i++) {
                    z[i] = -states[poles - 1 - i][t];
                }
                for (int i = 0; i < rest.length; i++) {
                    z[poles + i] = rest[i][t];
                }
                sum.add(z, 0);
                scatter.add(t, z, samples.y()[t] - x[t]);
            }
            return sum.inverse();
        }

        /** Regressors of the inputs and of the pulse, highest power first. */
        private double[][] rest(CompanionForm filter, double[] a) {
            double[][] rows = new double[m * nb + poles][];
            for (int i = 0; i < m; i++) {
                double[] u = samples.u()[i];
                double[][] z = filter.filter(u);
                for (int j = 0; j < nb; j++) {
                    int power = zeros - j;
                    rows[i * nb + j] = power < poles ? z[power] : highest(u, z, a);
                }
            }
            double[][] pulse = filter.pulse(samples.length());
            for (int i = 0; i < poles; i++) {
                rows[m * nb + i] = pulse[poles - 1 - i];
            }
            return rows;
        }

        private double[] highest(double[] u, double[][] z, double[] a) {
            double[] row = u.clone();
            for (int t = 0; t < row.length; t++) {
                for (int i = 0; i < poles; i++) {
                    row[t] -= a[i] * z[poles - 1 - i][t];
                }
            }
            return row;
        }

        /** The same polynomial with every root right of the imaginary axis mirrored to the left. */
        private double[] stable(double[] a) {
            Complex_F64[] roots = Polynomial.roots(a);
            if (Arrays.stream(roots).allMatch(root -> root.real < 0)) {
                return a;
            }
            double[] re = new double[poles + 1];
            double[] im = new double[poles + 1];
            re[0] = 1;
            for (int i = 0; i < poles; i++) {
                double r = Math.min(-Math.abs(roots[i].real), -1e-6);
                for (int k = i + 1; k > 0; k--) {
                    double nextRe = re[k] - (r * re[k - 1] - roots[i].imaginary * im[k - 1]);
                    double nextIm = im[k] - (r * im[k - 1] + roots[i].imaginary * re[k - 1]);
                    re[k] = nextRe;
                    im[k] = nextIm;
                }
            }
            return Arrays.copyOfRange(re, 1, poles + 1);
        }
    }
}

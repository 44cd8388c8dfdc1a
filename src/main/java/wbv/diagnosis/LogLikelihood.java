package wbv.diagnosis;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;

/**
 * How likely a residual is: {@code log L = -½ Σ rᴴ S⁻¹ r - Σ log det S} over the lines (Whittle 1953), the small errors of the sensors,
 * independent and of unit variance, integrated out exactly. What all hypotheses on the same evidence have in common is left out: a term of
 * log 2π for each number.
 *
 * <p>The half and the plain log det belong together: a line of {@link Window#spectrum} has the variance S in its real and in its imaginary part
 * each, so that as a complex vector its covariance is 2 S.
 */
final class LogLikelihood {

    private final double[] residual;
    private final double[][] columns;
    private final double logDeterminant;
    private final int outputs;
    private final double[][] gram;

    /**
     * @param residual       whitened. Not modified.
     * @param columns        what one standard deviation of each small error adds to it, whitened. Not modified.
     * @param logDeterminant sum of log det S over the lines
     */
    LogLikelihood(double[] residual, double[][] columns, double logDeterminant, int outputs) {
        this.residual = residual;
        this.columns = columns;
        this.logDeterminant = logDeterminant;
        this.outputs = outputs;
        double[][] all = Arrays.copyOf(columns, columns.length + 1);
        all[columns.length] = residual;
        this.gram = Gram.of(all);
    }

    /** Of a fit's residual in the frame that it stands in. */
    static LogLikelihood of(Fitter.State state) {
        Nuisances small = state.frame().nuisances();
        boolean[] off = small.off(state.candidate());
        double[][] columns = IntStream.range(0, small.count()).filter(i -> !off[i]).mapToObj(small::column).toArray(double[][]::new);
        Whitening whitening = state.frame().whitening();
        return new LogLikelihood(state.raw(), columns, whitening.logDeterminant(), whitening.outputs());
    }

    double value() {
        return value(gram, logDeterminant);
    }

    /** With one more process in the noise. */
    LogLikelihood with(RankOne process) {
        return new LogLikelihood(process.of(residual), Arrays.stream(columns).map(process::of).toArray(double[][]::new),
                logDeterminant + process.logDeterminant(), outputs);
    }

    /** The errors that are likeliest, in standard deviations. */
    double[] errors() {
        return factor(gram).solve(Arrays.copyOf(gram[columns.length], columns.length));
    }

    /** The same where errors are held, neither integrated out nor weighed by their prior. @param errors in standard deviations */
    double[] without(double[] errors) {
        double[] out = residual.clone();
        for (int i = 0; i < errors.length; i++) {
            for (int k = 0; k < out.length; k++) {
                out[k] -= errors[i] * columns[i][k];
            }
        }
        return out;
    }

    /** log det of the errors' curvature, priors included. */
    double errorsLogDeterminant() {
        return factor(gram).logDeterminant();
    }

    double logDeterminant() {
        return logDeterminant;
    }

    int outputs() {
        return outputs;
    }

    /** What a process along a way makes of it, for many powers at little cost. */
    Along along(double[] way) {
        return new Along(way);
    }

    /** The likelihood as a function of the power of one process: sums of what each line shows along it. */
    final class Along {
        private final double[] sizes;
        private final double[][] projected;

        private Along(double[] way) {
            sizes = RankOne.sizes(way, outputs);
            projected = new double[columns.length + 1][];
            for (int i = 0; i < columns.length; i++) {
                projected[i] = RankOne.along(way, columns[i], outputs);
            }
            projected[columns.length] = RankOne.along(way, residual, outputs);
        }

        /** |u|² at each line: how well the sensors see the process. Not a copy. */
        double[] sizes() {
            return sizes;
        }

        /** @param power by line */
        double value(double[] power) {
            double grown = 0;
            double[] root = new double[power.length];
            for (int line = 0; line < power.length; line++) {
                double more = power[line] * sizes[line];
                grown += Math.log1p(more);
                root[line] = Math.sqrt(power[line] / (1 + more));
            }
            double[][] scaled = new double[projected.length][];
            for (int i = 0; i < scaled.length; i++) {
                scaled[i] = new double[projected[i].length];
                for (int k = 0; k < scaled[i].length; k++) {
                    scaled[i][k] = root[k / 2] * projected[i][k];
                }
            }
            double[][] less = Gram.of(scaled);
            for (int i = 0; i < less.length; i++) {
                for (int j = 0; j < less.length; j++) {
                    less[i][j] = gram[i][j] - less[i][j];
                }
            }
            return LogLikelihood.value(less, logDeterminant + grown);
        }
    }

    /** @param gram of the errors' columns, the residual last */
    private static double value(double[][] gram, double logDeterminant) {
        int n = gram.length - 1;
        double[] products = Arrays.copyOf(gram[n], n);
        SymmetricFactor factor = factor(gram);
        double explained = n == 0 ? 0 : Fitter.dot(products, factor.solve(products));
        return -0.5 * (gram[n][n] - explained) - 0.5 * factor.logDeterminant() - logDeterminant;
    }

    /** Of 1 + DᵀD. */
    private static SymmetricFactor factor(double[][] gram) {
        int n = gram.length - 1;
        DMatrixRMaj a = new DMatrixRMaj(n, n);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                a.set(i, j, gram[i][j] + (i == j ? 1 : 0));
            }
        }
        return SymmetricFactor.of(a).orElseThrow();
    }
}

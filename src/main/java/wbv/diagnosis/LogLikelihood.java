package wbv.diagnosis;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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

    private static final double LARGE = 1e150;

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

    /**
     * Of a fit's residual in the frame that it stands in.
     *
     * @param modelled one standard deviation of each small error that acts on what is simulated, gains among them, whitened
     */
    static LogLikelihood of(Fitter.State state, List<double[]> modelled) {
        Nuisances small = state.frame().nuisances();
        boolean[] off = small.off(state.candidate());
        double[][] columns = Stream.concat(IntStream.range(0, small.count()).filter(i -> !off[i] && small.error(i).kind() != SmallError.Kind.GAIN)
                .mapToObj(small::column), modelled.stream())
                .toArray(double[][]::new);
        Whitening whitening = state.frame().whitening();
        return new LogLikelihood(state.raw(), columns, whitening.logDeterminant(), whitening.outputs());
    }

    double value() {
        int n = columns.length;
        double[] products = Arrays.copyOf(gram[n], n);
        SymmetricFactor factor = factor(gram);
        double explained = n == 0 ? 0 : Fitter.dot(products, factor.solve(products));
        return -0.5 * (gram[n][n] - explained) - 0.5 * factor.logDeterminant() - logDeterminant;
    }

    /** With one more process in the noise. */
    LogLikelihood with(RankOne process) {
        return new LogLikelihood(process.of(residual), Arrays.stream(columns).map(process::of).toArray(double[][]::new),
                logDeterminant + process.logDeterminant(), outputs);
    }

    int outputs() {
        return outputs;
    }

    /**
     * The likelihood as a function of the power of one more process, with the sensors' errors as they are likeliest beside a power near by: exact at
     * that, and a little too low elsewhere, since the errors do not follow. Then each line counts by itself, and many powers cost little.
     *
     * @param known   what does not depend on the power
     * @param sizes   |u|² by line: how well the sensors see the process
     * @param squares |uᴴ r|² by line
     */
    record Held(double known, double[] sizes, double[] squares) {

        /** @param power by line */
        double value(double[] power) {
            double sum = known;
            for (int line = 0; line < sizes.length; line++) {
                sum += value(line, line + 1, power[line]);
            }
            return sum;
        }

        /** What some lines add at one power: {@code -log(1 + Φa) + ½ Φb / (1 + Φa)} each. @param from first @param to after the last */
        double value(int from, int to, double power) {
            double sum = 0;
            double product = 1;
            for (int line = from; line < to; line++) {
                double grown = 1 + power * sizes[line];
                sum += 0.5 * power * squares[line] / grown;
                product *= grown;
                // One logarithm for many lines.
                if (product > LARGE) {
                    sum -= Math.log(product);
                    product = 1;
                }
            }
            return sum - Math.log(product);
        }
    }

    /** @param way a unit of the process in each output, whitened as the residual is. Not modified. @param near a power by line */
    Held held(double[] way, double[] near) {
        double[][] beside = with(new RankOne(way, near, outputs)).gram;
        SymmetricFactor factor = factor(beside);
        double[] errors = factor.solve(Arrays.copyOf(beside[columns.length], columns.length));
        double[] left = residual.clone();
        for (int i = 0; i < errors.length; i++) {
            for (int k = 0; k < left.length; k++) {
                left[k] -= errors[i] * columns[i][k];
            }
        }
        double known = -0.5 * Fitter.dot(left, left) - 0.5 * Fitter.dot(errors, errors) - 0.5 * factor.logDeterminant() - logDeterminant;
        double[] along = RankOne.along(way, left, outputs);
        double[] sizes = RankOne.sizes(way, outputs);
        double[] squares = new double[sizes.length];
        Arrays.setAll(squares, line -> along[2 * line] * along[2 * line] + along[2 * line + 1] * along[2 * line + 1]);
        return new Held(known, sizes, squares);
    }

    /** Of 1 + DᵀD. @param gram of the errors' columns, the residual last */
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

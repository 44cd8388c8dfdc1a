package wbv.diagnosis;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;

/**
 * The integral of a probability density over a box, near whose mode its logarithm is {@code top - g·δ - ½ δᵀHδ} (Laplace): exact for such a one
 * far from all bounds. Where it reaches bounds, coordinate after coordinate is cut at them, those before it standing at their means.
 */
final class LaplaceEvidence {

    /** Standard deviations beyond which a bound cuts nothing. */
    private static final double FAR = 7;
    /** Deviation of a coordinate that nothing tells, over the room that it has: so wide that it is level there. */
    private static final double WIDE = 10;
    private static final int POINTS = 400;

    private LaplaceEvidence() { }

    /**
     * Logarithm of the integral.
     *
     * @param gradient of minus the logarithm @param curvature likewise, symmetric @param low least δ, 0 or less @param high greatest, 0 or more
     */
    static double log(double top, double[] gradient, double[][] curvature, double[] low, double[] high) {
        int n = gradient.length;
        DMatrixRMaj h = new DMatrixRMaj(n, n);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                h.set(i, j, curvature[i][j] + (i == j ? least(high[i] - low[i]) : 0));
            }
        }
        SymmetricFactor factor = SymmetricFactor.of(h).orElseThrow(() -> new IllegalArgumentException("no mode: the curvature is not positive definite"));
        double[] centre = factor.solve(gradient);
        double whole = top + 0.5 * Fitter.dot(gradient, centre) + 0.5 * n * Math.log(2 * Math.PI) - 0.5 * factor.logDeterminant();
        double[] mean = Arrays.stream(centre).map(v -> -v).toArray();
        double[][] covariance = IntStream.range(0, n).mapToObj(i -> factor.solve(unit(i, n))).toArray(double[][]::new);
        for (int i = 0; i < n; i++) {
            double deviation = Math.sqrt(covariance[i][i]);
            if (mean[i] - low[i] < FAR * deviation || high[i] - mean[i] < FAR * deviation) {
                Cut cut = cut(mean[i], deviation, low[i], high[i]);
                whole += cut.log();
                condition(mean, covariance, i, cut.mean());
            }
        }
        return whole;
    }

    /** What nothing tells is told apart from infinity by the room that it has. */
    private static double least(double room) {
        return Double.isInfinite(room) ? 0 : 1 / Math.pow(WIDE * room, 2);
    }

    private static double[] unit(int i, int n) {
        double[] out = new double[n];
        out[i] = 1;
        return out;
    }

    /** The other coordinates where one stands at a value. @param mean Modified. @param covariance Modified. */
    private static void condition(double[] mean, double[][] covariance, int at, double value) {
        double[] row = covariance[at].clone();
        double moved = value - mean[at];
        for (int i = 0; i < mean.length; i++) {
            mean[i] += row[i] / row[at] * moved;
            for (int j = 0; j < mean.length; j++) {
                covariance[i][j] -= row[i] * row[j] / row[at];
            }
        }
    }

    /** A normal distribution's part between bounds. @param log of its probability @param mean within them */
    private record Cut(double log, double mean) { }

    /** By Simpson's rule over as much of the part as counts, however far in a tail it lies. */
    private static Cut cut(double mean, double deviation, double low, double high) {
        double nearest = Math.max(low, Math.min(high, mean));
        double outside = Math.abs(nearest - mean) / deviation;
        // In a tail it falls off within a deviation over the distance.
        double reach = FAR * deviation * Math.min(1, 6 / (outside + 1e-9));
        double from = Math.max(low, nearest - reach);
        double to = Math.min(high, nearest + reach);
        double step = (to - from) / POINTS;
        double[] logs = new double[POINTS + 1];
        for (int i = 0; i <= POINTS; i++) {
            double weight = i == 0 || i == POINTS ? 1 : i % 2 == 1 ? 4 : 2;
            double z = (from + i * step - mean) / deviation;
            logs[i] = Math.log(weight * step / 3) - 0.5 * z * z - Math.log(deviation * Math.sqrt(2 * Math.PI));
        }
        double sum = LogSum.of(logs);
        double inside = IntStream.rangeClosed(0, POINTS).mapToDouble(i -> Math.exp(logs[i] - sum) * (from + i * step)).sum();
        return new Cut(sum, inside);
    }
}

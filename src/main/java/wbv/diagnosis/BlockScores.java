package wbv.diagnosis;

import java.util.Arrays;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Projection;
import wbv.diagnosis.fit.Whitening;
import wbv.diagnosis.fit.Window;
import wbv.signal.ScalarProduct;

/**
 * How far a fit's coordinates may be off when what is left is not the white noise that the fit took it for: C⁻¹ B C⁻¹ with C the
 * curvature of half the cost and B the scatter of the gradient from one stretch of the recording to the next (Huber 1967; White
 * 1980; by groups, Liang and Zeger 1986). A force that nobody measured, an error of a law's form that grows with the level: both
 * are alike within a stretch of some seconds and differ between stretches.
 */
final class BlockScores {

    /** Length of a stretch [s]: a few periods of the slowest motion that counts. */
    private static final double BLOCK = 4;
    private static final int LEAST_BLOCKS = 6;

    private final double[][] gradients;

    /**
     * @param state with slopes, at its least cost. Not modified.
     * @param rate  of the recording [Hz]
     */
    BlockScores(Fitter.State state, double rate) {
        gradients = gradients(state, rate);
        for (int i = 0; i < state.x().length; i++) {
            double mean = 0;
            for (double[] each : gradients) {
                mean += each[i] / gradients.length;
            }
            for (double[] each : gradients) {
                each[i] -= mean;
            }
        }
    }

    /** Number of stretches. */
    int count() {
        return gradients.length;
    }

    /**
     * By how much the variance of b·x is more than the curvature alone says [1]; 1 where that says nothing.
     *
     * @param solved C⁻¹ b with C the curvature. Not modified.
     * @param white  b·C⁻¹ b
     */
    double ratio(double[] solved, double white) {
        return white > 0 ? variance(solved) / white : 1;
    }

    /**
     * Variance of b·x.
     *
     * @param solved C⁻¹ b with C the curvature. Not modified.
     */
    double variance(double[] solved) {
        double sum = 0;
        for (double[] each : gradients) {
            double step = ScalarProduct.of(solved, each);
            sum += step * step;
        }
        return sum * gradients.length / (gradients.length - 1);
    }

    /** Gradient of half the cost to each coordinate, by stretch of the recording. */
    private static double[][] gradients(Fitter.State state, double rate) {
        Whitening whitening = state.frame().whitening();
        Window window = whitening.window();
        int n = state.x().length;
        int outputs = whitening.size() / (2 * window.lines());
        int blocks = Math.max(LEAST_BLOCKS, (int) (window.length() / (BLOCK * rate)));
        double[][] out = new double[blocks][n];
        double[][] residual = series(state.residual(), window, outputs);
        Projection projection = new Projection(state);
        for (int i = 0; i < n; i++) {
            double[][] slope = series(projection.without(state.slopes()[i]), window, outputs);
            for (int b = 0; b < blocks; b++) {
                int from = (int) ((long) window.length() * b / blocks);
                int to = (int) ((long) window.length() * (b + 1) / blocks);
                for (int o = 0; o < outputs; o++) {
                    for (int t = from; t < to; t++) {
                        out[b][i] += residual[o][t] * slope[o][t];
                    }
                }
            }
        }
        // A series and a spectrum have their products in the same proportion, whatever the product.
        double square = 0;
        for (double[] each : residual) {
            square += ScalarProduct.of(each, each);
        }
        double scale = state.square() / square;
        for (double[] each : out) {
            for (int i = 0; i < n; i++) {
                each[i] *= scale;
            }
        }
        return out;
    }

    /** A whitened vector over time, by output. */
    private static double[][] series(double[] whitened, Window window, int outputs) {
        double[][] out = new double[outputs][];
        for (int o = 0; o < outputs; o++) {
            out[o] = window.series(Arrays.copyOfRange(whitened, 2 * window.lines() * o, 2 * window.lines() * (o + 1)));
        }
        return out;
    }
}

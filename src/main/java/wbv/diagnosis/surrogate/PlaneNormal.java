package wbv.diagnosis.surrogate;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import wbv.diagnosis.algebra.SymmetricFactor;
import wbv.diagnosis.fit.Parallel;

/**
 * Normal equations of a net at its numbers, and what the numbers cost there.
 *
 * @param square n by n for n numbers, each with its own unit's inverse
 * @param slope  n long, likewise: downwards
 * @param missed square of the share of each output that is missed
 * @param cost   what a fit lowers, see {@link FittedPlane}
 */
record PlaneNormal(double[][] square, double[] slope, double[] missed, double cost) {

    /** Work is dealt out in so many pieces, whatever the cores, so that sums do not hang on them. */
    private static final int PIECES = 8;
    /**
     * Of Student's distribution, assumed: many make one output that no body moves hide the others, few give up one that is a little worse.
     */
    private static final double FREEDOM = 20;
    /** Towards the likeliest scale [1]: an effort, a few microseconds beside a fit's step; assumed to be enough. */
    private static final int SCALE_STEPS = 100;

    /**
     * Of a net that is to do what spectra say.
     *
     * @param least share of an output that even the right arrangement misses
     */
    static PlaneNormal of(PlaneSpectra spectra, PlaneNet net, double least) {
        PlaneMatrices matrices = PlaneMatrices.of(net);
        List<MatrixSlope> slopes = MatrixSlope.of(net);
        int lines = spectra.omega().length;
        int piece = (lines + PIECES - 1) / PIECES;
        List<List<Share>> parts = Parallel.map(IntStream.range(0, PIECES).boxed().toList(),
                p -> part(spectra, matrices, slopes, p * piece, Math.min(lines, (p + 1) * piece)));
        return weighed(parts, net, least);
    }

    /** The part of one output in some lines, unweighed, its square's upper half empty. */
    private static final class Share {
        private final double[][] square;
        private final double[] slope;
        private double missed;

        Share(int numbers) {
            square = new double[numbers][numbers];
            slope = new double[numbers];
        }

        /** @param changes of the output by number, error likewise: real and imaginary part side by side */
        void gather(double[] changes, double[] error) {
            missed += error[0] * error[0] + error[1] * error[1];
            for (int p = 0; p < slope.length; p++) {
                double re = changes[2 * p];
                double im = changes[2 * p + 1];
                slope[p] -= re * error[0] + im * error[1];
                double[] row = square[p];
                for (int q = 0; q <= p; q++) {
                    row[q] += re * changes[2 * q] + im * changes[2 * q + 1];
                }
            }
        }
    }

    /**
     * What is missed of an output counts once a motion, all of them with one scale, the likeliest, and Student's tails (Lange, Little and
     * Taylor 1989): an output that no body in the plane moves does not hide what the others say. Numbers are expected where they are usual.
     *
     * @param parts by piece and output
     */
    private static PlaneNormal weighed(List<List<Share>> parts, PlaneNet net, double least) {
        double[] at = net.at();
        double[] usual = net.usual();
        double[] spread = net.spread();
        double[] missed = new double[parts.get(0).size()];
        Arrays.setAll(missed, o -> parts.stream().mapToDouble(part -> part.get(o).missed).sum());
        double[] squares = Arrays.stream(missed).map(share -> least * least + share).toArray();
        int motions = net.motions();
        double scale = scale(squares, motions);
        double[][] square = new double[at.length][at.length];
        double[] slope = new double[at.length];
        double sum = 0;
        for (int o = 0; o < missed.length; o++) {
            double tail = FREEDOM + motions * squares[o] / scale;
            sum += motions * Math.log(scale) + (FREEDOM + motions) * Math.log(tail / FREEDOM);
            for (List<Share> part : parts) {
                add(part.get(o), motions / scale * (FREEDOM + motions) / tail, square, slope);
            }
        }
        for (int i = 0; i < at.length; i++) {
            double pull = (at[i] - usual[i]) / spread[i];
            sum += pull * pull;
            for (int j = 0; j < i; j++) {
                square[j][i] = square[i][j];
            }
            square[i][i] += 1 / (spread[i] * spread[i]);
            slope[i] -= pull / spread[i];
        }
        return new PlaneNormal(square, slope, missed, Double.isNaN(sum) ? Double.POSITIVE_INFINITY : sum);
    }

    /** The likeliest scale of squares with such tails, by steps each of which is likelier than the last. */
    private static double scale(double[] squares, int motions) {
        double scale = Arrays.stream(squares).average().orElseThrow();
        for (int step = 0; step < SCALE_STEPS; step++) {
            double last = scale;
            scale = Arrays.stream(squares).map(own -> own * (FREEDOM + motions) / (FREEDOM + motions * own / last)).average().orElseThrow();
        }
        return scale;
    }

    private static void add(Share share, double weight, double[][] square, double[] slope) {
        for (int i = 0; i < slope.length; i++) {
            slope[i] += weight * share.slope[i];
            for (int j = 0; j <= i; j++) {
                square[i][j] += weight * share.square[i][j];
            }
        }
    }

    /**
     * The logarithm of the evidence where the fit has settled, see {@link FittedPlane}: what is the likeliest costs, and how much narrower
     * than their spread the numbers are known, which arrangements with more of them pay for.
     */
    double evidence(PlaneNet net) {
        double[] spread = net.spread();
        DMatrixRMaj known = new DMatrixRMaj(spread.length, spread.length);
        for (int i = 0; i < spread.length; i++) {
            for (int j = 0; j < spread.length; j++) {
                known.set(i, j, spread[i] * spread[j] * square[i][j]);
            }
        }
        return SymmetricFactor.of(known).map(factor -> -(cost + factor.logDeterminant()) / 2).orElse(Double.NEGATIVE_INFINITY);
    }

    /** The parts of some lines, by output. */
    private static List<Share> part(PlaneSpectra spectra, PlaneMatrices matrices, List<MatrixSlope> slopes, int from, int to) {
        int numbers = slopes.size();
        List<Share> out = spectra.outputs().stream().map(output -> new Share(numbers)).toList();
        PlaneResponse response = new PlaneResponse(spectra, matrices);
        double[] error = new double[2];
        double[] changes = new double[2 * numbers];
        for (int k = from; k < to; k++) {
            response.at(k);
            for (int o = 0; o < out.size(); o++) {
                response.error(o, error);
                for (int p = 0; p < numbers; p++) {
                    response.slope(slopes.get(p), o, changes, p);
                }
                out.get(o).gather(changes, error);
            }
        }
        return out;
    }
}

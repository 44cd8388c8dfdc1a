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
     * Of a net that is to do what spectra say.
     *
     * @param least share of an output that even the right arrangement misses
     */
    static PlaneNormal of(PlaneSpectra spectra, PlaneNet net, double least) {
        PlaneMatrices matrices = PlaneMatrices.of(net);
        List<MatrixSlope> slopes = MatrixSlope.of(net);
        int lines = spectra.omega().length;
        int piece = (lines + PIECES - 1) / PIECES;
        List<PlaneNormal> parts = Parallel.map(IntStream.range(0, PIECES).boxed().toList(),
                p -> part(spectra, matrices, slopes, p * piece, Math.min(lines, (p + 1) * piece)));
        PlaneNormal sum = zero(slopes.size(), spectra.outputs().size());
        parts.forEach(sum::add);
        return sum.weighed(net, least);
    }

    private static PlaneNormal zero(int numbers, int outputs) {
        return new PlaneNormal(new double[numbers][numbers], new double[numbers], new double[outputs], 0);
    }

    private void add(PlaneNormal part) {
        Arrays.setAll(slope, i -> slope[i] + part.slope[i]);
        Arrays.setAll(missed, o -> missed[o] + part.missed[o]);
        for (int i = 0; i < square.length; i++) {
            double[] row = square[i];
            double[] more = part.square[i];
            Arrays.setAll(row, j -> row[j] + more[j]);
        }
    }

    /** The same where what is missed counts once a motion, by its likeliest variance, and numbers are expected where they are usual. */
    private PlaneNormal weighed(PlaneNet net, double least) {
        double[] at = net.at();
        double[] usual = net.usual();
        double[] spread = net.spread();
        double variance = least * least + Arrays.stream(missed).average().orElseThrow();
        double sum = net.motions() * missed.length * Math.log(variance);
        double weight = net.motions() / variance;
        for (int i = 0; i < at.length; i++) {
            double pull = (at[i] - usual[i]) / spread[i];
            sum += pull * pull;
            for (int j = 0; j < at.length; j++) {
                square[i][j] *= weight;
            }
            square[i][i] += 1 / (spread[i] * spread[i]);
            slope[i] = weight * slope[i] - pull / spread[i];
        }
        return new PlaneNormal(square, slope, missed, Double.isNaN(sum) ? Double.POSITIVE_INFINITY : sum);
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

    /** The part of some lines, unweighed. */
    private static PlaneNormal part(PlaneSpectra spectra, PlaneMatrices matrices, List<MatrixSlope> slopes, int from, int to) {
        int numbers = slopes.size();
        int outputs = spectra.outputs().size();
        PlaneNormal out = zero(numbers, outputs);
        PlaneResponse response = new PlaneResponse(spectra, matrices);
        double[] error = new double[2];
        double[] changes = new double[2 * numbers];
        for (int k = from; k < to; k++) {
            response.at(k);
            for (int o = 0; o < outputs; o++) {
                response.error(o, error);
                out.missed[o] += error[0] * error[0] + error[1] * error[1];
                for (int p = 0; p < numbers; p++) {
                    response.slope(slopes.get(p), o, changes, p);
                }
                out.gather(changes, error);
            }
        }
        for (int p = 0; p < numbers; p++) {
            for (int q = 0; q < p; q++) {
                out.square[q][p] = out.square[p][q];
            }
        }
        return out;
    }

    /** Adds one output at one line, to the lower half of the square. */
    private void gather(double[] changes, double[] error) {
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

package wbv.diagnosis.measured;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.signal.ComplexSeries;
import wbv.signal.Detrend;
import wbv.signal.Segmentation;
import wbv.signal.SpectralMatrix;

/**
 * Noise of several sensors of one kind in a band in which something may move: what they share is motion, what they do not share is noise.
 * First what the outputs share with the input goes (the input's own noise, which a body passes on weakly up there, stays in); then, in
 * narrow bands, the matrix of their spectra is that of other motion, which has few ways to reach them, and the noise's, which has the same
 * power in all directions: its small eigenvalues are the noise (Tipping and Bishop 1999), as many as are no farther apart than those of
 * noise alone are (Marčenko and Pastur 1967).
 */
final class Unshared {

    private static final int SEGMENT = 256;
    /** Segments below which shorter ones are taken. */
    private static final double FEWEST = 10;
    private static final int SHORTEST = 64;
    /** Independent parts of a bin: what Hann's window makes of neighbours. */
    private static final double OWN = 1 / (1 + 2 * (4.0 / 9 + 1.0 / 36));
    /** So seldom sensors that share nothing seem to share something. */
    private static final double CHANCE = 1e-4;

    private final SpectralMatrix spectra;
    private final double low;
    private final double high;
    private final double width;

    /**
     * @param series of the sensors, without gaps, the input's first. Not modified.
     * @param low edges and width of the bands over the rate
     */
    Unshared(double[][] series, double low, double high, double width) {
        this.low = low;
        this.high = high;
        this.width = width;
        int n = series[0].length;
        int length = SEGMENT;
        while (length > SHORTEST && 2.0 * n / length - 1 < FEWEST) {
            length /= 2;
        }
        spectra = new SpectralMatrix(new Segmentation(1, length, 0.5), Detrend.MEAN, series.length);
        double[] row = new double[series.length];
        for (int i = 0; i < n; i++) {
            for (int c = 0; c < row.length; c++) {
                row[c] = series[c][i];
            }
            spectra.accept(row);
        }
    }

    /**
     * Standard deviation of a sample of white noise as strong as what the sensors do not share; empty where the first shares nothing with
     * others.
     */
    OptionalDouble level() {
        List<double[]> bands = new ArrayList<>();
        boolean shared = false;
        int count = (int) Math.floor((high - low) / width + 1e-9);
        for (int b = 0; b < count; b++) {
            Band band = new Band(low + b * width, low + (b + 1) * width);
            shared |= band.sharedByChance() < CHANCE / count;
            bands.add(band.noise());
        }
        if (!shared) {
            return OptionalDouble.empty();
        }
        bands.sort((a, b) -> Double.compare(a[0], b[0]));
        double least = bands.get(0)[0];
        double sum = 0;
        double weight = 0;
        for (double[] band : bands) {
            if (band[0] <= least * (1 + NoiseLevel.ALIKE / Math.sqrt(band[1]))) {
                sum += band[0] * band[1];
                weight += band[1];
            }
        }
        // One-sided density over a rate of 1: white noise of variance 1 has a density of 2.
        return OptionalDouble.of(Math.sqrt(sum / weight / 2));
    }

    /** The spectra of a narrow band. */
    private final class Band {

        private final int m = spectra.channels();
        private final double[][] re = new double[m][m];
        private final double[][] im = new double[m][m];
        /** Independent numbers that were averaged. */
        private final double count;

        Band(double from, double to) {
            Segmentation segmentation = spectra.segmentation();
            int first = (int) Math.ceil(from * segmentation.length());
            int last = Math.max(first + 1, (int) Math.ceil(to * segmentation.length()));
            for (int i = 0; i < m; i++) {
                for (int j = 0; j < m; j++) {
                    ComplexSeries cross = spectra.cross(i, j);
                    for (int k = first; k < last; k++) {
                        re[i][j] += cross.re()[k] / (last - first);
                        im[i][j] += cross.im()[k] / (last - first);
                    }
                }
            }
            count = Math.max(m + 1, spectra.independent() * (1 + (last - first - 1) * OWN));
        }

        /**
         * The chance that sensors which share nothing look as much as if the first shared something with the others: of Beta(m - 1, N - m +
         * 1).
         */
        double sharedByChance() {
            if (m < 2 || !(re[0][0] > 0)) {
                return 1;
            }
            double explained = 1 - 1 / (re[0][0] * inverseFirst());
            double tail = 0;
            double term = Math.pow(1 - explained, count - 1);
            for (int j = 0; j <= m - 2; j++) {
                tail += term;
                term *= (count - 1 - j) / (j + 1) * explained / (1 - explained);
            }
            return explained <= 0 ? 1 : explained >= 1 ? 0 : tail;
        }

        /** Power of what the outputs share with nothing, and the independent numbers that it was told from. */
        double[] noise() {
            double[] values = eigenvalues();
            double left = count - 1;   // one number went with the input
            double mean = values[0];
            int taken = 1;
            while (taken < values.length && values[taken] < apart(taken + 1, left) * mean) {
                mean = (taken * mean + values[taken]) / (taken + 1);
                taken++;
            }
            double free = Math.max(1, left - (values.length - taken));
            return new double[] {mean * count / free, taken * free};
        }

        /** How far apart the ends are of the eigenvalues of so many sensors' noise. */
        private double apart(int n, double numbers) {
            double root = Math.min(0.9, Math.sqrt(n / numbers));
            return Math.pow((1 + root) / (1 - root), 2);
        }

        private DMatrixRMaj real() {
            DMatrixRMaj out = new DMatrixRMaj(2 * m, 2 * m);
            for (int i = 0; i < m; i++) {
                for (int j = 0; j < m; j++) {
                    out.set(i, j, re[i][j]);
                    out.set(m + i, m + j, re[i][j]);
                    out.set(i, m + j, -im[i][j]);
                    out.set(m + i, j, im[i][j]);
                }
            }
            return out;
        }

        /** Of the outputs' spectra without what goes with the input: each once, rising. */
        private double[] eigenvalues() {
            int n = m - 1;
            DMatrixRMaj rest = new DMatrixRMaj(2 * n, 2 * n);
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    // G_ij - G_i0 G_0j / G_00
                    double ar = re[i + 1][0];
                    double ai = im[i + 1][0];
                    double br = re[0][j + 1];
                    double bi = im[0][j + 1];
                    double own = re[i + 1][j + 1] - (ar * br - ai * bi) / re[0][0];
                    double turned = i == j ? 0 : im[i + 1][j + 1] - (ar * bi + ai * br) / re[0][0];
                    rest.set(i, j, own);
                    rest.set(n + i, n + j, own);
                    rest.set(i, n + j, -turned);
                    rest.set(n + i, j, turned);
                }
            }
            EigenDecomposition_F64<DMatrixRMaj> eigen = DecompositionFactory_DDRM.eig(2 * n, false, true);
            eigen.decompose(rest);
            double[] all = new double[2 * n];
            Arrays.setAll(all, i -> eigen.getEigenvalue(i).real);
            Arrays.sort(all);
            double[] out = new double[n];
            Arrays.setAll(out, i -> Math.max(0, (all[2 * i] + all[2 * i + 1]) / 2));
            return out;
        }

        private double inverseFirst() {
            double[] first = new double[2 * m];
            first[0] = 1;
            double[][] a = new double[2 * m][2 * m];
            DMatrixRMaj real = real();
            for (int i = 0; i < 2 * m; i++) {
                for (int j = 0; j < 2 * m; j++) {
                    a[i][j] = real.get(i, j);
                }
            }
            return DampedEquations.solve(a, first)[0];
        }
    }
}

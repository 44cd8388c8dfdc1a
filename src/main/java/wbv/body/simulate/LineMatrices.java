package wbv.body.simulate;

import java.util.Arrays;

/**
 * Complex symmetric matrices at neighbouring spectral lines, to be inverted together: an entry is a run of numbers, one a line, so that a
 * processor takes several lines at a time, and of each matrix only one half is kept.
 *
 * <p>Not for several threads at once.
 */
final class LineMatrices {

    /** Lines that are taken together: those of a dozen rows, 20 kB, then fit a nearest cache of 32 kB. */
    static final int LINES = 16;

    private final int rows;
    /** Real and imaginary parts by entry and line. */
    private final double[][] re;
    private final double[][] im;
    /** Entries that something was added to; the others are 0 at all lines. */
    private final boolean[] filled;
    private final double[] pivotRe = new double[LINES];
    private final double[] pivotIm = new double[LINES];
    private final double[] factorRe = new double[LINES];
    private final double[] factorIm = new double[LINES];

    /** All of them 0. */
    LineMatrices(int rows) {
        this.rows = rows;
        int entries = rows * (rows + 1) / 2;
        re = new double[entries][LINES];
        im = new double[entries][LINES];
        filled = new boolean[entries];
    }

    /** Makes all of them 0. */
    void clear() {
        for (int entry = 0; entry < re.length; entry++) {
            Arrays.fill(re[entry], 0);
            Arrays.fill(im[entry], 0);
        }
        Arrays.fill(filled, false);
    }

    /** Where an entry and its mirror image stand. */
    private int at(int i, int j) {
        int high = Math.max(i, j);
        return high * (high + 1) / 2 + Math.min(i, j);
    }

    /**
     * Adds to an entry, and to its mirror image with it.
     *
     * @param spectrum real and imaginary part of each line in turn, of which this takes those from its first on. Not modified.
     * @param first    line of the spectrum
     * @param count    lines, {@link #LINES} at most
     */
    void add(int i, int j, double[] spectrum, double factor, int first, int count) {
        int entry = at(i, j);
        filled[entry] = true;
        for (int k = 0; k < count; k++) {
            re[entry][k] += factor * spectrum[2 * (first + k)];
            im[entry][k] += factor * spectrum[2 * (first + k) + 1];
        }
    }

    /** Adds the same to an entry at a line, real. */
    void add(int i, int line, double value) {
        int entry = at(i, i);
        filled[entry] = true;
        re[entry][line] += value;
    }

    /**
     * Puts an entry back into a spectrum.
     *
     * @param spectrum as for {@link #add}. Modified.
     */
    void get(int i, int j, double[] spectrum, int first, int count) {
        int entry = at(i, j);
        for (int k = 0; k < count; k++) {
            spectrum[2 * (first + k)] = re[entry][k];
            spectrum[2 * (first + k) + 1] = im[entry][k];
        }
    }

    /**
     * Inverts all of them in place by sweeps (Goodnight 1979). The matrices here are diagonally strong and small, so the diagonal serves as
     * pivot.
     */
    void invert() {
        for (int p = 0; p < rows; p++) {
            sweep(p);
        }
        for (int entry = 0; entry < re.length; entry++) {
            for (int k = 0; k < LINES; k++) {
                re[entry][k] = -re[entry][k];
                im[entry][k] = -im[entry][k];
            }
        }
    }

    private void sweep(int p) {
        double[] pivotedRe = re[at(p, p)];
        double[] pivotedIm = im[at(p, p)];
        for (int k = 0; k < LINES; k++) {
            double size = pivotedRe[k] * pivotedRe[k] + pivotedIm[k] * pivotedIm[k];
            pivotRe[k] = pivotedRe[k] / size;
            pivotIm[k] = -pivotedIm[k] / size;
        }
        for (int i = 0; i < rows; i++) {
            int own = at(i, p);
            if (i == p || !filled[own]) {
                continue;
            }
            product(re[own], im[own], pivotRe, pivotIm, factorRe, factorIm);
            for (int j = i; j < rows; j++) {
                int other = at(j, p);
                if (j != p && filled[other]) {
                    int target = at(i, j);
                    filled[target] = true;
                    subtractProduct(factorRe, factorIm, re[other], im[other], re[target], im[target]);
                }
            }
            // No later row asks for it as it was.
            System.arraycopy(factorRe, 0, re[own], 0, LINES);
            System.arraycopy(factorIm, 0, im[own], 0, LINES);
        }
        for (int k = 0; k < LINES; k++) {
            pivotedRe[k] = -pivotRe[k];
            pivotedIm[k] = -pivotIm[k];
        }
    }

    private static void product(double[] ar, double[] ai, double[] br, double[] bi, double[] outRe, double[] outIm) {
        for (int k = 0; k < LINES; k++) {
            outRe[k] = ar[k] * br[k] - ai[k] * bi[k];
            outIm[k] = ar[k] * bi[k] + ai[k] * br[k];
        }
    }

    private static void subtractProduct(double[] ar, double[] ai, double[] br, double[] bi, double[] outRe, double[] outIm) {
        for (int k = 0; k < LINES; k++) {
            outRe[k] -= ar[k] * br[k] - ai[k] * bi[k];
            outIm[k] -= ar[k] * bi[k] + ai[k] * br[k];
        }
    }
}

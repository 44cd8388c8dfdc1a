package wbv.body.simulate;

import java.util.Arrays;
import wbv.signal.RealDft;

/** Series of a record at a whole multiple of its rate, and their spectra at the lines that an {@link Excitation} keeps. */
final class Grid {
    private final RealDft dft;
    private final int points;
    private final int factor;
    private final int lines;

    /**
     * @param padded samples of the record with the silence after it
     * @param samples of the record alone
     * @param lines kept
     * @param factor samples here for each of the record
     */
    Grid(int padded, int samples, int lines, int factor) {
        this.dft = new RealDft(padded * factor);
        this.points = samples * factor;
        this.factor = factor;
        this.lines = lines;
    }

    /** Samples of the record at this rate. */
    int points() {
        return points;
    }

    /**
     * The series of the record alone, {@link #points} long.
     *
     * @param spectrum Not modified.
     */
    double[] series(double[] spectrum) {
        double[] out = dft.inverse(spectrum, points);
        if (factor > 1) {
            for (int i = 0; i < out.length; i++) {
                out[i] *= factor;
            }
        }
        return out;
    }

    /**
     * The lines of a series, after whose end is silence.
     *
     * @param series of which nothing counts that is beyond the padded record. Not modified.
     */
    double[] spectrum(double[] series) {
        double[] out = dft.forward(series.length > dft.length() ? Arrays.copyOf(series, dft.length()) : series, lines);
        if (factor > 1) {
            for (int i = 0; i < out.length; i++) {
                out[i] /= factor;
            }
        }
        return out;
    }
}

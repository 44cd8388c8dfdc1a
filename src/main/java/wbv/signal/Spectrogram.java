package wbv.signal;

import java.util.Arrays;

/**
 * Power spectral density over time (short-time Fourier transform), with a bounded number of columns.
 *
 * <p>A column is the mean density of the segments that begin in its stretch of time. When the columns are used up, neighbours
 * are merged two by two and every later column takes twice as many segments, so that hours need no more memory than minutes.
 * Segments with a missing sample (NaN) are left out; a column without any whole segment is NaN.
 */
public final class Spectrogram {

    private final Segmentation segmentation;
    private final Segments segments;
    private final double[][] power;
    private final int[] averaged;
    private int segmentsPerColumn = 1;
    private int column;
    private int inColumn;

    /**
     * A spectrogram of no segment yet.
     *
     * @param mostColumns columns kept at most, even, at least 2
     */
    public Spectrogram(Segmentation segmentation, Detrend detrend, int mostColumns) {
        if (mostColumns < 2 || mostColumns % 2 != 0) {
            throw new IllegalArgumentException("number of columns must be even and >= 2: " + mostColumns);
        }
        this.segmentation = segmentation;
        this.segments = new Segments(segmentation, detrend);
        this.power = new double[mostColumns][segmentation.bins()];
        this.averaged = new int[mostColumns];
    }

    /** Takes the next sample, of any unit; NaN is missing. Thesis: Eq. 2-28. */
    public void accept(double value) {
        if (!segments.accept(value)) {
            return;
        }
        if (inColumn == segmentsPerColumn) {
            inColumn = 0;
            column++;
            if (column == power.length) {
                merge();
            }
        }
        if (segments.whole()) {
            Segments.addPower(segments.spectrum(), power[column]);
            averaged[column]++;
        }
        inColumn++;
    }

    private void merge() {
        int half = power.length / 2;
        for (int i = 0; i < half; i++) {
            double[] sum = power[2 * i];
            for (int k = 0; k < sum.length; k++) {
                sum[k] += power[2 * i + 1][k];
            }
            averaged[i] = averaged[2 * i] + averaged[2 * i + 1];
            power[2 * i] = power[i];
            power[i] = sum;
        }
        for (int i = half; i < power.length; i++) {
            Arrays.fill(power[i], 0);
            averaged[i] = 0;
        }
        segmentsPerColumn *= 2;
        column = half;
    }

    /** How samples are cut into segments. */
    public Segmentation segmentation() {
        return segmentation;
    }

    /** Number of columns begun. */
    public int columns() {
        return inColumn == 0 ? 0 : column + 1;
    }

    /** Time from the centre of a column to the centre of the next [s]. */
    public double columnStep() {
        return segmentsPerColumn * segmentation.hop() / segmentation.rate();
    }

    /** Centre of a column [s], counted from the first sample. */
    public double time(int column) {
        return (segmentation.duration() - segmentation.hop() / segmentation.rate()) / 2 + (column + 0.5) * columnStep();
    }

    /** Density [dB re 1 unit²/Hz] of a column at every bin; NaN if no segment of the column is whole. */
    public double[] decibels(int column) {
        double scale = Segments.densityScale(segmentation) / averaged[column];
        double[] decibels = new double[segmentation.bins()];
        for (int k = 0; k < decibels.length; k++) {
            decibels[k] = 10 * Math.log10(power[column][k] * scale);
        }
        return decibels;
    }
}

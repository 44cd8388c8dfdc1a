package wbv.signal;

import java.util.Arrays;
import wbv.recording.DataFault;

/**
 * Auto and cross spectra of one input and any number of outputs, averaged over segments as they pass (Welch 1967).
 *
 * <p>{@code G_yx = E[Y X*]}, one-sided, [unit_y unit_x / Hz]. The input is transformed once per segment, whatever the number
 * of outputs. A segment with a missing sample (NaN) in the input or in an output is left out for that output and counted; every
 * output keeps its own input power, so that all spectra of a pair come from the same segments.
 */
public final class CrossSpectrum {

    private final Segmentation segmentation;
    private final Detrend detrend;
    private final Segments input;
    private final Pair[] pairs;

    /**
     * Averages of no segment yet.
     *
     * @param outputs number of outputs, at least 1
     */
    public CrossSpectrum(Segmentation segmentation, Detrend detrend, int outputs) {
        if (outputs < 1) {
            throw new IllegalArgumentException("a cross spectrum needs at least 1 output: " + outputs);
        }
        this.segmentation = segmentation;
        this.detrend = detrend;
        this.input = new Segments(segmentation, detrend);
        this.pairs = new Pair[outputs];
        Arrays.setAll(pairs, i -> new Pair(segmentation, detrend));
    }

    /**
     * Takes the next sample of the input and of a single output; NaN is missing.
     *
     * @param x in its own unit
     * @param y in its own unit
     */
    public void accept(double x, double y) {
        if (pairs.length != 1) {
            throw new IllegalArgumentException("one output sample for " + pairs.length + " outputs");
        }
        boolean due = input.accept(x);
        pairs[0].segments.accept(y);
        if (due) {
            average();
        }
    }

    /**
     * Takes the next sample of the input and of all outputs, each in its own unit; NaN is missing.
     *
     * @param y one value an output, in its own unit. Not modified.
     */
    public void accept(double x, double[] y) {
        if (y.length != pairs.length) {
            throw new IllegalArgumentException(y.length + " output samples for " + pairs.length + " outputs");
        }
        boolean due = input.accept(x);
        for (int i = 0; i < pairs.length; i++) {
            pairs[i].segments.accept(y[i]);
        }
        if (due) {
            average();
        }
    }

    private void average() {
        if (!input.whole()) {
            for (Pair pair : pairs) {
                pair.skipped++;
            }
            return;
        }
        double[] x = input.spectrum();
        for (Pair pair : pairs) {
            if (pair.segments.whole()) {
                pair.add(x, pair.segments.spectrum());
            } else {
                pair.skipped++;
            }
        }
    }

    /** How samples are cut into segments. */
    public Segmentation segmentation() {
        return segmentation;
    }

    /** Number of outputs. */
    public int outputs() {
        return pairs.length;
    }

    /** Segments averaged for an output. */
    public long averaged(int output) {
        return pairs[output].averaged;
    }

    /** Segments left out for an output because a sample was missing. */
    public long skipped(int output) {
        return pairs[output].skipped;
    }

    /** Power spectral density of the input over the segments of an output, by bin [unit²/Hz]. */
    public double[] inputDensity(int output) {
        return scaled(pairs[output], pairs[output].xx);
    }

    /** Power spectral density of an output, by bin [unit²/Hz]. */
    public double[] outputDensity(int output) {
        return scaled(pairs[output], pairs[output].yy);
    }

    /** Cross spectral density G_yx of an output [unit_y unit_x / Hz]. */
    public ComplexSeries crossDensity(int output) {
        return new ComplexSeries(scaled(pairs[output], pairs[output].yxRe), scaled(pairs[output], pairs[output].yxIm));
    }

    /**
     * The frequency response from the input to an output.
     * Thesis: Eq. 2-9, 4-25.
     *
     * @throws DataFault if there was no whole segment
     */
    public FrequencyResponse response(int output, FrequencyResponse.Excited excited) {
        Pair pair = pairs[output];
        if (pair.averaged == 0) {
            throw new DataFault("a frequency response needs at least one segment of " + segmentation.length()
                    + " samples in a row (" + segmentation.duration() + " s) without gaps: none of " + pair.skipped
                    + " is whole");
        }
        return FrequencyResponse.of(segmentation.frequencies(), inputDensity(output), outputDensity(output),
                crossDensity(output), segmentation.independent(pair.averaged), detrend.firstBin(), excited);
    }

    private double[] scaled(Pair pair, double[] sums) {
        double scale = Segments.densityScale(segmentation) / pair.averaged;
        return Arrays.stream(sums).map(sum -> sum * scale).toArray();
    }

    /** The sums of one output and the input. */
    private static final class Pair {

        final Segments segments;
        final double[] xx;
        final double[] yy;
        final double[] yxRe;
        final double[] yxIm;
        long averaged;
        long skipped;

        Pair(Segmentation segmentation, Detrend detrend) {
            segments = new Segments(segmentation, detrend);
            xx = new double[segmentation.bins()];
            yy = new double[segmentation.bins()];
            yxRe = new double[segmentation.bins()];
            yxIm = new double[segmentation.bins()];
        }

        void add(double[] x, double[] y) {
            Segments.addPower(x, xx);
            Segments.addPower(y, yy);
            Segments.addProduct(y, x, yxRe, yxIm);
            averaged++;
        }
    }
}

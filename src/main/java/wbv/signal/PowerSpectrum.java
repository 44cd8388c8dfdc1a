package wbv.signal;

import java.util.Arrays;

/**
 * One-sided power spectral density of one channel, averaged over segments as they pass (Welch 1967).
 *
 * <p>Segments with a missing sample (NaN) are skipped and counted.
 */
public final class PowerSpectrum {

    private final Segmentation segmentation;
    private final Segments segments;
    private final double[] power;
    private long averaged;
    private long skipped;

    /** An average of no segment yet. */
    public PowerSpectrum(Segmentation segmentation, Detrend detrend) {
        this.segmentation = segmentation;
        this.segments = new Segments(segmentation, detrend);
        this.power = new double[segmentation.bins()];
    }

    /** Takes the next sample, of any unit; NaN is missing. */
    public void accept(double value) {
        if (!segments.accept(value)) {
            return;
        }
        if (!segments.whole()) {
            skipped++;
            return;
        }
        Segments.addPower(segments.spectrum(), power);
        averaged++;
    }

    /** How samples are cut into segments. */
    public Segmentation segmentation() {
        return segmentation;
    }

    /** Segments averaged so far. */
    public long averaged() {
        return averaged;
    }

    /** Segments left out because a sample was missing. */
    public long skipped() {
        return skipped;
    }

    /** The density at every bin [unit²/Hz]; NaN before the first whole segment. */
    public double[] density() {
        double scale = Segments.densityScale(segmentation) / averaged;
        return Arrays.stream(power).map(sum -> sum * scale).toArray();
    }
}

package wbv.filter;

import java.io.Serializable;

/**
 * What an estimator knows after a sample. One object is reused: read it before the next sample.
 *
 * <p>Standard deviations of frequency and damping come from those of their logarithms (delta method).
 */
public final class Track implements Serializable {

    private static final long serialVersionUID = 1;

    double frequency;
    double damping;
    double frequencyDeviation;
    double dampingDeviation;
    double prediction;
    double nis;
    double outputNoise;
    boolean cut;
    boolean settled;
    long width;
    long cuts;
    long changes;
    long divergences;
    long gaps;
    long missing;

    Track() { }

    /** Natural frequency f0 [Hz]. */
    public double frequency() {
        return frequency;
    }

    /** Natural angular frequency ω [rad/s]. */
    public double omega() {
        return 2 * Math.PI * frequency;
    }

    /** Damping ratio ζ [1]. */
    public double damping() {
        return damping;
    }

    /** Standard deviation of the natural frequency [Hz]. */
    public double frequencyDeviation() {
        return frequencyDeviation;
    }

    /** Standard deviation of the damping ratio [1]. */
    public double dampingDeviation() {
        return dampingDeviation;
    }

    /** The output sample [m/s²] as foreseen from this input sample and everything before it. NaN before the first sample. */
    public double prediction() {
        return prediction;
    }

    /** Normalised innovation squared ν²/S [1]: averages 1 while model and noise are right. NaN where nothing was corrected. */
    public double nis() {
        return nis;
    }

    /** Standard deviation [m/s²] of what neither model nor input explains in an output sample; the sensor's at least. */
    public double outputNoise() {
        return outputNoise;
    }

    /** Whether the alarm cut its window at this sample: the body, or what disturbs it, has changed. */
    public boolean cut() {
        return cut;
    }

    /** Whether the start (or the last change) is far enough behind that the alarm listens. */
    public boolean settled() {
        return settled;
    }

    /** Number of samples in the alarm's window. */
    public long width() {
        return width;
    }

    /** Cuts so far. */
    public long cuts() {
        return cuts;
    }

    /** Those of the cuts at which the model became worse: the body has changed. */
    public long changes() {
        return changes;
    }

    /** How often the estimate diverged and began anew. */
    public long divergences() {
        return divergences;
    }

    /** How often the input was missing for so long that the body's motion had to be found again. */
    public long gaps() {
        return gaps;
    }

    /** Samples of which the input or the output was missing. */
    public long missing() {
        return missing;
    }
}

package wbv.filter;

import java.io.Serializable;

/**
 * What an estimator knows after a sample. One object is reused: read it before the next sample.
 *
 * <p>Standard deviations of frequency and damping come from those of their logarithms (delta method).
 */
public final class Track implements Serializable {

    private static final long serialVersionUID = 1;

    /** Relative standard deviation below which a parameter is found: nine tenths of what it starts with. */
    private static final double FOUND = 0.9 * JointFilter.START;

    double frequency;
    double damping;
    double frequencyDeviation;
    double dampingDeviation;
    double prediction;
    double nis;
    double outputNoise;
    boolean cut;
    boolean changed;
    boolean settled;
    long width;
    long cuts;
    long changes;
    long divergences;
    long gaps;
    long missing;

    Track() { }

    /** As before the first sample, but for what the filter publishes after each. */
    void clear() {
        prediction = Double.NaN;
        nis = Double.NaN;
        cut = false;
        changed = false;
        cuts = 0;
        changes = 0;
        divergences = 0;
        gaps = 0;
        missing = 0;
    }

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

    /** Whether the samples have told anything about the parameters that was not assumed before the first of them. */
    public boolean found() {
        return frequencyDeviation < FOUND * frequency || dampingDeviation < FOUND * damping;
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

    /** Whether the model became worse at this cut: the body has changed, and its parameters are being learned again. */
    public boolean changed() {
        return changed;
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

    /** Changes so far; each is a cut too. */
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

package wbv.signal;

import java.io.Serializable;

/**
 * How a signal is cut into overlapping Hann-windowed segments for averaging (Welch 1967).
 *
 * <p>A long segment resolves sharp resonances, many segments average noise away. What a resonance loses by a short segment is
 * known beforehand: see {@link #peakBias}.
 *
 * @param rate    sampling rate [Hz], &gt; 0
 * @param length  samples of a segment, a power of two, at least 8
 * @param overlap share of a segment that it has in common with the next, 0 to 0.9; 0.5 or more for Hann's window
 */
public record Segmentation(double rate, int length, double overlap) implements Serializable {

    public Segmentation {
        if (!(rate > 0) || Double.isInfinite(rate)) {
            throw new IllegalArgumentException("sampling rate must be > 0 Hz: " + rate);
        }
        if (length < 8 || Integer.bitCount(length) != 1) {
            throw new IllegalArgumentException("length of a segment must be a power of two >= 8: " + length);
        }
        if (!(overlap >= 0 && overlap <= 0.9)) {
            throw new IllegalArgumentException("overlap must be 0 to 0.9: " + overlap);
        }
    }

    /**
     * The shortest segmentation, overlapping by half, that lowers no resonance peak by more than a given part.
     *
     * @param rate      of the samples [Hz]
     * @param frequency lowest natural frequency to be resolved [Hz], &gt; 0
     * @param damping   its damping ratio, &gt; 0
     * @param bias      largest relative loss of the peak, such as 0.01
     */
    public static Segmentation resolving(double rate, double frequency, double damping, double bias) {
        if (!(frequency > 0) || !(damping > 0) || !(bias > 0)) {
            throw new IllegalArgumentException("frequency, damping and bias must be > 0: " + frequency + " Hz, " + damping
                    + ", " + bias);
        }
        int length = 8;
        while (-new Segmentation(rate, length, 0.5).peakBias(frequency, damping) > bias && length < 1 << 24) {
            length *= 2;
        }
        return new Segmentation(rate, length, 0.5);
    }

    /**
     * The resolution that a sitter's resonance needs, overlapping by half (4 Hz, damping ratio 0.3, peak lowered by 2 %), or, of a short
     * record, the longest segments of which enough are in it.
     *
     * @param rate of the samples [Hz]
     * @param samples of the record
     * @param enough segments
     * @param shortest that a segment may be made [samples]
     */
    public static Segmentation ofSitter(double rate, long samples, int enough, double shortest) {
        int length = resolving(rate, 4, 0.3, 0.02).length();
        while (length / 2 >= shortest && (enough + 1) * (long) length / 2 > samples) {
            length /= 2;
        }
        return new Segmentation(rate, length, 0.5);
    }

    /**
     * Segments that overlap by half and are as near to a length as a power of two of samples comes, as ratios go.
     *
     * @param duration [s]
     */
    public static Segmentation lasting(double rate, double duration) {
        if (!(duration > 0) || Double.isInfinite(duration)) {
            throw new IllegalArgumentException("length of a segment must be > 0 s: " + duration);
        }
        double wanted = duration * rate;
        int length = 8;
        while (length < wanted / Math.sqrt(2) && length < 1 << 24) {
            length *= 2;
        }
        return new Segmentation(rate, length, 0.5);
    }

    /** Samples from the start of a segment to the start of the next. */
    public int hop() {
        return Math.max(1, (int) Math.round(length * (1 - overlap)));
    }

    /** Length of a segment [s]. */
    public double duration() {
        return length / rate;
    }

    /** Number of bins from 0 Hz to half the sampling rate, both included. */
    public int bins() {
        return length / 2 + 1;
    }

    /** Frequency of a bin [Hz]. */
    public double frequency(int bin) {
        return bin * rate / length;
    }

    /** Frequencies of all bins [Hz]. */
    public double[] frequencies() {
        double[] frequencies = new double[bins()];
        for (int bin = 0; bin < frequencies.length; bin++) {
            frequencies[bin] = frequency(bin);
        }
        return frequencies;
    }

    /** Equivalent noise bandwidth of a bin [Hz]: 1.5 bins. */
    public double resolution() {
        return 1.5 * rate / length;
    }

    /**
     * Relative bias of |H1| at a resonance, to second order: {@code -1 / (3 (ζ f T)²)} for segments of T seconds.
     *
     * <p>The expected cross spectrum is the true one smoothed by the window's power: the impulse response multiplied by the
     * window's autocorrelation, {@code 1 - (2π²/3)(τ/T)² + …} for Hann. That adds {@code (2π²/3T²) H''(ω)}, and near a pole
     * {@code H = A/(ζω + j(ω-ω_d))} gives {@code H'' = -2H/(ζω)²} at the peak. Good while the result is above -0.1.
     *
     * @param frequency of the resonance [Hz]
     * @param damping its damping ratio ζ
     */
    public double peakBias(double frequency, double damping) {
        double product = damping * frequency * duration();
        return -1 / (3 * product * product);
    }

    /**
     * Number of independent segments that have the same variance as {@code segments} overlapping ones (Welch 1967):
     * {@code K / (1 + 2 Σ_m (1 - m/K) ρ_m²)}, ρ_m the window's correlation with itself m hops later.
     */
    public double independent(long segments) {
        if (segments == 0) {
            return 0;
        }
        Taper window = Taper.hann(length);
        double inflation = 1;
        for (int m = 1; m < segments && m * hop() < length; m++) {
            double correlation = window.correlation(m * hop());
            inflation += 2 * (1 - (double) m / segments) * correlation * correlation;
        }
        return segments / inflation;
    }
}

package wbv.signal;

import java.util.Arrays;

/** One channel cut into overlapping segments; the latest whole segment is detrended, windowed and transformed on demand. */
final class Segments {

    private final Taper window;
    private final Fft fft;
    private final Detrend detrend;
    private final int hop;
    private final double[] ring;
    private final double[] spectrum;
    private int head;
    private int untilSegment;
    private int sinceMissing;

    Segments(Segmentation segmentation, Detrend detrend) {
        this.window = Taper.hann(segmentation.length());
        this.fft = new Fft(segmentation.length());
        this.detrend = detrend;
        this.hop = segmentation.hop();
        this.ring = new double[segmentation.length()];
        this.spectrum = new double[segmentation.length()];
        reset();
    }

    /**
     * Takes a sample.
     *
     * @return whether it ends a segment
     */
    boolean accept(double value) {
        ring[head] = value;
        head = head + 1 == ring.length ? 0 : head + 1;
        sinceMissing = Double.isFinite(value) ? Math.min(sinceMissing + 1, ring.length) : 0;
        if (--untilSegment > 0) {
            return false;
        }
        untilSegment = hop;
        return true;
    }

    /** Whether the segment that just ended has no missing sample. */
    boolean whole() {
        return sinceMissing == ring.length;
    }

    /** Packed spectrum (see {@link Fft}) of the segment that just ended. Overwritten by the next call. */
    double[] spectrum() {
        System.arraycopy(ring, head, spectrum, 0, ring.length - head);
        System.arraycopy(ring, 0, spectrum, ring.length - head, head);
        detrend.apply(spectrum);
        window.apply(spectrum);
        fft.forward(spectrum);
        return spectrum;
    }

    /** Factor from |X_k|² to a one-sided power spectral density [unit²/Hz], for bins other than the first and the last. */
    static double densityScale(Segmentation segmentation) {
        return 2 / (segmentation.rate() * Taper.hann(segmentation.length()).power());
    }

    /**
     * Adds |X_k|² to a sum for each bin.
     *
     * @param power N/2 + 1 sums. Modified.
     */
    static void addPower(double[] packed, double[] power) {
        int last = packed.length / 2;
        power[0] += packed[0] * packed[0] / 2;
        power[last] += packed[1] * packed[1] / 2;
        for (int k = 1; k < last; k++) {
            power[k] += packed[2 * k] * packed[2 * k] + packed[2 * k + 1] * packed[2 * k + 1];
        }
    }

    /**
     * Adds Y_k X_k* to a sum for each bin.
     *
     * @param re N/2 + 1 real parts. Modified.
     * @param im as many imaginary parts. Modified.
     */
    static void addProduct(double[] y, double[] x, double[] re, double[] im) {
        int last = x.length / 2;
        re[0] += y[0] * x[0] / 2;
        re[last] += y[1] * x[1] / 2;
        for (int k = 1; k < last; k++) {
            double a = y[2 * k];
            double b = y[2 * k + 1];
            double c = x[2 * k];
            double d = x[2 * k + 1];
            re[k] += a * c + b * d;
            im[k] += b * c - a * d;
        }
    }

    void reset() {
        Arrays.fill(ring, 0);
        head = 0;
        untilSegment = ring.length;
        sinceMissing = 0;
    }
}

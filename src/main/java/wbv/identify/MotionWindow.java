package wbv.identify;

import java.util.Arrays;

/** The last samples of several channels, at most a number of them: what of a stream without an end is kept for a fit. */
public final class MotionWindow {

    private final double rate;
    private final int capacity;
    private final double[][] ring;
    private long samples;

    /**
     * An empty window.
     *
     * @param rate     [Hz], &gt; 0
     * @param channels number of channels, at least 1
     * @param capacity samples kept at most, at least 1
     */
    public MotionWindow(double rate, int channels, int capacity) {
        if (!(rate > 0) || channels < 1 || capacity < 1) {
            throw new IllegalArgumentException(
                    "a window needs a rate > 0 Hz, a channel and room: " + rate + ", " + channels + ", " + capacity);
        }
        this.rate = rate;
        this.capacity = capacity;
        this.ring = new double[channels][0];
    }

    /**
     * Takes a sample of each channel; NaN is missing.
     *
     * @param values one a channel, in its own unit. Not modified.
     */
    public void accept(double[] values) {
        int at = (int) (samples % capacity);
        if (at == ring[0].length) {
            int length = (int) Math.min(capacity, Math.max(1024L, 2L * at));
            for (int c = 0; c < ring.length; c++) {
                ring[c] = Arrays.copyOf(ring[c], length);
            }
        }
        for (int c = 0; c < ring.length; c++) {
            ring[c][at] = values[c];
        }
        samples++;
    }

    /** Samples per second [Hz]. */
    public double rate() {
        return rate;
    }

    /** Number of the first sample that is kept, from the beginning of the stream. */
    public long first() {
        return Math.max(0, samples - capacity);
    }

    /** Samples kept. */
    public int length() {
        return (int) Math.min(samples, capacity);
    }

    /** The series of a channel that is kept, in its own unit, oldest first. A copy. */
    public double[] channel(int channel) {
        double[] out = new double[length()];
        int from = (int) (first() % capacity);
        int tail = Math.min(out.length, ring[channel].length - from);
        System.arraycopy(ring[channel], from, out, 0, tail);
        System.arraycopy(ring[channel], 0, out, tail, out.length - tail);
        return out;
    }
}

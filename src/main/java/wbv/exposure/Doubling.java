package wbv.exposure;

import java.util.Arrays;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Twice the rate of a stream: its samples as they are, and between two of them what a low-pass filter of linear phase says that ends at
 * half the rate (a half-band filter, of which every other tap is zero).
 */
final class Doubling implements Snapshot {

    /** Edges of the transition as parts of the rate: 27 and 33 Hz of 60 Hz data. */
    private static final double PASSBAND = 0.45;
    private static final double STOPBAND = 0.55;
    private static final double ATTENUATION = 70;

    private final double[] taps;
    /** The last samples, twice, so that they always stand in one row from {@link #head} on. */
    private final double[] ring;
    private int head;

    Doubling() {
        this(BetweenValues.phases(2, PASSBAND, STOPBAND, ATTENUATION)[1]);
    }

    /** Another of the same filter, that has heard nothing. */
    Doubling fresh() {
        return new Doubling(taps);
    }

    private Doubling(double[] taps) {
        this.taps = taps;
        this.ring = new double[2 * taps.length];
    }

    /** Samples by which it is late. */
    int delay() {
        return taps.length / 2;
    }

    void settle(double value) {
        Arrays.fill(ring, value);
    }

    /**
     * Takes a sample.
     *
     * @param pair the sample of {@link #delay} ago and what lies between it and the next. Modified.
     */
    void step(double value, double[] pair) {
        int width = taps.length;
        ring[head] = value;
        ring[head + width] = value;
        head = head + 1 == width ? 0 : head + 1;
        // Four sums side by side: one would wait for each addition to end.
        double first = 0;
        double second = 0;
        double third = 0;
        double fourth = 0;
        int i = 0;
        for (; i + 3 < width; i += 4) {
            first += taps[i] * ring[head + i];
            second += taps[i + 1] * ring[head + i + 1];
            third += taps[i + 2] * ring[head + i + 2];
            fourth += taps[i + 3] * ring[head + i + 3];
        }
        for (; i < width; i++) {
            first += taps[i] * ring[head + i];
        }
        pair[0] = ring[head + width / 2 - 1];
        pair[1] = first + second + (third + fourth);
    }

    @Override
    public void save(StateWriter out) {
        out.put(ring, 0, taps.length); // the other half is the same
        out.put(head);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(ring, 0, taps.length);
        System.arraycopy(ring, 0, ring, taps.length, taps.length);
        head = in.integer(0, taps.length - 1, "a place in a filter");
    }
}

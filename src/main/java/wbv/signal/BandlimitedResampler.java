package wbv.signal;

import java.util.Arrays;
import java.util.function.DoubleConsumer;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Changes the rate of a stream by a ratio of whole numbers, keeping everything below a pass band and nothing above half the
 * lower of the two rates.
 *
 * <p>Output k belongs to the time of input {@code k · down / up}: there is no delay in the numbers, only in when they come (the
 * filter looks {@link #delay()} input samples ahead). Before the first sample the signal is taken as constant, and after the
 * last. A missing sample (NaN) makes the outputs within reach of it NaN.
 */
public final class BandlimitedResampler implements Snapshot {

    private final int up;
    private final int down;
    private final KaiserSinc filter;
    private final double[] ring;
    private final DoubleConsumer sink;
    private int head;
    private long pushed;
    private int phase;
    private double last;

    /** Pass band up to 0.4 of the lower rate, within 80 dB. */
    public BandlimitedResampler(int up, int down, DoubleConsumer sink) {
        this(up, down, 0.4, 80, sink);
    }

    /**
     * A resampler that has taken nothing yet.
     *
     * @param up          outputs for every {@code down} inputs, at least 1
     * @param down        at least 1
     * @param passband    edge of the pass band as a share of the lower rate, above 0 and below 0.5
     * @param attenuation of what lies above half the lower rate, and of the ripple below the pass band's edge [dB], 30 to 160
     * @param sink        takes the outputs in order
     */
    public BandlimitedResampler(int up, int down, double passband, double attenuation, DoubleConsumer sink) {
        if (up < 1 || down < 1) {
            throw new IllegalArgumentException("a ratio of rates needs whole numbers >= 1: " + up + " / " + down);
        }
        if (!(passband > 0 && passband < 0.5)) {
            throw new IllegalArgumentException("pass band must be 0 to 0.5 of the lower rate: " + passband);
        }
        if (!(attenuation >= 30 && attenuation <= 160)) {
            throw new IllegalArgumentException("attenuation must be 30 to 160 dB: " + attenuation);
        }
        int common = greatestCommonDivisor(up, down);
        this.up = up / common;
        this.down = down / common;
        double lower = Math.min(1, (double) up / down); // lower rate in units of the input's
        this.filter = new KaiserSinc(this.up, passband * lower, 0.5 * lower, attenuation);
        this.ring = new double[4 * filter.reach()];
        this.sink = sink;
    }

    private BandlimitedResampler(int up, KaiserSinc filter, DoubleConsumer sink) {
        this.up = up;
        this.down = 1;
        this.filter = filter;
        this.ring = new double[4 * filter.reach()];
        this.sink = sink;
    }

    /**
     * Raises the rate of a signal that is known to end below half of it: the filter need not be steep.
     *
     * @param up          outputs for every input, at least 1
     * @param passband    where the signal ends, as a share of its rate, above 0
     * @param stopband    share of its rate where its first image begins, or nothing is wanted any more, above the pass band, below 1
     * @param attenuation of what lies above, and of the ripple below the pass band's edge [dB], 30 to 160
     * @param sink        takes the outputs in order
     */
    public static BandlimitedResampler raising(int up, double passband, double stopband, double attenuation, DoubleConsumer sink) {
        if (up < 1) {
            throw new IllegalArgumentException("a rate is raised by a whole number >= 1: " + up);
        }
        if (!(passband > 0 && passband < stopband && stopband < 1)) {
            throw new IllegalArgumentException(
                    "pass band must be above 0 and below the stop band, that below 1: " + passband + ", " + stopband);
        }
        if (!(attenuation >= 30 && attenuation <= 160)) {
            throw new IllegalArgumentException("attenuation must be 30 to 160 dB: " + attenuation);
        }
        return new BandlimitedResampler(up, new KaiserSinc(up, passband, stopband, attenuation), sink);
    }

    /**
     * Another of the same ratio and filter, which they share, that has heard nothing.
     *
     * @param other takes its outputs
     */
    public BandlimitedResampler fresh(DoubleConsumer other) {
        return new BandlimitedResampler(this, other);
    }

    private BandlimitedResampler(BandlimitedResampler like, DoubleConsumer sink) {
        this.up = like.up;
        this.down = like.down;
        this.filter = like.filter;
        this.ring = new double[like.ring.length];
        this.sink = sink;
    }

    /**
     * A whole array at another rate: {@code ceil(length · up / down)} values, in the unit of the samples.
     *
     * @param samples series of any unit. Not modified.
     */
    public static double[] resample(double[] samples, int up, int down) {
        double[] out = new double[Math.toIntExact(((long) samples.length * up + down - 1) / down)];
        int[] filled = {0};
        BandlimitedResampler resampler = new BandlimitedResampler(up, down, value -> out[filled[0]++] = value);
        for (double sample : samples) {
            resampler.accept(sample);
        }
        resampler.finish();
        return out;
    }

    /** Takes the next sample, of any unit; gives on every output that can now be computed, in that unit. */
    public void accept(double value) {
        if (pushed == 0) {
            Arrays.fill(ring, value);
        }
        last = value;
        push(value);
    }

    /** Ends the stream: gives on the outputs that lay behind by the delay. Feed nothing afterwards. */
    public void finish() {
        for (int i = 0; i < filter.reach() && pushed > 0; i++) {
            push(last);
        }
    }

    /** Input samples that must follow before an output comes. */
    public int delay() {
        return filter.reach();
    }

    /** Sample n completes the outputs between samples n - reach and n - reach + 1. */
    private void push(double value) {
        int width = ring.length / 2;
        ring[head] = value; // twice, so that the latest samples always stand in one row from head on
        ring[head + width] = value;
        head = head + 1 == width ? 0 : head + 1;
        pushed++;
        if (pushed <= filter.reach()) {
            return;
        }
        for (; phase < up; phase += down) {
            sink.accept(weigh(filter.phase(phase)));
        }
        phase -= up;
    }

    /** Four sums side by side: one would wait for each addition to end. */
    private double weigh(double[] taps) {
        double first = 0;
        double second = 0;
        double third = 0;
        double fourth = 0;
        int i = 0;
        for (; i + 3 < taps.length; i += 4) {
            first += taps[i] * ring[head + i];
            second += taps[i + 1] * ring[head + i + 1];
            third += taps[i + 2] * ring[head + i + 2];
            fourth += taps[i + 3] * ring[head + i + 3];
        }
        for (; i < taps.length; i++) {
            first += taps[i] * ring[head + i];
        }
        return first + second + (third + fourth);
    }

    private static int greatestCommonDivisor(int a, int b) {
        return b == 0 ? a : greatestCommonDivisor(b, a % b);
    }

    @Override
    public void save(StateWriter out) {
        out.put(ring, 0, ring.length / 2); // the other half is the same
        out.put(head);
        out.put(pushed);
        out.put(phase);
        out.put(last);
    }

    @Override
    public void load(StateReader in) {
        int width = ring.length / 2;
        in.numbers(ring, 0, width);
        System.arraycopy(ring, 0, ring, width, width);
        head = in.integer(0, width - 1, "a place in a resampler");
        pushed = in.count();
        phase = in.integer(0, up * down, "a resampler's phase");
        last = in.number();
    }
}

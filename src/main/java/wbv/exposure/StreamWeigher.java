package wbv.exposure;

import java.util.Arrays;
import java.util.function.DoubleConsumer;
import wbv.signal.BandlimitedResampler;
import wbv.signal.GapBridge;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * A weighting for streams of any rate from 50 Hz: samples are raised band-limited to 800 Hz or more, where the biquads of the
 * bilinear transform follow the analog weighting within 0.4 % up to 25 Hz, and the statistics are taken there. Run at the
 * samples' own rate the same biquads would lose 69 % at 25 Hz of 60 Hz data.
 *
 * <p>They are raised in two steps (Crochiere and Rabiner, Multirate Digital Signal Processing, 1983, chapter 5): to twice the rate by
 * a filter that is as steep as it must be, and from there by one that need not be steep, since between what the signal has and its
 * first image there is nothing. That asks for a quarter of the products of one step.
 *
 * <p>The mean of the first second counts as having been there always, so that neither gravity nor a bias makes a transient.
 * Allocates nothing per sample.
 */
public final class StreamWeigher implements Weigher, Snapshot {

    private static final double WORKING_RATE = 800;
    /** Edge of the interpolator's pass band as a part of the rate: 27 Hz of 60 Hz data. */
    private static final double PASSBAND = 0.45;
    private static final double ATTENUATION = 60;
    /** At twice the rate the signal ends at a quarter, and its images begin at three; the second step adds nothing to the ripple of the first. */
    private static final double SIGNAL = 0.25;
    private static final double IMAGES = 0.75;
    private static final double SECOND_ATTENUATION = 75;
    /** Time over which the level is known that stands in for missing samples [s]. */
    private static final double MEMORY = 10;

    private final int factor;
    private final GapBridge bridge;
    private final double[] taps;
    private final double[] delayed;
    private final Cascade cascade;
    private final BandlimitedResampler twice;
    private final BandlimitedResampler further;
    private final DoubleConsumer sink;
    private final double[] lead;
    private final boolean[] missing;
    private final double remembered;
    private int leading;
    private int warmUp;
    private int newest;
    private int oldest;
    private int given;
    private int filtered;
    private double level;
    private double known;

    /**
     * @param rate   sampling rate [Hz]
     * @param boxcar true if a sample is the mean over the sampling period, so that its droop is undone
     * @param sink   takes the weighted values
     */
    public StreamWeigher(AnalogFilter filter, double rate, boolean boxcar, DoubleConsumer sink) {
        factor = factor(rate);
        bridge = new GapBridge(Weigher.longestBridge(rate));
        warmUp = bridge.delay();
        taps = boxcar ? Boxcar.taps() : new double[] {1};
        delayed = new double[taps.length];
        cascade = filter.cascade(rate * factor);
        further = BandlimitedResampler.raising(Math.max(1, factor / 2), SIGNAL, IMAGES, SECOND_ATTENUATION, this::weigh);
        twice = BandlimitedResampler.raising(2, PASSBAND, 0.5, ATTENUATION, further::accept);
        this.sink = sink;
        lead = new double[(int) Math.ceil(rate)];
        missing = new boolean[twice.delay() + further.delay() + taps.length + 2];
        remembered = MEMORY * rate;
    }

    /** Another of the same filters, which they share, that has heard nothing. @param sink takes its weighted values */
    StreamWeigher fresh(DoubleConsumer other) {
        return new StreamWeigher(this, other);
    }

    private StreamWeigher(StreamWeigher like, DoubleConsumer sink) {
        factor = like.factor;
        bridge = like.bridge.fresh();
        warmUp = bridge.delay();
        taps = like.taps;
        delayed = new double[taps.length];
        cascade = like.cascade.fresh();
        further = like.further.fresh(this::weigh);
        twice = like.twice.fresh(further::accept);
        this.sink = sink;
        lead = new double[like.lead.length];
        missing = new boolean[like.missing.length];
        remembered = like.remembered;
    }

    /** Weighted values for a sample at a rate [Hz]: one, or an even number. */
    static int factor(double rate) {
        double least = WORKING_RATE / rate - 1e-9;
        return least <= 1 ? 1 : 2 * (int) Math.ceil(least / 2);
    }

    @Override
    public int factor() {
        return factor;
    }

    @Override
    public void accept(double value) {
        double bridged = bridge.accept(value);
        if (warmUp > 0) {
            warmUp--;
        } else if (leading < lead.length) {
            lead[leading++] = bridged;
            if (leading == lead.length) {
                begin();
            }
        } else {
            present(bridged);
        }
    }

    private void begin() {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < leading; i++) {
            sum += Double.isNaN(lead[i]) ? 0 : lead[i];
            count += Double.isNaN(lead[i]) ? 0 : 1;
        }
        level = count == 0 ? 0 : sum / count;
        Arrays.fill(delayed, level);
        cascade.settle(level);
        for (int i = 0; i < leading; i++) {
            present(lead[i]);
        }
    }

    /** Takes a sample after the bridge: a missing one is flagged and stood in for by the level. */
    private void present(double value) {
        boolean absent = Double.isNaN(value);
        missing[newest] = absent;
        newest = newest + 1 == missing.length ? 0 : newest + 1;
        double x = absent ? level : value;
        if (!absent) {
            known = Math.min(known + 1, remembered);
            level += (x - level) / Math.max(known, lead.length); // the first second is known already
        }
        filtered(x);
    }

    private void filtered(double x) {
        if (taps.length == 1) {
            raise(x);
            return;
        }
        System.arraycopy(delayed, 1, delayed, 0, delayed.length - 1);
        delayed[delayed.length - 1] = x;
        if (filtered < Boxcar.reach()) {
            filtered++;
            return;
        }
        double sum = 0;
        for (int i = 0; i < taps.length; i++) {
            sum += taps[i] * delayed[i];
        }
        raise(sum);
    }

    private void raise(double x) {
        if (factor == 1) {
            weigh(x);
        } else {
            twice.accept(x);
        }
    }

    private void weigh(double value) {
        double weighted = cascade.step(value);
        sink.accept(missing[oldest] ? Double.NaN : weighted);
        if (++given == factor) {
            given = 0;
            oldest = oldest + 1 == missing.length ? 0 : oldest + 1;
        }
    }

    @Override
    public void finish() {
        for (int i = bridge.delay(); i > 0; i--) {
            accept(Double.NaN);
        }
        if (leading < lead.length) {
            begin();
        }
        for (int i = 0; i < filtered; i++) {
            filtered(level);
        }
        if (factor > 1) {
            twice.finish();
            further.finish();
        }
    }

    @Override
    public void save(StateWriter out) {
        out.put(bridge);
        out.put(warmUp);
        out.put(leading);
        if (warmUp == 0 && leading < lead.length) {
            out.put(lead, 0, leading);
        }
        out.put(missing);
        out.put(newest);
        out.put(oldest);
        out.put(given);
        out.put(filtered);
        out.put(level);
        out.put(known);
        if (taps.length > 1) {
            out.put(delayed);
        }
        out.put(cascade);
        out.put(twice);
        out.put(further);
    }

    @Override
    public void load(StateReader in) {
        in.part(bridge);
        warmUp = in.integer(0, bridge.delay(), "samples of a bridge");
        leading = in.integer(0, lead.length, "samples of the first second");
        if (warmUp == 0 && leading < lead.length) {
            in.numbers(lead, 0, leading);
        }
        in.flags(missing);
        newest = in.integer(0, missing.length - 1, "a place in a weigher");
        oldest = in.integer(0, missing.length - 1, "a place in a weigher");
        given = in.integer(0, factor, "values given");
        filtered = in.integer(0, Boxcar.reach(), "samples filtered");
        level = in.number();
        known = in.number();
        if (taps.length > 1) {
            in.numbers(delayed);
        }
        in.part(cascade);
        in.part(twice);
        in.part(further);
    }
}

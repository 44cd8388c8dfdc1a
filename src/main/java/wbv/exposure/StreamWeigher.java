package wbv.exposure;

import java.util.Arrays;
import wbv.signal.BandlimitedResampler;
import wbv.signal.GapBridge;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * A weighting for streams of any rate from 50 Hz. Samples are raised to twice their rate, where powers of the weighted signal, which ends
 * at a quarter of it, have the means that they have between the values; there a cascade of biquads that has the weighting's memory
 * (matched transform) and a {@link Correction} follow the analog weighting within 10⁻⁴ to nine tenths of what samples can hold. Where a
 * peak may lie between two values it is looked for. From {@value #WORKING_RATE} Hz on samples are weighted as they are, by the bilinear
 * transform.
 *
 * <p>The mean of the first second counts as having been there always, so that neither gravity nor a bias makes a transient.
 * Allocates nothing per sample.
 */
public final class StreamWeigher implements Weigher, Snapshot {

    private static final double WORKING_RATE = 800;
    /** Where the correction is no longer true, as a part of the rate. */
    private static final double BAND = 0.47;
    /** Where moduli of a cascade are true, as a part of the rate. */
    private static final double TRUE = 0.1;
    /** Time over which the level is known that stands in for missing samples [s]. */
    private static final double MEMORY = 10;
    private static final double[] NOTHING = {};

    private final int factor;
    private final int sections;
    private final GapBridge bridge;
    private final double[] taps;
    private final double[] delayed;
    private final Cascade cascade;
    private final Doubling doubling;
    private final double[] correction;
    private final BetweenValues between;
    private final Sink sink;
    private final double[] lead;
    /** Of samples whose values are still to come, the oldest at {@link #place}. */
    private final boolean[] missing;
    private final double remembered;
    /** The last values at twice the rate, in time order. */
    private final double[] raised;
    private final double[] pair = new double[2];
    private int leading;
    private int warmUp;
    private int place;
    private int taken;
    private double level;
    private double known;
    private double last;
    private double[] owed = NOTHING;

    /**
     * Designs the filter for a rate; nothing is weighted yet.
     *
     * @param rate   sampling rate [Hz]
     * @param boxcar true if a sample is the mean over the sampling period, so that its droop is undone
     * @param sink   takes the weighted values
     */
    public StreamWeigher(AnalogFilter filter, double rate, boolean boxcar, Sink sink) {
        factor = factor(rate);
        sections = filter.sections().size();
        bridge = new GapBridge(Weigher.longestBridge(rate));
        taps = boxcar ? Boxcar.taps() : new double[] {1};
        cascade = factor == 1 ? filter.cascade(rate) : filter.matched(factor * rate, TRUE * rate);
        doubling = new Doubling();
        correction = factor == 1 ? new double[] {1} : Correction.taps(filter, cascade, factor * rate, BAND * rate);
        between = new BetweenValues(between(rate));
        lead = new double[(int) Math.ceil(rate)];
        remembered = MEMORY * rate;
        warmUp = bridge.delay();
        delayed = new double[taps.length];
        missing = new boolean[delay() + 1];
        raised = new double[correction.length + 1];
        this.sink = sink;
    }

    /**
     * Another of the same filters, which they share, that has heard nothing.
     *
     * @param other takes its weighted values
     */
    StreamWeigher fresh(Sink other) {
        return new StreamWeigher(this, other);
    }

    private StreamWeigher(StreamWeigher like, Sink sink) {
        factor = like.factor;
        sections = like.sections;
        bridge = like.bridge.fresh();
        taps = like.taps;
        cascade = like.cascade.fresh();
        doubling = like.doubling.fresh();
        correction = like.correction;
        between = like.between.fresh();
        lead = new double[like.lead.length];
        remembered = like.remembered;
        warmUp = bridge.delay();
        delayed = new double[taps.length];
        missing = new boolean[like.missing.length];
        raised = new double[like.raised.length];
        this.sink = sink;
    }

    /** Weighted values for a sample at a rate [Hz]. */
    static int factor(double rate) {
        return WORKING_RATE / rate - 1e-9 <= 1 ? 1 : 2;
    }

    /** Steps from one value to the next in which a peak between them is looked for, at a rate [Hz]. */
    static int between(double rate) {
        double least = WORKING_RATE / rate - 1e-9;
        return least <= 1 ? 1 : (int) Math.ceil(least / 2);
    }

    /** Samples by which values come late, that of the bridge not counted. */
    private int delay() {
        return (taps.length == 1 ? 0 : Boxcar.reach()) + (factor == 1 ? 0 : raisedDelay());
    }

    /** Samples by which values at twice the rate come late: the taps of the correction stand about the present one. */
    private int raisedDelay() {
        return doubling.delay() + correction.length / 4;
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
        settle();
        for (int i = 0; i < leading; i++) {
            present(lead[i]);
        }
    }

    /** As if the level had always been there. */
    private void settle() {
        Arrays.fill(delayed, level);
        doubling.settle(level);
        Arrays.fill(raised, level);
        double gain = 0;
        for (double tap : correction) {
            gain += tap;
        }
        cascade.settle(gain * level);
        last = level;
    }

    /** Takes a sample after the bridge: a missing one is flagged and stood in for by the level. */
    private void present(double value) {
        boolean absent = Double.isNaN(value);
        double x = absent ? level : value;
        if (!absent) {
            known = Math.min(known + 1, remembered);
            level += (x - level) / Math.max(known, lead.length); // the first second is known already
        }
        take(x, absent);
    }

    private void take(double x, boolean absent) {
        last = x;
        missing[place] = absent;
        place = place + 1 == missing.length ? 0 : place + 1;
        double value = taps.length == 1 ? x : undrooped(x);
        if (factor == 1) {
            give(cascade.step(value), 0, false);
            return;
        }
        weigh(value);
        give(pair[0], pair[1], true);
    }

    private void weigh(double value) {
        doubling.step(value, pair);
        correct();
        cascade.step(pair);
    }

    private double undrooped(double x) {
        System.arraycopy(delayed, 1, delayed, 0, delayed.length - 1);
        delayed[delayed.length - 1] = x;
        double sum = 0;
        for (int i = 0; i < taps.length; i++) {
            sum += taps[i] * delayed[i];
        }
        return sum;
    }

    private void correct() {
        int length = correction.length;
        for (int i = 2; i <= length; i++) {
            raised[i - 2] = raised[i];
        }
        raised[length - 1] = pair[0];
        raised[length] = pair[1];
        double first = 0;
        double second = 0;
        for (int i = 0; i < length; i++) {
            first += correction[i] * raised[i];
            second += correction[i] * raised[i + 1];
        }
        pair[0] = first;
        pair[1] = second;
    }

    /** Gives the values of the oldest sample that waits on. */
    private void give(double first, double second, boolean two) {
        if (taken < missing.length - 1) {
            taken++; // what comes out is from before the first sample
            return;
        }
        boolean absent = missing[place];
        double one = absent ? Double.NaN : first;
        sink.accept(one);
        if (two) {
            double other = absent ? Double.NaN : second;
            sink.accept(other);
            between.hear(one, other, sink);
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
        for (int i = 1; i < missing.length; i++) {
            take(last, true);
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
        out.put(level);
        out.put(known);
        out.put(last);
        out.put(missing);
        out.put(place);
        out.put(taken);
        if (taps.length > 1) {
            out.put(delayed);
        }
        out.put(cascade);
        if (factor > 1) {
            out.put(doubling);
            out.put(raised);
            out.put(between);
        }
    }

    @Override
    public void load(StateReader in) {
        if (in.version() == 1) {
            loadFirst(in);
            return;
        }
        loadBeginning(in);
        level = in.number();
        known = in.number();
        last = in.number();
        in.flags(missing);
        place = in.integer(0, missing.length - 1, "a place in a weigher");
        taken = in.integer(0, missing.length - 1, "samples of a weigher");
        if (taps.length > 1) {
            in.numbers(delayed);
        }
        in.part(cascade);
        if (factor > 1) {
            in.part(doubling);
            in.numbers(raised);
            in.part(between);
        }
    }

    private void loadBeginning(StateReader in) {
        in.part(bridge);
        warmUp = in.integer(0, bridge.delay(), "samples of a bridge");
        leading = in.integer(0, lead.length, "samples of the first second");
        if (warmUp == 0 && leading < lead.length) {
            in.numbers(lead, 0, leading);
        }
    }

    /**
     * The first form, of when samples were raised to {@value #WORKING_RATE} Hz and weighted there. Its latest samples go through the
     * filters of today from the level on; what its longer filters had not given yet is {@linkplain #giveOwed owed}. Where nothing is raised
     * it goes on as it was.
     */
    private void loadFirst(StateReader in) {
        loadBeginning(in);
        int twice = BandlimitedResampler.raising(2, 0.45, 0.5, 60, value -> {}).delay();
        int further = BandlimitedResampler.raising(between.steps(), 0.25, 0.75, 75, value -> {}).delay();
        boolean[] flags = new boolean[twice + further + taps.length + 2];
        in.flags(flags);
        int newest = in.integer(0, flags.length - 1, "a place in a weigher");
        in.integer();
        in.integer();
        int undone = in.integer(0, Boxcar.reach(), "samples filtered");
        level = in.number();
        known = in.number();
        settle();
        if (taps.length > 1) {
            in.numbers(delayed);
        }
        double[] memory = new double[2 * sections];
        in.numbers(memory);
        double[] ring = new double[2 * twice];
        in.numbers(ring);
        int head = in.integer(0, ring.length - 1, "a place in a resampler");
        long pushed = in.count();
        in.integer();
        last = in.number();
        in.numbers(new double[2 * further]);
        in.integer();
        in.count();
        in.integer();
        in.number();
        if (factor == 1) {
            cascade.become(memory);
        } else if (pushed > 0) {
            long given = Math.max(0, 2 * (pushed - twice) - further);
            int late = raisedDelay();
            for (int i = 0; i < ring.length; i++) {
                weigh(ring[(head + i) % ring.length]);
                long sample = pushed - ring.length + i - late;
                if (sample >= 0 && 2 * sample + 1 >= given) {
                    int ago = (int) (pushed + undone - sample);
                    boolean absent = flags[Math.floorMod(newest - ago, flags.length)];
                    owe(2 * sample >= given, absent ? Double.NaN : pair[0]);
                    owe(true, absent ? Double.NaN : pair[1]);
                }
            }
        }
        long samples = pushed + undone;
        last = taps.length > 1 ? delayed[delayed.length - 1] : last;
        taken = (int) Math.min(missing.length - 1, samples);
        place = 0;
        for (int i = 1; i <= missing.length; i++) {
            missing[missing.length - i] = flags[(newest + 2 * flags.length - i) % flags.length];
        }
    }

    private void owe(boolean really, double value) {
        if (really) {
            owed = Arrays.copyOf(owed, owed.length + 1);
            owed[owed.length - 1] = value;
        }
    }

    /** Gives what a state of the first form had yet to give, once the one who takes it is loaded as well. */
    void giveOwed() {
        for (double value : owed) {
            sink.accept(value);
        }
        owed = NOTHING;
    }
}

package wbv.filter;

import java.io.Serializable;
import wbv.filter.model.Spec;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * How far an estimate really scatters, whatever its filter believes. A filter takes what its model leaves for white noise; what a
 * real body does beside one mode follows itself for seconds and knows the input, so that corrections add up where the filter
 * counts on their cancelling.
 *
 * <p>Over a batch of some seconds the moves D of a parameter and the factor C by which the filter forgets its error are known.
 * The error goes as {@code e ← C e + D'}, so that {@code V ← C² V + m}, where m is the mean of {@code D²} over the last batches.
 * With white innovations of the expected size V stays below the filter's own variance; sums over batches count their
 * correlation whatever its shape (batch means; the recursive form of White's sandwich, Econometrica 50, 1982). While a filter
 * is still learning, its gains shrink, and m is too large rather than too small.
 */
final class ObservedScatter implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final int length;
    private final double memory;
    private double variance;
    private double sum;
    private double left;
    private int samples;
    private double mean;
    private double batches;
    private double own;

    /** @param spec rate and adaptation */
    ObservedScatter(Spec spec) {
        this.length = (int) Math.max(1, Math.round(spec.adaptation().scatter().batch() * spec.rate()));
        this.memory = spec.adaptation().scatter().batches();
    }

    /** The parameter is known this well, and nothing of how it scatters. */
    void restart(double known) {
        variance = known;
        own = known;
        mean = 0;
        batches = 0;
        begin();
    }

    private void begin() {
        sum = 0;
        left = 1;
        samples = 0;
    }

    /**
     * Hears a sample that could tell about the parameter.
     *
     * @param move of the parameter since the last sample
     * @param before the filter's variance of it before the correction
     * @param after and after it
     */
    void hear(double move, double before, double after) {
        if (!(before > 0) || !Double.isFinite(move)) {
            return;
        }
        own = after;
        sum += move;
        left *= Math.min(1, after / before);
        samples++;
        if (samples < length) {
            return;
        }
        batches++;
        mean += (sum * sum - mean) / Math.min(batches, memory);
        variance = left * left * variance + mean;
        begin();
    }

    /**
     * Nothing was learned: what the parameter may have drifted adds to what is unknown of it.
     *
     * @param now the filter's variance
     */
    void miss(double now) {
        variance += Math.max(0, now - own);
        own = now;
    }

    /**
     * Variance of the parameter.
     *
     * @param filters the filter's own, which counts if it is more
     */
    double variance(double filters) {
        return Math.max(filters, variance);
    }

    @Override
    public void save(StateWriter out) {
        out.put(variance);
        out.put(sum);
        out.put(left);
        out.put(samples);
        out.put(mean);
        out.put(batches);
        out.put(own);
    }

    @Override
    public void load(StateReader in) {
        variance = in.number();
        sum = in.number();
        left = in.number();
        samples = in.integer();
        mean = in.number();
        batches = in.number();
        own = in.number();
    }
}

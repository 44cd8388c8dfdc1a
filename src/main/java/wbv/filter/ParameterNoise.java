package wbv.filter;

import java.io.Serializable;
import wbv.filter.model.Adaptation;
import wbv.filter.model.Spec;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Process noise of one parameter from how the filter has been correcting it: {@code q = μ² + σ²}, the second moment about
 * zero of the corrections {@code e = Kν} in the alarm's window.
 *
 * <p>For a consistent filter {@code E[e²]} is just what a correction takes from the variance, so that q = E[e²] would never
 * let it shrink: q is a share of it. It stays between the drift that is assumed and a cap.
 */
final class ParameterNoise implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final Adaptation.Wandering settings;
    private final double floor;
    private final double cap;
    private double moment;
    private long count;

    /**
     * @param drift assumed wandering [1/√s]
     * @param spec rate and adaptation
     */
    ParameterNoise(double drift, Spec spec) {
        this.settings = spec.adaptation().wandering();
        this.floor = drift * drift / spec.rate();
        this.cap = Math.max(floor, settings.most() * settings.most() / spec.rate());
    }

    void reset() {
        moment = 0;
        count = 0;
    }

    /**
     * Thesis: Eq. 4-24.
     *
     * @param correction e of this sample
     * @param width length of the alarm's window in samples
     */
    void learn(double correction, long width) {
        count++;
        moment += (correction * correction - moment) / Math.min(count, Math.max(settings.shortest(), width));
    }

    /** q for one sample in which nothing can be learned: the drift that is assumed. */
    double assumed() {
        return floor;
    }

    /** q for one sample. Thesis: Eq. 4-3. */
    double variance() {
        return Math.min(cap, Math.max(floor, settings.share() * moment));
    }

    @Override
    public void save(StateWriter out) {
        out.put(moment);
        out.put(count);
    }

    @Override
    public void load(StateReader in) {
        moment = in.number();
        count = in.count();
    }
}

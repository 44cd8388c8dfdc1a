package wbv.filter.model;

import java.io.Serializable;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** How strong the input of the last half second is beside its sensor's noise: from noise alone nothing can be learned. */
public final class ExcitationLevel implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final double noise;
    private final double least;
    private final MovingPower input;

    /**
     * Silence so far.
     *
     * @param spec rate, noise of the input's sensor and adaptation
     */
    public ExcitationLevel(Spec spec) {
        this.noise = spec.inputNoise();
        this.least = spec.adaptation().information().excited();
        this.input = new MovingPower(Math.max(1, (int) Math.round(spec.adaptation().information().excitationMemory() * spec.rate())));
    }

    /** Silence again. */
    public void reset() {
        input.reset();
    }

    /**
     * Takes a sample.
     *
     * @param u input, where an interval begins [m/s² or rad/s]
     */
    public void hear(double u) {
        input.hear(u);
    }

    /** Whether the input is so many times its noise that it excites anything. */
    public boolean excited() {
        return level() > least;
    }

    /** The input over its sensor's noise, r.m.s. both [1]. */
    public double level() {
        return Math.sqrt(input.power()) / noise;
    }

    @Override
    public void save(StateWriter out) {
        out.put(input);
    }

    @Override
    public void load(StateReader in) {
        in.part(input);
    }
}

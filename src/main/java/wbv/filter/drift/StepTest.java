package wbv.filter.drift;

import java.io.Serializable;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Hears a body become stiffer or softer where noise hides it: Page's test (Biometrika 1954) on the likelihood of a step of
 * {@value #STEP} in ln ω against none, {@code ±δ h ν/S - δ² h²/2S} a sample, h how much the output depends on ln ω. No test that
 * rings falsely once in e^{@value #LARGEST} samples hears it sooner on average by more than a little (Lorden, Annals of
 * Mathematical Statistics 1971), but it needs a time in proportion to the noise's power.
 */
public final class StepTest implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;
    private static final double STEP = 0.06;
    private static final double LARGEST = 10;
    /** |ν|/√S counts as this at most. */
    private static final double MOST = 3;
    /** A single sample says no more than this, so that no shock is a change. */
    private static final double MOST_AT_ONCE = 1;

    private double stiffer;
    private double softer;

    /** Forgets what it heard. */
    public void restart() {
        stiffer = 0;
        softer = 0;
    }

    /**
     * Hears a sample.
     *
     * @param normalised ν/√S [1], as many correlated samples count as one
     * @param slope      h/√S [1]
     * @return true if the body has changed
     */
    public boolean hear(double normalised, double slope) {
        double nu = Math.max(-MOST, Math.min(MOST, normalised));
        double cost = 0.5 * STEP * STEP * slope * slope;
        stiffer = Math.max(0, stiffer + limited(STEP * slope * nu - cost));
        softer = Math.max(0, softer + limited(-STEP * slope * nu - cost));
        return Math.max(stiffer, softer) > LARGEST;
    }

    private static double limited(double gain) {
        return Math.max(-MOST_AT_ONCE, Math.min(MOST_AT_ONCE, gain));
    }

    @Override
    public void save(StateWriter out) {
        out.put(stiffer);
        out.put(softer);
    }

    @Override
    public void load(StateReader in) {
        stiffer = in.number();
        softer = in.number();
    }
}

package wbv.filter.drift;

import java.io.Serializable;
import wbv.filter.model.Adaptation;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Hears a body become stiffer or softer where noise hides it: Page's test (Biometrika 1954) on the likelihood of a step of
 * δ in ln ω against none, {@code ±δ h ν/S - δ² h²/2S} a sample, h how much the output depends on ln ω. No test that
 * rings falsely once in so many samples hears it sooner on average by more than a little (Lorden, Annals of
 * Mathematical Statistics 1971), but it needs a time in proportion to the noise's power.
 */
public final class StepTest implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final Adaptation.Changes settings;
    private double stiffer;
    private double softer;

    /**
     * Nothing heard yet.
     *
     * @param settings which step, and how much evidence of it is enough
     */
    public StepTest(Adaptation.Changes settings) {
        this.settings = settings;
    }

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
        double step = settings.step();
        double most = settings.mostDeviation();
        double nu = Math.max(-most, Math.min(most, normalised));
        double cost = 0.5 * step * step * slope * slope;
        stiffer = Math.max(0, stiffer + limited(step * slope * nu - cost));
        softer = Math.max(0, softer + limited(-step * slope * nu - cost));
        return Math.max(stiffer, softer) > settings.stepEvidence();
    }

    private double limited(double gain) {
        return Math.max(-settings.mostAtOnce(), Math.min(settings.mostAtOnce(), gain));
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

package wbv.filter;

import wbv.filter.drift.ChangeTest;
import wbv.filter.drift.StepTest;
import wbv.filter.model.Adaptation;
import wbv.filter.model.Spec;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Tests on the innovations of a filter that does not expect changes. Page's test (Biometrika 1954) hears a change that is large
 * or plain within less time than a window needs: it sums the log likelihood ratio of innovations with several times
 * the variance over those expected. {@link StepTest} hears what noise hides from both.
 */
final class OwnInnovations implements ChangeTests {

    private static final long serialVersionUID = 1;

    private final Adaptation.Changes settings;
    private final double rate;
    private final StepTest step;
    /** Of a sample's log likelihood ratio: what ν²/S counts, and what a larger variance costs. */
    private final double share;
    private final double cost;
    private double sum;

    /** @param spec rate and adaptation */
    OwnInnovations(Spec spec) {
        this.settings = spec.adaptation().changes();
        this.rate = spec.rate();
        this.step = new StepTest(settings);
        this.share = 1 - 1 / settings.larger();
        this.cost = Math.log(settings.larger());
    }

    @Override
    public void restart() {
        forget();
    }

    @Override
    public void forget() {
        sum = 0;
        step.restart();
    }

    @Override
    public boolean listenEarly() {
        return false;
    }

    @Override
    public double nis(double own) {
        return own;
    }

    /** What a body of another kind leaves is no noise: it says nothing of a step. */
    @Override
    public ChangeTest hear(double nis, double normalised, double slope, OutputNoise noise) {
        sum = Math.max(0, sum + 0.5 * (Math.min(nis, settings.mostInSum()) * share - cost));
        boolean stepped = step.hear(normalised, noise.explainsLittle() ? 0 : slope);
        return stepped ? ChangeTest.STEP : sum > settings.largestSum() * rate ? ChangeTest.VARIANCE : ChangeTest.NONE;
    }

    @Override
    public boolean isOfTheBody(boolean rose) {
        return rose;
    }

    @Override
    public boolean deafAfterChange() {
        return true;
    }

    @Override
    public void save(StateWriter out) {
        out.put(sum);
        out.put(step);
    }

    @Override
    public void load(StateReader in) {
        sum = in.number();
        in.part(step);
    }
}

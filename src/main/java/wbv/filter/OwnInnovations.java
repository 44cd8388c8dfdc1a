package wbv.filter;

import wbv.filter.drift.ChangeTest;
import wbv.filter.drift.StepTest;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Tests on the innovations of a filter that does not expect changes. Page's test (Biometrika 1954) hears a change that is large
 * or plain within less time than a window needs: it sums the log likelihood ratio of innovations with {@value #LARGER} times
 * the variance over those expected. {@link StepTest} hears what noise hides from both.
 */
final class OwnInnovations implements ChangeTests {

    private static final long serialVersionUID = 1;
    private static final double LARGER = 4;
    /** ν²/S counts as this at most, so that no single shock is a change. */
    private static final double MOST_IN_SUM = 9;
    /** Page's sum at which the body has changed, for each second's worth of samples. */
    private static final double LARGEST_SUM = 0.4;

    private final double rate;
    private final StepTest step = new StepTest();
    private double sum;

    /** @param rate [Hz] */
    OwnInnovations(double rate) {
        this.rate = rate;
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
        sum = Math.max(0, sum + 0.5 * (Math.min(nis, MOST_IN_SUM) * (1 - 1 / LARGER) - Math.log(LARGER)));
        boolean stepped = step.hear(normalised, noise.explainsLittle() ? 0 : slope);
        return stepped ? ChangeTest.STEP : sum > LARGEST_SUM * rate ? ChangeTest.VARIANCE : ChangeTest.NONE;
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

package wbv.learn;

import com.github.javacliparser.FloatOption;
import moa.classifiers.core.driftdetection.AbstractChangeDetector;
import moa.core.ObjectRepository;
import moa.tasks.TaskMonitor;
import wbv.filter.drift.Adwin;

/**
 * wbv's own change detector for MOA: {@link Adwin}, which hears a fall of the mean as well as a rise; MOA's {@code ADWINChangeDetector}
 * hears rises alone.
 */
public class TwoSidedAdwin extends AbstractChangeDetector {

    private static final long serialVersionUID = 1;

    public final FloatOption deltaOption = new FloatOption("delta", 'd', "Probability of a false cut at one look.", Adwin.USUAL, 1e-12,
            0.999);

    private Adwin window;

    @Override
    public String getPurposeString() {
        return "The adaptive window of Bifet and Gavaldà, hearing rises and falls of the mean of values between 0 and 1.";
    }

    /** @param value in [0, 1] */
    @Override
    public void input(double value) {
        if (window == null) {
            resetLearning();
        }
        isChangeDetected = window.feed(value);
        estimation = window.mean();
    }

    @Override
    public void resetLearning() {
        super.resetLearning();
        window = new Adwin(deltaOption.getValue());
    }

    @Override
    protected void prepareForUseImpl(TaskMonitor monitor, ObjectRepository repository) {}

    @Override
    public void getDescription(StringBuilder out, int indent) {
        out.append(getPurposeString());
    }
}

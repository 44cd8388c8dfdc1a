package wbv.learn;

import moa.classifiers.core.driftdetection.ADWIN;
import wbv.filter.drift.Alarm;

/**
 * The adaptive window of Bifet and Gavaldà (SDM 2007) as MOA implements it, in both directions: it hears a fall of the mean as
 * well as a rise, and looks for one every 32 values.
 */
public final class AdwinAlarm implements Alarm {

    private static final long serialVersionUID = 1;

    private final double delta;
    private ADWIN window;

    /**
     * An empty window.
     *
     * @param delta probability of a false cut at one look, in (0, 1)
     */
    public AdwinAlarm(double delta) {
        if (!(delta > 0 && delta < 1)) {
            throw new IllegalArgumentException("delta must be in (0, 1): " + delta);
        }
        this.delta = delta;
        this.window = new ADWIN(delta);
    }

    @Override
    public boolean feed(double value) {
        return window.setInput(value);
    }

    @Override
    public long width() {
        return window.getWidth();
    }

    @Override
    public double mean() {
        return window.getWidth() == 0 ? 0 : window.getEstimation();
    }

    /** A new window: MOA's own reset has left state behind in past releases. */
    @Override
    public void reset() {
        window = new ADWIN(delta);
    }
}

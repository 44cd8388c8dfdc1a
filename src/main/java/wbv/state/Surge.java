package wbv.state;

import java.io.Serializable;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * By how much the mean acceleration changes from 0.15 s to the next 0.15 s [m/s²]: what carries a sitter along. Constant offsets
 * fall out, 2.5 Hz comes through with 1.4 times its amplitude, 5 to 8 Hz with less than half of it.
 */
final class Surge implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;
    private static final double STEP = 0.15;

    private final MovingMean recent;
    private final MovingMean before;

    Surge(double rate) {
        int samples = Math.max(1, (int) Math.round(STEP * rate));
        recent = new MovingMean(samples);
        before = new MovingMean(samples);
    }

    void clear() {
        recent.clear();
        before.clear();
    }

    /**
     * Takes a sample.
     *
     * @return the change, without its sign; NaN where too much is missing
     */
    double step(double acceleration) {
        before.add(recent.oldest());
        recent.add(acceleration);
        return Math.abs(recent.mean() - before.mean());
    }

    @Override
    public void save(StateWriter out) {
        out.put(recent);
        out.put(before);
    }

    @Override
    public void load(StateReader in) {
        in.part(recent);
        in.part(before);
    }
}

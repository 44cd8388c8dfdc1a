package wbv.filter;

import wbv.filter.drift.Alarm;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** Never cuts: for what does not rest on change detection. */
final class Silent implements Alarm {

    private static final long serialVersionUID = 1;
    private long width;

    @Override
    public boolean feed(double value) {
        width++;
        return false;
    }

    @Override
    public long width() {
        return width;
    }

    @Override
    public double mean() {
        return 0.5;
    }

    @Override
    public void reset() {
        width = 0;
    }

    @Override
    public void save(StateWriter out) {
        out.put(width);
    }

    @Override
    public void load(StateReader in) {
        width = in.count();
    }
}

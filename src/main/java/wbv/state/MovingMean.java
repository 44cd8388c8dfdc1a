package wbv.state;

import java.io.Serializable;
import java.util.Arrays;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * The last values of a stream and their mean; those that are missing do not count.
 *
 * <p>Values lie in a ring and are added up from its beginning, those of this turn as they come, so that a mean adds only what is left of
 * the turn before, and nothing that rounding does outlives the values.
 */
final class MovingMean implements Serializable, Snapshot {

    private static final long serialVersionUID = 2;

    private final double[] values;
    private int next;
    /** Of this turn. */
    private double sum;
    private int there;

    MovingMean(int samples) {
        values = new double[samples];
        clear();
    }

    void clear() {
        Arrays.fill(values, Double.NaN);
        next = 0;
        sum = 0;
        there = 0;
    }

    void add(double value) {
        there -= Double.isNaN(values[next]) ? 0 : 1;
        values[next] = value;
        if (!Double.isNaN(value)) {
            there++;
            sum += value;
        }
        if (++next == values.length) {
            next = 0;
            sum = 0;
        }
    }

    /** The value that the next one will push out. */
    double oldest() {
        return values[next];
    }

    /** NaN where all are missing. */
    double mean() {
        double all = sum;
        if (there == values.length) {
            for (int i = next; i < values.length; i++) {
                all += values[i];
            }
            return all / there;
        }
        for (int i = next; i < values.length; i++) {
            all += Double.isNaN(values[i]) ? 0 : values[i];
        }
        return all / there;
    }

    @Override
    public void save(StateWriter out) {
        out.put(values);
        out.put(next);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(values);
        next = in.integer(0, values.length - 1, "a place in a window");
        sum = 0;
        there = 0;
        for (int i = 0; i < values.length; i++) {
            boolean present = !Double.isNaN(values[i]);
            there += present ? 1 : 0;
            sum += present && i < next ? values[i] : 0;
        }
    }
}

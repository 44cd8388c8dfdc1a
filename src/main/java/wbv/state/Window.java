package wbv.state;

import java.io.Serializable;
import java.util.Arrays;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** The last values of a stream; those that are missing do not count. */
final class Window implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final double[] values;
    private int next;

    Window(int samples) {
        values = new double[samples];
        clear();
    }

    void clear() {
        Arrays.fill(values, Double.NaN);
        next = 0;
    }

    void add(double value) {
        values[next] = value;
        next = (next + 1) % values.length;
    }

    /** The value that the next one will push out. */
    double oldest() {
        return values[next];
    }

    /** NaN where all are missing. */
    double mean() {
        double sum = 0;
        int there = 0;
        for (double value : values) {
            if (!Double.isNaN(value)) {
                sum += value;
                there++;
            }
        }
        return sum / there;
    }

    /** NaN where all are missing. */
    double greatest() {
        double greatest = Double.NaN;
        for (double value : values) {
            greatest = Double.isNaN(value) || value <= greatest ? greatest : value;
        }
        return greatest;
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
    }
}

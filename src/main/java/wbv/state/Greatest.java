package wbv.state;

import java.io.Serializable;
import java.util.Arrays;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** The greatest of the last values of a stream, looked for anew where it has left; those that are missing do not count. */
final class Greatest implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final double[] values;
    private int next;
    private double greatest;

    Greatest(int samples) {
        values = new double[samples];
        clear();
    }

    void clear() {
        Arrays.fill(values, Double.NaN);
        next = 0;
        greatest = Double.NaN;
    }

    /**
     * Takes a value.
     *
     * @return the greatest; NaN where all are missing
     */
    double add(double value) {
        double leaves = values[next];
        values[next] = value;
        next = next + 1 == values.length ? 0 : next + 1;
        if (leaves == greatest && !(value >= greatest)) {
            look();
        } else if (!Double.isNaN(value) && !(value < greatest)) {
            greatest = value;
        }
        return greatest;
    }

    private void look() {
        greatest = Double.NaN;
        for (double value : values) {
            greatest = Double.isNaN(value) || value <= greatest ? greatest : value;
        }
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
        look();
    }
}

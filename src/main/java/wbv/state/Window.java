package wbv.state;

import java.io.Serializable;
import java.util.Arrays;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * The last values of a stream and their mean; those that are missing do not count.
 *
 * <p>Values lie in a ring. Those of this turn are added up as they come; what is left of the turn before is known from sums that are
 * made once a turn, from its end backwards. So a mean takes two additions however many values there are, and nothing that rounding
 * does outlives the values.
 */
final class Window implements Serializable, Snapshot {

    private static final long serialVersionUID = 2;

    private final double[] values;
    /** Of the turn before: sums from each place to the end. */
    private final double[] rest;
    private int next;
    private double sum;
    private int there;

    Window(int samples) {
        values = new double[samples];
        rest = new double[samples + 1];
        clear();
    }

    void clear() {
        Arrays.fill(values, Double.NaN);
        Arrays.fill(rest, 0);
        next = 0;
        sum = 0;
        there = 0;
    }

    void add(double value) {
        double leaves = values[next];
        there -= leaves == leaves ? 1 : 0;
        values[next] = value;
        if (value == value) {
            there++;
            sum += value;
        }
        if (++next == values.length) {
            turn();
        }
    }

    private void turn() {
        next = 0;
        sum = 0;
        sumRest();
    }

    private void sumRest() {
        for (int i = values.length - 1; i >= next; i--) {
            double value = values[i];
            rest[i] = rest[i + 1] + (value == value ? value : 0);
        }
    }

    /** The value that the next one will push out. */
    double oldest() {
        return values[next];
    }

    /** NaN where all are missing. */
    double mean() {
        return there == 0 ? Double.NaN : (sum + rest[next]) / there;
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
        sumRest();
        sum = 0;
        there = 0;
        for (int i = 0; i < values.length; i++) {
            double value = values[i];
            boolean present = value == value;
            there += present ? 1 : 0;
            sum += present && i < next ? value : 0;
        }
    }
}

package wbv.live;

import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Rows of several sensors of one seat, each with some of its channels, made whole rows by their times: the sensors keep one clock. A
 * row waits until all of them have brought theirs, a quarter of a second at most.
 */
final class Joiner {

    /** Time that a row waits for the other sensors [s]. */
    private static final double WAIT = 0.25;

    private final double rate;
    private final int sensors;
    private final double[][] rows;
    private final int[] brought;
    private final boolean[] open;
    private double origin = Double.NaN;
    private long first;
    private long newest;

    /**
     * @param rate of each [Hz]
     * @param width of a whole row, the time with it
     * @param sensors how many there are
     */
    Joiner(double rate, int width, int sensors) {
        this.rate = rate;
        this.sensors = sensors;
        rows = new double[Math.max(4, (int) Math.ceil(WAIT * rate)) + 1][width];
        brought = new int[rows.length];
        open = new boolean[rows.length];
    }

    /**
     * Takes a part of a row.
     *
     * @param part values by channel, the time first; NaN where they are another sensor's. Not kept.
     * @param whole takes rows that are whole or have waited, in order
     */
    void accept(double[] part, Consumer<double[]> whole) {
        long slot = Double.isNaN(origin) ? 0 : Math.round((part[0] - origin) * rate);
        if (Double.isNaN(origin) || slot < first - rows.length || slot > newest + 60 * rate) {
            flush(whole);
            origin = part[0];
            slot = 0;
            first = 0;
            newest = 0;
        }
        if (slot < first) {
            whole.accept(part); // too late to be joined: the clock says so
            return;
        }
        newest = Math.max(newest, slot);
        while (newest - first >= rows.length) {
            give(whole);
        }
        int at = (int) (slot % rows.length);
        if (!open[at]) {
            open[at] = true;
            brought[at] = 0;
            Arrays.fill(rows[at], Double.NaN);
            rows[at][0] = part[0];
        }
        for (int i = 1; i < part.length; i++) {
            rows[at][i] = Double.isNaN(part[i]) ? rows[at][i] : part[i];
        }
        brought[at]++;
        while (first <= newest && brought[(int) (first % rows.length)] >= sensors && open[(int) (first % rows.length)]) {
            give(whole);
        }
    }

    private void give(Consumer<double[]> whole) {
        int at = (int) (first % rows.length);
        first++;
        if (open[at]) {
            open[at] = false;
            whole.accept(rows[at]);
        }
    }

    /** Gives what waits. */
    void flush(Consumer<double[]> whole) {
        while (first <= newest && !Double.isNaN(origin)) {
            give(whole);
        }
    }
}

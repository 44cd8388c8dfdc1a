package wbv.filter.drift;

import java.util.Arrays;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * The adaptive window of Bifet and Gavaldà (Learning from time-changing data with adaptive windowing, SDM 2007), its decisions
 * and its window those of MOA's {@code ADWIN} number for number (under test), in flat arrays that can be saved: a window whose
 * older part has another mean than its younger part loses its oldest values until no cut is left.
 *
 * <p>Values are kept in an exponential histogram: row r holds at most {@value #MOST} buckets of 2^r values, the oldest first. Every
 * {@value #CLOCK} values all places between buckets are looked at; at a cut the bound is {@code ε = √(2 m σ² d) + ⅔ m d}, with
 * {@code d = ln(2 ln n / δ)} and {@code m = 1/(n₀ - 4) + 1/(n₁ - 4)}.
 */
public final class Adwin implements Alarm {

    private static final long serialVersionUID = 1;
    /** Probability of a false cut at one look, as usual. */
    public static final double USUAL = 0.002;
    private static final int CLOCK = 32;
    private static final int MOST = 5;
    private static final int WIDTH = MOST + 1;
    private static final int SHORTEST_WINDOW = 10;
    private static final int SHORTEST_PART = 5;
    /** 2^31 values: MOA's own counts end there. */
    private static final int ROWS = 32;

    private final double delta;
    private final double[] totals = new double[ROWS * WIDTH];
    private final double[] variances = new double[ROWS * WIDTH];
    private final int[] buckets = new int[ROWS];
    private int last;
    private int time;
    private int width;
    private double total;
    private double variance;

    /** With the {@link #USUAL} δ. */
    public Adwin() {
        this(USUAL);
    }

    /**
     * An empty window.
     *
     * @param delta probability of a false cut at one look, in (0, 1)
     */
    public Adwin(double delta) {
        if (!(delta > 0 && delta < 1)) {
            throw new IllegalArgumentException("delta must be in (0, 1): " + delta);
        }
        this.delta = delta;
    }

    @Override
    public void reset() {
        Arrays.fill(totals, 0);
        Arrays.fill(variances, 0);
        Arrays.fill(buckets, 0);
        last = 0;
        time = 0;
        width = 0;
        total = 0;
        variance = 0;
    }

    @Override
    public long width() {
        return width;
    }

    @Override
    public double mean() {
        return width == 0 ? 0 : total / width;
    }

    @Override
    public boolean feed(double value) {
        time++;
        insert(value);
        boolean cut = false;
        if (time % CLOCK == 0 && width > SHORTEST_WINDOW) {
            while (cuts()) {
                cut = true;
                deleteOldest();
            }
        }
        return cut;
    }

    private void insert(double value) {
        width++;
        push(0, value, 0);
        if (width > 1) {
            double off = value - total / (width - 1);
            variance += (width - 1) * off * off / width;
        }
        total += value;
        compress();
    }

    private void push(int row, double sum, double spread) {
        int at = row * WIDTH + buckets[row]++;
        totals[at] = sum;
        variances[at] = spread;
    }

    /** Drops the first buckets of a row. */
    private void drop(int row, int count) {
        int at = row * WIDTH;
        int left = buckets[row] - count;
        System.arraycopy(totals, at + count, totals, at, left);
        System.arraycopy(variances, at + count, variances, at, left);
        Arrays.fill(totals, at + left, at + buckets[row], 0);
        Arrays.fill(variances, at + left, at + buckets[row], 0);
        buckets[row] = left;
    }

    /** Two buckets of a row that is full become one of the next. */
    private void compress() {
        for (int row = 0; row <= last && buckets[row] == WIDTH; row++) {
            last = Math.max(last, row + 1);
            double size = size(row);
            int at = row * WIDTH;
            double apart = totals[at] / size - totals[at + 1] / size;
            double between = size * size * apart * apart / (size + size);
            push(row + 1, totals[at] + totals[at + 1], variances[at] + variances[at + 1] + between);
            drop(row, 2);
        }
    }

    private void deleteOldest() {
        double size = size(last);
        double sum = totals[last * WIDTH];
        width -= (int) size;
        total -= sum;
        double off = sum / size - total / width;
        variance -= variances[last * WIDTH] + size * width * off * off / (size + width);
        drop(last, 1);
        if (buckets[last] == 0) {
            last--;
        }
    }

    /** Whether the window has two parts of different means, somewhere. */
    private boolean cuts() {
        int older = 0;
        int younger = width;
        double olderSum = 0;
        double youngerSum = total;
        for (int row = last; row >= 0; row--) {
            int size = (int) size(row);
            for (int k = 0; k < buckets[row]; k++) {
                double sum = totals[row * WIDTH + k];
                older += size;
                younger -= size;
                olderSum += sum;
                youngerSum -= sum;
                if (row == 0 && k == buckets[row] - 1) {
                    return false;
                }
                if (younger > SHORTEST_PART + 1 && older > SHORTEST_PART + 1
                        && Math.abs(olderSum / older - youngerSum / younger) > bound(older, younger)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Bound of ADWIN on the difference of two means. Thesis: Eq. 4-20, 4-21. */
    private double bound(int older, int younger) {
        double d = Math.log(2 * Math.log(width) / delta);
        double m = 1.0 / (older - SHORTEST_PART + 1) + 1.0 / (younger - SHORTEST_PART + 1);
        return Math.sqrt(2 * m * (variance / width) * d) + 2.0 / 3 * d * m;
    }

    private static double size(int row) {
        return 1L << row;
    }

    @Override
    public void save(StateWriter out) {
        out.put(last);
        out.put(time);
        out.put(width);
        out.put(total);
        out.put(variance);
        for (int row = 0; row <= last; row++) {
            out.put(buckets[row]);
            out.put(totals, row * WIDTH, row * WIDTH + buckets[row]);
            out.put(variances, row * WIDTH, row * WIDTH + buckets[row]);
        }
    }

    @Override
    public void load(StateReader in) {
        reset();
        last = in.integer(0, ROWS - 1, "rows of a window");
        time = in.integer();
        width = in.integer();
        total = in.number();
        variance = in.number();
        for (int row = 0; row <= last; row++) {
            buckets[row] = in.integer(0, MOST, "buckets of a window's row");
            in.numbers(totals, row * WIDTH, row * WIDTH + buckets[row]);
            in.numbers(variances, row * WIDTH, row * WIDTH + buckets[row]);
        }
    }
}

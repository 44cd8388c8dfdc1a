package wbv.recording.inspect;

import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
import wbv.recording.Channel;

/**
 * Some rows of a recording at a time, so that whatever looks at them works side by side, each on all of them in their order. What comes
 * out is the same on any number of cores.
 */
public final class RowBlock {

    /** Eight seconds and a half at 60 Hz. */
    private static final int ROWS = 512;

    private final double[][] rows;
    private int count;

    /**
     * Without rows yet.
     *
     * @param columns of a row, with that of time [1]
     */
    public RowBlock(int columns) {
        rows = new double[ROWS][columns];
    }

    /** Takes the next rows in place of these; whether there was one. */
    public boolean read(UniformReader reader) throws IOException {
        count = 0;
        while (count < ROWS && reader.read(rows[count])) {
            count++;
        }
        return count > 0;
    }

    /** Number of rows. */
    public int count() {
        return count;
    }

    /** The row of an index, as long as there are columns: time from the first sample [s], then channels in their units. Not a copy. */
    public double[] row(int index) {
        return rows[index];
    }

    /** Shows every row to each of them. */
    public void show(List<Consumer<RowBlock>> all) {
        all.parallelStream().forEach(each -> each.accept(this));
    }

    /** What is shown rows one by one. */
    public static Consumer<RowBlock> each(Consumer<double[]> taker) {
        return block -> {
            for (int i = 0; i < block.count; i++) {
                taker.accept(block.rows[i]);
            }
        };
    }

    /** What is shown some channels of each row, in this order; the array is used again for the next. */
    public static Consumer<RowBlock> each(UniformReader reader, List<Channel> channels, Consumer<double[]> taker) {
        int[] columns = channels.stream().mapToInt(channel -> column(reader, channel)).toArray();
        double[] values = new double[columns.length];
        return each(row -> {
            for (int i = 0; i < columns.length; i++) {
                values[i] = row[columns[i]];
            }
            taker.accept(values);
        });
    }

    /** Where a channel stands in a row [1]. */
    public static int column(UniformReader reader, Channel channel) {
        return 1 + reader.channels().indexOf(channel);
    }
}

package wbv.recording.inspect;

import java.util.Arrays;

/**
 * Every 2^k-th row of a recording, with k so that there are a few thousand however long it is: enough for medians, always the
 * same.
 */
final class ThinnedRows {

    /** Rows of a recording. */
    static final int MOST = 4096;

    private final double[][] columns;
    private final int most;
    private int held;
    private long stride = 1;
    private long seen;

    /** @param most rows held, even */
    ThinnedRows(int channels, int most) {
        this.most = most;
        columns = new double[channels][most];
    }

    /** @param row time, then the channels */
    void accept(double[] row) {
        if (seen++ % stride != 0) {
            return;
        }
        if (held == most) {
            for (double[] column : columns) {
                for (int i = 0; i < most / 2; i++) {
                    column[i] = column[2 * i];
                }
            }
            held = most / 2;
            stride *= 2;
            if ((seen - 1) % stride != 0) {
                return;
            }
        }
        for (int i = 0; i < columns.length; i++) {
            columns[i][held] = row[1 + i];
        }
        held++;
    }

    /** Median of a channel without its missing samples; NaN if none is left. */
    double median(int channel) {
        double[] sorted = Arrays.stream(columns[channel], 0, held).filter(x -> !Double.isNaN(x)).sorted().toArray();
        int n = sorted.length;
        return n == 0 ? Double.NaN : (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
    }
}

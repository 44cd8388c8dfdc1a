package wbv.recording.inspect;

import java.io.IOException;
import wbv.recording.RowReader;

/** The rows of a reader in order of time, without those that are out of order or stand twice, and how many were left out. */
final class OrderedRows {

    private final RowReader rows;
    private final Order order = new Order();
    private double[] present;
    private double[] following;
    private boolean begun;
    private boolean more;
    private long read;
    private long repeated;
    private long disordered;

    /** @param width of a row */
    OrderedRows(RowReader rows, int width) {
        this.rows = rows;
        this.present = new double[width];
        this.following = new double[width];
    }

    /** Fills in the next row; false at the end. */
    boolean next(double[] row) throws IOException {
        if (!begun) {
            begun = true;
            more = rows.read(following);
            read += more ? 1 : 0;
        }
        while (more) {
            double[] swap = present;
            present = following;
            following = swap;
            advance();
            if (order.keeps(present[0], more ? following[0] : Double.POSITIVE_INFINITY)) {
                System.arraycopy(present, 0, row, 0, row.length);
                return true;
            }
            disordered++;
        }
        return false;
    }

    private void advance() throws IOException {
        do {
            more = rows.read(following);
            read += more ? 1 : 0;
            repeated += more && same() ? 1 : 0;
        } while (more && same());
    }

    private boolean same() {
        return present[0] == following[0] && RowComparison.same(present, following);
    }

    long read() {
        return read;
    }

    long repeated() {
        return repeated;
    }

    long disordered() {
        return disordered;
    }
}

package wbv.recording.inspect;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.RowReader;

/**
 * Rows laid on the uniform clock that an {@link Inspection} found, as a stream with flat memory. Where the times are even but
 * for rounding, every row becomes the sample it was meant to be, untouched; where they jitter, samples are interpolated between
 * rows. Samples that the file lacks are rows of NaN, rows that repeat a time or run backwards are left out.
 */
public final class UniformReader implements RowReader {

    /** A file whose holes would be more than this many times its rows has a wrong time somewhere. */
    private static final long MOST_FILLED = 20;

    private final RowReader rows;
    private final Clock clock;
    private final Laying laying;
    private long sample;

    /**
     * Lays rows from their beginning on; closes them where it refuses them.
     *
     * @throws DataFault if the rows have two clocks, or nearly all of the clock's samples are holes
     */
    public UniformReader(RowReader rows, Inspection inspection) throws IOException {
        this.rows = rows;
        this.clock = inspection.clock();
        for (Finding finding : inspection.findings()) {
            if (finding instanceof Finding.TwoClocks two) {
                rows.close();
                throw DataFault.in(inspection.name(), two.message() + "; " + two.advice());
            }
        }
        if (inspection.samples() > MOST_FILLED * (inspection.rows() + 1000)) {
            rows.close();
            throw DataFault.in(inspection.name(), inspection.rows() + " rows are spread over " + inspection.samples()
                    + " samples; a time in the file must be wrong" + longest(inspection));
        }
        int width = 1 + rows.channels().size();
        this.laying = inspection.timing().irregular() ? new Interpolation(rows, clock, width)
                : new Snapping(rows, new Tracker(inspection.timing()), width);
    }

    /** Where the time jumps most. */
    private static String longest(Inspection inspection) {
        for (Finding finding : inspection.findings()) {
            if (finding instanceof Finding.Gap || finding instanceof Finding.DroppedPackets) {
                return ": " + finding.message();
            }
        }
        return "";
    }

    /** How rows become samples. */
    sealed interface Laying permits Snapping, Interpolation {
        /** Fills in the channels of the next sample; false at the end. */
        boolean next(double[] row) throws IOException;

        Relay relay(long samples);
    }

    /** The clock that the samples are on. */
    public Clock clock() {
        return clock;
    }

    /** What was done up to now. */
    public Relay relay() {
        return laying.relay(sample);
    }

    @Override
    public List<Channel> channels() {
        return rows.channels();
    }

    @Override
    public Metadata metadata() {
        return rows.metadata();
    }

    @Override
    public boolean read(double[] row) throws IOException {
        if (!laying.next(row)) {
            return false;
        }
        row[0] = clock.time(sample++);
        return true;
    }

    @Override
    public long line() {
        return rows.line();
    }

    @Override
    public double fractionRead() {
        return rows.fractionRead();
    }

    @Override
    public void close() throws IOException {
        rows.close();
    }

    /** Every row is one sample; the tracker says which. */
    static final class Snapping implements Laying {
        private final OrderedRows rows;
        private final Tracker tracker;
        private final double[] ahead;
        private long pending;
        private long filled;
        private long taken;

        private Snapping(RowReader rows, Tracker tracker, int width) {
            this.rows = new OrderedRows(rows, width);
            this.tracker = tracker;
            this.ahead = new double[width];
        }

        @Override
        public boolean next(double[] row) throws IOException {
            while (pending == 0) {
                if (!rows.next(ahead)) {
                    return false;
                }
                pending = tracker.place(ahead[0]);
                taken += pending == Tracker.REPEATED ? 1 : 0;
            }
            pending--;
            if (pending > 0) {
                filled++;
                Arrays.fill(row, Double.NaN);
            } else {
                System.arraycopy(ahead, 0, row, 0, row.length);
            }
            return true;
        }

        @Override
        public Relay relay(long samples) {
            return new Relay(rows.read(), samples, filled, rows.repeated() + taken, rows.disordered(), 0);
        }
    }
}

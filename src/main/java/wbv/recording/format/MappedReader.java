package wbv.recording.format;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import wbv.recording.CalendarTime;
import wbv.recording.Channel;
import wbv.recording.Metadata;
import wbv.recording.RowReader;
import wbv.recording.Unit;

/** A table: cells brought to SI by the units that its map, its header or its sidecar gives them. */
final class MappedReader implements RowReader {

    private final SlotRows rows;
    private final List<Channel> channels;
    private final Unit[] units;
    private final ColumnMap.Time time;
    private final Metadata metadata;
    private double zero = Double.NaN;
    private long count;

    /** @param rows in the slots of these columns */
    MappedReader(SlotRows rows, MappedColumns columns, ColumnMap.Time time, Metadata metadata) {
        this.rows = rows;
        this.channels = columns.channels();
        this.units = columns.units().clone();
        this.time = time;
        this.metadata = time.rate().isPresent() && metadata.rate().isEmpty() ? metadata.withRate(time.rate()) : metadata;
    }

    @Override
    public List<Channel> channels() {
        return channels;
    }

    @Override
    public Metadata metadata() {
        return metadata;
    }

    @Override
    public boolean read(double[] row) throws IOException {
        if (!rows.read(row)) {
            return false;
        }
        if (time.rate().isPresent()) {
            row[0] = count / time.rate().getAsDouble();
        }
        count++;
        if (Double.isNaN(row[0])) {
            throw rows.fault("the row has no time; every row needs one");
        }
        if (rows.origin().isPresent() && units[0].toSi(1) != 1) {
            throw rows.fault("dates and times stand in the column of times, to which no unit and no scale is given");
        }
        for (int i = 0; i < units.length; i++) {
            row[i] = units[i].toSi(row[i]);
        }
        if (time.fromZero()) {
            zero = Double.isNaN(zero) ? row[0] : zero;
            row[0] -= zero;
        }
        return true;
    }

    @Override
    public Optional<CalendarTime> origin() {
        return rows.origin();
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
}

package wbv.recording.format;

import java.io.IOException;
import java.util.List;
import wbv.recording.Channel;
import wbv.recording.Metadata;
import wbv.recording.RowReader;
import wbv.recording.Unit;

/** A foreign table: cells brought to SI by the units that its map gives them. */
final class MappedReader implements RowReader {

    private final Table table;
    private final List<Channel> channels;
    private final Unit[] units;
    private final ColumnMap.Time time;
    private final Metadata metadata;
    private double zero = Double.NaN;
    private long rows;

    /** @param units by slot of a row, the time's first */
    MappedReader(Table table, List<Channel> channels, Unit[] units, ColumnMap.Time time, Metadata metadata) {
        this.table = table;
        this.channels = channels;
        this.units = units.clone();
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
        if (!table.read(row)) {
            return false;
        }
        if (time.rate().isPresent()) {
            row[0] = rows / time.rate().getAsDouble();
        }
        rows++;
        if (Double.isNaN(row[0])) {
            throw table.fault("the row has no time; every row needs one");
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
    public long line() {
        return table.line();
    }

    @Override
    public double fractionRead() {
        return table.fractionRead();
    }

    @Override
    public void close() throws IOException {
        table.close();
    }
}

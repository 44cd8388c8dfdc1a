package wbv.recording.format;

import java.io.IOException;
import java.util.List;
import wbv.recording.Channel;
import wbv.recording.Metadata;
import wbv.recording.RowReader;

/** A table whose columns are the time and the channels, in SI already. */
final class TableReader implements RowReader {

    private final DelimitedTable table;
    private final List<Channel> channels;
    private final Metadata metadata;
    TableReader(DelimitedTable table, List<Channel> channels, Metadata metadata) {
        this.table = table;
        this.channels = List.copyOf(channels);
        this.metadata = metadata;
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
        if (Double.isNaN(row[0])) {
            throw table.fault("the row has no time; every row needs one");
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

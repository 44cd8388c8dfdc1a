package wbv.recording.inspect;

import java.io.IOException;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleConsumer;
import wbv.recording.BoundedReader;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.recording.RowReader;

/** What a recording can be read from, as often as needed, each time from the beginning: a file, or several files joined. */
public interface RowSource {

    /**
     * Opens the rows.
     *
     * @throws DataFault if the file is missing, is no recording, or its head is wrong
     */
    RowReader open() throws IOException;

    /**
     * Opens the rows for use: those of {@link #open}, whose every value some sensor could have measured.
     *
     * @throws DataFault as {@link #open}, and while reading at a value or a time beyond all measure
     */
    default RowReader bounded() throws IOException {
        return new BoundedReader(open(), toString());
    }

    /** Reads everything once and says what is there and what is wrong with it. Memory does not grow with the length. */
    default Inspection inspect() throws IOException {
        return inspect(fraction -> {});
    }

    /**
     * As {@link #inspect()}, telling how far it is.
     *
     * @param progress called now and then with the share read, 0 to 1, or NaN where that is unknown
     * @throws DataFault if a row is not one, there are fewer than two, or their times look to be in another unit than seconds
     */
    default Inspection inspect(DoubleConsumer progress) throws IOException {
        try (RowReader reader = bounded()) {
            Inspector inspector = new Inspector(toString(), reader);
            double[] row = new double[1 + reader.channels().size()];
            for (long rows = 1; reader.read(row); rows++) {
                inspector.accept(row, reader.line());
                if (rows % 4096 == 0) {
                    progress.accept(reader.fractionRead());
                }
            }
            Inspection seen = inspector.finish();
            SuspectTimes.check(seen, reader.metadata());
            return seen;
        }
    }

    /**
     * Opens the rows on the uniform clock that the inspection found.
     *
     * @throws DataFault if the rows have two clocks
     */
    default UniformReader uniform(Inspection inspection) throws IOException {
        return new UniformReader(bounded(), inspection);
    }

    /**
     * The whole recording in memory, on its uniform clock.
     *
     * @throws DataFault if it does not fit, or cannot be read
     */
    default Recording load() throws IOException {
        return load(inspect());
    }

    /** As {@link #load()}, with an inspection at hand. */
    default Recording load(Inspection inspection) throws IOException {
        try (UniformReader reader = uniform(inspection)) {
            List<Channel> channels = reader.channels();
            double needed = 8.0 * inspection.samples() * channels.size();
            if (needed > 0.8 * Runtime.getRuntime().maxMemory() || inspection.samples() > Integer.MAX_VALUE - 8) {
                throw DataFault.in(toString(),
                        String.format("%d samples of %d channels need %.1f GB of memory; read it as a stream,"
                                + " cut it, or give Java more (-Xmx)", inspection.samples(), channels.size(), needed / 1e9));
            }
            double[][] columns = new double[channels.size()][(int) inspection.samples()];
            double[] row = new double[1 + channels.size()];
            int length = 0;
            while (reader.read(row) && length < inspection.samples()) {
                for (int i = 0; i < columns.length; i++) {
                    columns[i][length] = row[1 + i];
                }
                length++;
            }
            Map<Channel, double[]> values = new LinkedHashMap<>();
            for (int i = 0; i < columns.length; i++) {
                values.put(channels.get(i), length == columns[i].length ? columns[i] : Arrays.copyOf(columns[i], length));
            }
            return new Recording(reader.clock(), values, reader.metadata());
        }
    }
}

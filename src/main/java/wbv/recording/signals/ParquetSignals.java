package wbv.recording.signals;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import org.apache.parquet.ParquetReadOptions;
import org.apache.parquet.column.ColumnDescriptor;
import org.apache.parquet.column.impl.ColumnReadStoreImpl;
import org.apache.parquet.column.page.PageReadStore;
import org.apache.parquet.conf.PlainParquetConfiguration;
import org.apache.parquet.crypto.ParquetCryptoRuntimeException;
import org.apache.parquet.example.data.simple.convert.GroupRecordConverter;
import org.apache.parquet.hadoop.ParquetFileReader;
import org.apache.parquet.hadoop.metadata.BlockMetaData;
import org.apache.parquet.hadoop.metadata.ColumnChunkMetaData;
import org.apache.parquet.io.LocalInputFile;
import org.apache.parquet.schema.MessageType;
import wbv.recording.CalendarTime;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Header;
import wbv.recording.Json;

/**
 * Parquet, by Apache's reader without Hadoop: every column of numbers is a signal, one sample a row; of structs {@code head.acc.z}. The
 * time is a column {@code t} [s], or else the first of timestamps. Pairs of key and value in the footer state a rate ({@code rate_hz}) and
 * units ({@code units}, JSON by column); so do {@code DataFrame.attrs}, which pandas writes there.
 *
 * <p>A group of rows is held in memory as it stands in the file, and no more.
 */
final class ParquetSignals implements SignalFile {

    static final String RATE = "rate_hz";
    static final String UNITS = "units";
    static final String PANDAS = "PANDAS_ATTRS";

    private final String file;
    private final ParquetFileReader reader;
    private final List<ParquetColumn> columns = new ArrayList<>();
    private final List<Label> labels = new ArrayList<>();
    private final Map<String, String> notes = new LinkedHashMap<>();
    private final Map<String, String> units = new LinkedHashMap<>();
    private OptionalDouble rate = OptionalDouble.empty();
    private final Optional<ParquetColumn> clock;
    private long left;
    private long read;

    private ParquetSignals(String file, Path path, ParquetFileReader reader) throws IOException {
        this.file = file;
        this.reader = reader;
        MessageType schema = reader.getFileMetaData().getSchema();
        requireWithin(Files.size(path));
        reader.getFileMetaData().getKeyValueMetaData().forEach((key, value) -> state(key, json(value)));
        Set<String> others = new LinkedHashSet<>();
        for (ColumnDescriptor each : schema.getColumns()) {
            boolean list = each.getMaxRepetitionLevel() > 0;
            ParquetColumn.of(each, String.join(".", each.getPath())).ifPresentOrElse(columns::add,
                    () -> others.add(list ? each.getPath()[0] : String.join(".", each.getPath())));
        }
        clock = columns.stream().filter(column -> ClockWords.isTime(column.name())).findFirst()
                .or(() -> columns.stream().filter(ParquetColumn::isTimestamp).findFirst());
        columns.stream().filter(column -> column.isTimestamp() && clock.get() != column).forEach(column -> others.add(column.name()));
        columns.removeIf(column -> column.isTimestamp() && clock.get() != column);
        if (columns.stream().allMatch(ParquetColumn::isTimestamp)) {
            throw DataFault.in(file, "holds no column of numbers" + (others.isEmpty() ? ""
                    : "; there are " + Header.shortened(List.copyOf(others))
                            + ", text, dates or lists (write one number a row and column)"));
        }
        for (ParquetColumn column : columns) {
            Label label = Label.of(column.name());
            labels.add(Optional.ofNullable(units.get(column.name())).flatMap(UnitWords::of).map(label::in).orElse(label));
        }
        if (!others.isEmpty()) {
            notes.put("not read", String.join(", ", others));
        }
        List<ColumnDescriptor> wanted = columns.stream().map(ParquetColumn::descriptor).toList();
        requireCodecs(wanted);
        reader.setRequestedSchema(wanted);
        if (clock.filter(ParquetColumn::isTimestamp).isPresent() && nextGroup()) {
            clock.get().date().ifPresent(date -> notes.put("start", date));
        }
    }

    static SignalFile open(String file, Path path) {
        return sound(file, () -> {
            ParquetReadOptions options = ParquetReadOptions.builder(new PlainParquetConfiguration()).withCodecFactory(new PageCodecs(file))
                    .usePageChecksumVerification().build();
            ParquetFileReader reader = new ParquetFileReader(new LocalInputFile(path), options);
            try {
                return new ParquetSignals(file, path, reader);
            } catch (RuntimeException | IOException failed) {
                reader.close();
                throw failed;
            }
        });
    }

    /**
     * What is read of a file, whatever its bytes lead Parquet to.
     *
     * @throws DataFault if it is damaged
     */
    private static <T> T sound(String file, Reading<T> reading) {
        try {
            return reading.read();
        } catch (DataFault told) {
            throw told;
        } catch (ParquetCryptoRuntimeException encrypted) {
            throw DataFault.in(file, "is encrypted; write it anew in the plain", encrypted);
        } catch (RuntimeException | IOException | StackOverflowError damaged) { // the last by a schema of groups in groups
            throw DataFault.in(file, "is a damaged Parquet file, or cut off or gzipped; save, copy or unpack it again", damaged);
        } catch (OutOfMemoryError full) { // for one page or group of rows, of whatever size the file states
            throw DataFault.in(file,
                    "asks for more memory than Java has: it is damaged, or its groups of rows are so large that Java needs "
                            + "more, as in WBV_JAVA_OPTS=-Xmx8g",
                    full);
        }
    }

    private interface Reading<T> {
        T read() throws IOException;
    }

    /** Parquet makes room for what the footer states before it reads. */
    private void requireWithin(long bytes) {
        for (BlockMetaData rows : reader.getRowGroups()) {
            for (ColumnChunkMetaData chunk : rows.getColumns()) {
                long start = chunk.getStartingPos();
                long size = chunk.getTotalSize();
                if (start < 0 || size < 0 || start > bytes || size > bytes - start || rows.getRowCount() < 0) {
                    throw DataFault.in(file, "states columns beyond its end; it is a damaged Parquet file, or cut off");
                }
            }
        }
    }

    private void requireCodecs(List<ColumnDescriptor> wanted) {
        Set<List<String>> paths = wanted.stream().map(column -> List.of(column.getPath())).collect(Collectors.toSet());
        reader.getRowGroups().stream().flatMap(rows -> rows.getColumns().stream())
                .filter(chunk -> paths.contains(List.of(chunk.getPath().toArray())))
                .forEach(chunk -> PageCodecs.require(file, chunk.getCodec()));
    }

    /** Takes a rate or units from a pair of the footer; what it means otherwise is its maker's affair. */
    private void state(String key, JsonNode value) {
        if (key.equals(PANDAS)) {
            value.fields().forEachRemaining(inner -> state(inner.getKey(), inner.getValue()));
        } else if (key.equals(UNITS)) {
            value.fields().forEachRemaining(unit -> units.putIfAbsent(unit.getKey(), unit.getValue().asText()));
        } else if (rate.isEmpty()) {
            ClockWords.rate(key, value.asDouble(Double.NaN))
                    .ifPresent(stated -> rate = Clock.isRate(stated) ? OptionalDouble.of(stated) : rate);
        }
    }

    /** A value of the footer as the JSON that it is, or else as text. */
    private static JsonNode json(String value) {
        try {
            return Json.MAPPER.readTree(value);
        } catch (JsonProcessingException text) {
            return TextNode.valueOf(value);
        }
    }

    private boolean nextGroup() throws IOException {
        PageReadStore group = reader.readNextRowGroup();
        if (group == null) { // as Parquet says that there is none
            return false;
        }
        MessageType schema = reader.getFileMetaData().getSchema();
        ColumnReadStoreImpl values = new ColumnReadStoreImpl(new CheckedPages(file, group),
                new GroupRecordConverter(schema).getRootConverter(),
                schema, reader.getFileMetaData().getCreatedBy());
        columns.forEach(column -> column.enter(values.getColumnReader(column.descriptor())));
        left = group.getRowCount();
        return true;
    }

    @Override
    public List<Label> labels() {
        return List.copyOf(labels);
    }

    @Override
    public Optional<String> time() {
        return clock.map(ParquetColumn::name);
    }

    @Override
    public Optional<CalendarTime> origin() {
        return clock.flatMap(ParquetColumn::origin);
    }

    @Override
    public OptionalDouble rate() {
        return rate;
    }

    @Override
    public Map<String, String> notes() {
        return notes;
    }

    @Override
    public boolean read(double[] row) {
        return sound(file, () -> {
            while (left == 0) {
                if (!nextGroup()) {
                    return false;
                }
            }
            for (int i = 0; i < row.length; i++) {
                row[i] = columns.get(i).next();
            }
            left--;
            read++;
            return true;
        });
    }

    @Override
    public double fractionRead() {
        return reader.getRecordCount() == 0 ? 1 : (double) read / reader.getRecordCount();
    }

    @Override
    public void close() throws IOException {
        reader.close();
    }
}

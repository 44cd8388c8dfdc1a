package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.Consumer;
import java.util.function.DoubleUnaryOperator;
import org.apache.parquet.format.ColumnMetaData;
import org.apache.parquet.format.CompressionCodec;
import org.apache.parquet.format.FileMetaData;
import org.apache.parquet.format.PageHeader;
import org.apache.parquet.format.Util;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.RowReader;
import wbv.recording.Unit;

/**
 * Parquet: files that pandas, polars and pyarrow wrote (src/test/resources/signals), read to the last bit; what we write, read back;
 * damaged ones, and such as state more than they hold, refused in one line.
 */
class ParquetTest {

    private static final Path MADE = Path.of("src/test/resources/signals");
    private static final int ROWS = 120;
    private static final int TIME = 0;
    private static final int SEAT = 1;
    private static final int HEAD = 2;
    private static final int GYRO = 3;
    /** The samples that were lost at the head, where any were. */
    private static final List<Integer> LOST = List.of(7, 8);

    @TempDir
    private Path room;

    private static double[] expected(int column) throws IOException {
        return Files.readAllLines(MADE.resolve("expected.csv")).stream().skip(1)
                .mapToDouble(line -> Double.parseDouble(line.split(",")[column])).toArray();
    }

    private static double[] lossy(int column) throws IOException {
        double[] all = expected(column);
        LOST.forEach(sample -> all[sample] = Double.NaN);
        return all;
    }

    private static double[] column(List<double[]> rows, int column) {
        return rows.stream().mapToDouble(row -> row[column]).toArray();
    }

    /** In g and back. */
    private static double[] inG(double[] values) {
        DoubleUnaryOperator both = value -> value / Unit.STANDARD_GRAVITY * Unit.STANDARD_GRAVITY;
        return Arrays.stream(values).map(both).toArray();
    }

    private static RowReader open(Path file) throws IOException {
        return new RecordingFile(file).open();
    }

    @Test
    void pyarrowsColumnsHaveNamesUnitsAndARate() throws IOException {
        try (RowReader reader = open(MADE.resolve("pyarrow-none.parquet"))) {
            assertEquals("[seat.acc.z, head.acc.z, head.gyr.y]", reader.channels().toString());
            assertEquals(60, reader.metadata().rate().orElseThrow());
            assertEquals(Map.of("not read", "remark, even"), reader.metadata().notes());
            List<double[]> rows = Samples.rows(reader);
            assertEquals(ROWS, rows.size());
            assertArrays(expected(TIME), column(rows, 0));
            assertArrays(inG(expected(SEAT)), column(rows, 1));
            assertArrays(lossy(HEAD), column(rows, 2));
            assertArrays(Arrays.stream(expected(GYRO)).map(value -> (float) value).toArray(), column(rows, 3));
        }
    }

    @Test
    void pandasFrameIsTimedByItsIndexAndHasAttributes() throws IOException {
        try (RowReader reader = open(MADE.resolve("pandas-snappy.parquet"))) {
            assertEquals("[head.acc.z, seat.acc.z]", reader.channels().toString());
            assertEquals(60, reader.metadata().rate().orElseThrow());
            assertEquals(Map.of("start", "2026-09-21T14:13:20.123456789Z"), reader.metadata().notes());
            List<double[]> rows = Samples.rows(reader);
            assertArrays(rounded(1e9), column(rows, 0));
            assertArrays(lossy(HEAD), column(rows, 1));
            assertArrays(inG(expected(SEAT)), column(rows, 2));
        }
    }

    @Test
    void polarsFrameMayHaveStructs() throws IOException {
        try (RowReader reader = open(MADE.resolve("polars-zstd.parquet"))) {
            assertEquals("[head.acc.z, seat.acc.z]", reader.channels().toString());
            assertEquals(Map.of("start", "2026-09-21T14:13:20.123456", "not read", "pads"), reader.metadata().notes());
            List<double[]> rows = Samples.rows(reader);
            for (int i = 0; i < ROWS; i++) {
                assertEquals(i / 60.0, rows.get(i)[0], 1.001e-6); // whole microseconds, cut off at both ends
            }
            assertArrays(lossy(HEAD), column(rows, 1));
            assertArrays(expected(SEAT), column(rows, 2));
        }
    }

    @ParameterizedTest
    @CsvSource({"pyarrow-lz4-int96.parquet, 1e9, 2026-09-21T14:13:20.123456789",
        "pyarrow-milliseconds.parquet, 1e3, 2026-09-21T14:13:20.123"})
    void timestampsAreToldByTheirType(String name, double perSecond, String start) throws IOException {
        try (RowReader reader = open(MADE.resolve(name))) {
            assertEquals(Map.of("start", start), reader.metadata().notes());
            List<double[]> rows = Samples.rows(reader);
            for (int i = 0; i < ROWS; i++) {
                assertEquals(i / 60.0, rows.get(i)[0], 1.001 / perSecond);
            }
            assertArrays(expected(SEAT), column(rows, 1));
        }
    }

    /** Each counts from its own first row, which are half a second apart. */
    @Test
    void filesAreJoinedByTheirTimestamps() throws IOException {
        OptionalDouble rate = OptionalDouble.of(60);
        ReadOptions options = new ReadOptions(Optional.empty(), rate, Map.of());
        List<double[]> rows;
        try (RowReader joined = new RecordingSet(List.of(new RecordingFile(MADE.resolve("pyarrow-later.parquet"), options),
                new RecordingFile(MADE.resolve("polars-zstd.parquet"), options))).open()) {
            assertEquals("[sternum.acc.z, head.acc.z, seat.acc.z]", joined.channels().toString());
            rows = Samples.rows(joined);
        }
        assertEquals(ROWS, rows.size());
        for (int i = 0; i < ROWS; i++) {
            assertEquals(i / 60.0, rows.get(i)[0], 0.001, "whole milliseconds, cut off");
            assertEquals(i < 30 ? Double.NaN : rows.get(i)[3], rows.get(i)[1], "what was the same at one moment stands in one row");
        }
    }

    /** Steps of a second's part, as NumPy rounded them. */
    private static double[] rounded(double perSecond) {
        double[] times = new double[ROWS];
        Arrays.setAll(times, i -> Math.rint(i * perSecond / 60) / perSecond);
        return times;
    }

    /** A rate and no times; what has no name of ours is told by a map. */
    @ParameterizedTest
    @CsvSource({"a16, true, 0", "a64, true, 0", "u8, false, 100", "u32, false, 4e9", "u64, false, 9223372036854775808", "cents, false, 0"})
    void wholeNumbersAreReadByAMap(String name, boolean counts, double from) throws IOException {
        Path map = Files.writeString(room.resolve("map.json"),
                "{\"channels\": {\"seat.acc.z\": {\"column\": \"" + name + "\", \"unit\": \"m/s2\", \"scale\": 0.5}}}");
        try (RowReader reader = new RecordingFile(MADE.resolve("pyarrow-gzip.parquet"),
                new ReadOptions(Optional.of(ColumnMap.read(map)), OptionalDouble.empty(), Map.of())).open()) {
            assertEquals(60, reader.metadata().rate().orElseThrow());
            List<double[]> rows = Samples.rows(reader);
            assertArrays(expected(TIME), column(rows, 0));
            double[] truth = expected(SEAT);
            for (int i = 0; i < ROWS; i++) {
                assertEquals(0.5 * (counts ? 4096 * truth[i] : from + i), rows.get(i)[1], name + " " + i);
            }
        }
    }

    @Test
    void newerEncodingsAreRead() throws IOException {
        try (RowReader reader = open(MADE.resolve("pyarrow-gzip.parquet"))) {
            assertEquals(Map.of("not read", "a16, a64, u8, u32, u64, cents"), reader.metadata().notes());
            assertArrays(expected(SEAT), column(Samples.rows(reader), 1));
        }
    }

    /** More rows than one group has, at uneven times, with every kind of double that a recording may hold. */
    @Test
    void whatIsWrittenReadsBackToTheBit() throws IOException {
        List<Channel> channels = List.of(Channel.parse("head.acc.z"), Channel.parse("head.quat.w"));
        Path file = room.resolve("r.parquet");
        int length = (1 << 17) + 1000;
        double[][] written = new double[length][];
        Random random = new Random(5);
        double time = -3;
        for (int i = 0; i < length; i++) {
            double any = Double.longBitsToDouble(random.nextLong());
            written[i] = new double[] {time, Double.isFinite(any) ? any : Double.NaN, i % 3 == 0 ? -0.0 : i % 7 == 0 ? Double.NaN : i};
            time += random.nextDouble();
        }
        try (RecordingWriter writer = RecordingWriter.create(file, channels, Metadata.NONE.withRate(OptionalDouble.of(59.9765)))) {
            for (double[] row : written) {
                writer.write(row);
            }
            writer.finish();
        }
        try (RowReader reader = open(file)) {
            assertEquals(channels, reader.channels());
            assertEquals(59.9765, reader.metadata().rate().orElseThrow());
            double[] row = new double[3];
            for (int i = 0; i < length; i++) {
                assertTrue(reader.read(row));
                assertArrayEquals(written[i], row);
            }
            assertFalse(reader.read(row));
            assertEquals(1, reader.fractionRead());
        }
    }

    @ParameterizedTest
    @CsvSource({"pyarrow-brotli.parquet, is compressed by BROTLI",
        "pyarrow-nested.parquet, 'holds no column of numbers; there are [pads, remark]'"})
    void whatIsNotReadIsToldInOneLine(String name, String told) {
        refused(MADE.resolve(name), told);
    }

    private static void refused(Path file, String told) {
        DataFault fault = assertThrows(DataFault.class, () -> Samples.rows(open(file)));
        assertTrue(fault.getMessage().startsWith(file + ": ") && fault.getMessage().contains(told) && !fault.getMessage().contains("\n"),
                fault.getMessage());
    }

    @ParameterizedTest
    @ValueSource(strings = {"pyarrow-none.parquet", "pandas-snappy.parquet", "polars-zstd.parquet", "pyarrow-gzip.parquet"})
    void halfAFileIsRefusedInOneLine(String name) throws IOException {
        byte[] whole = Files.readAllBytes(MADE.resolve(name));
        for (int length : new int[] {4, 11, 12, whole.length / 2, whole.length - 1}) {
            refused(Files.write(room.resolve(name), Arrays.copyOf(whole, length)), "is a damaged Parquet file");
        }
    }

    /** A file whose footer was changed. */
    private Path changed(String name, Consumer<ColumnMetaData> change) throws IOException {
        byte[] whole = Files.readAllBytes(MADE.resolve(name));
        FileMetaData footer = footer(whole);
        footer.getRow_groups().forEach(rows -> rows.getColumns().forEach(column -> change.accept(column.getMeta_data())));
        return written(Arrays.copyOf(whole, whole.length - 8 - length(whole)), footer);
    }

    private static int length(byte[] whole) {
        return ByteBuffer.wrap(whole).order(ByteOrder.LITTLE_ENDIAN).getInt(whole.length - 8);
    }

    private static FileMetaData footer(byte[] whole) throws IOException {
        int length = length(whole);
        return Util.readFileMetaData(new ByteArrayInputStream(whole, whole.length - 8 - length, length));
    }

    private Path written(byte[] pages, FileMetaData footer) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(pages);
        Util.writeFileMetaData(footer, bytes);
        int length = bytes.size() - pages.length;
        bytes.write(ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN).putInt(length).put("PAR1".getBytes()).array());
        return Files.write(room.resolve("changed.parquet"), bytes.toByteArray());
    }

    @Test
    void footersThatStateMoreThanThereIsAreRefused() throws IOException {
        String name = "pandas-snappy.parquet";
        assertArrays(lossy(HEAD), column(Samples.rows(open(changed(name, column -> {}))), 1));
        refused(changed(name, column -> column.setTotal_compressed_size(1L << 40)), "beyond its end");
        refused(changed(name, column -> column.setTotal_compressed_size(-1)), "beyond its end");
        refused(changed(name, column -> column.setData_page_offset(Long.MAX_VALUE).unsetDictionary_page_offset()), "beyond its end");
        refused(changed(name, column -> column.setNum_values(1L << 40)), "is a damaged Parquet file");
        refused(changed(name, column -> column.setNum_values(ROWS - 1)), "is a damaged Parquet file");
        refused(changed(name, column -> column.setCodec(CompressionCodec.LZO)), "is compressed by LZO");
        refused(changed(name, column -> column.setCodec(CompressionCodec.ZSTD)), "is a damaged Parquet file");
        byte[] whole = Files.readAllBytes(MADE.resolve(name));
        FileMetaData footer = footer(whole);
        footer.getRow_groups().get(0).setNum_rows(ROWS + 1);
        refused(written(Arrays.copyOf(whole, whole.length - 8 - length(whole)), footer), "states another number of values");
    }

    /** Room is made by what a page's header states: 2 147 483 647 doubles would be 17 GB. */
    @Test
    void pagesThatStateMoreThanTheyHoldAreRefused() throws IOException {
        assertArrays(expected(SEAT), column(Samples.rows(open(changedPage(header -> {}))), 1));
        refused(changedPage(header -> header.getDictionary_page_header().setNum_values(Integer.MAX_VALUE)), "another number of values");
        refused(changedPage(header -> header.setUncompressed_page_size(Integer.MAX_VALUE)), "states a page of 2147483647 bytes");
        refused(changedPage(header -> header.setUncompressed_page_size(header.getUncompressed_page_size() + 1)), "damaged");
        refused(changedPage(header -> header.setCompressed_page_size(Integer.MAX_VALUE)), "damaged");
        refused(changedPage(header -> header.setCompressed_page_size(-1)), "is a damaged Parquet file");
    }

    /** A file of which the header of its last column's first page was changed. */
    private Path changedPage(Consumer<PageHeader> change) throws IOException {
        byte[] whole = Files.readAllBytes(MADE.resolve("pyarrow-milliseconds.parquet"));
        FileMetaData footer = footer(whole);
        ColumnMetaData column = footer.getRow_groups().get(0).getColumns().get(1).getMeta_data();
        int start = (int) column.getDictionary_page_offset();
        ByteArrayInputStream from = new ByteArrayInputStream(whole, start, (int) column.getTotal_compressed_size());
        PageHeader header = Util.readPageHeader(from);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(whole, 0, start);
        change.accept(header);
        Util.writePageHeader(header, bytes);
        int shift = bytes.size() - start - (int) (column.getTotal_compressed_size() - from.available());
        bytes.write(from.readAllBytes());
        column.setTotal_compressed_size(column.getTotal_compressed_size() + shift);
        column.setData_page_offset(column.getData_page_offset() + shift);
        return written(bytes.toByteArray(), footer);
    }

    private static void assertArrays(double[] expected, double[] actual) {
        assertEquals(Arrays.toString(expected), Arrays.toString(actual)); // NaN too, to the bit but its sign
    }
}

package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.zip.GZIPOutputStream;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
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
 * UFF 58, MAT, HDF5 and WAV: files that other programs wrote (src/test/resources/signals), read; what we write, read back; damaged ones
 * refused in one line.
 */
class SignalsTest {

    private static final Path MADE = Path.of("src/test/resources/signals");
    private static final int TIME = 0;
    private static final int SEAT = 1;
    private static final int HEAD = 2;
    private static final int GYRO = 3;
    private static final int FORCE = 4;

    @TempDir
    private Path room;

    /** What the files were made of, by column of expected.csv. */
    private static double[] expected(int column) throws IOException {
        return Files.readAllLines(MADE.resolve("expected.csv")).stream().skip(1)
                .mapToDouble(line -> Double.parseDouble(line.split(",")[column])).toArray();
    }

    private static RowReader open(Path file, String map) throws IOException {
        return new RecordingFile(file, options(file, map)).open();
    }

    private static ReadOptions options(Path file, String map) throws IOException {
        if (map.isEmpty()) {
            return ReadOptions.DEFAULT;
        }
        Path written = Files.createTempFile("map", ".json");
        try {
            Files.writeString(written, map);
            return new ReadOptions(Optional.of(ColumnMap.read(written)), OptionalDouble.empty(), Map.of());
        } finally {
            Files.delete(written);
        }
    }

    private static double[] column(List<double[]> rows, int column) {
        return rows.stream().mapToDouble(row -> row[column]).toArray();
    }

    private static void assertNear(double[] expected, double[] actual, double tolerance) {
        assertEquals(expected.length, actual.length);
        for (int i = 0; i < expected.length; i++) {
            assertEquals(expected[i], actual[i], tolerance, "sample " + i);
        }
    }

    /** Node, direction, type and unit make the channel; -z in g is turned and scaled; the spectrum among them is passed over. */
    @ParameterizedTest
    @CsvSource({"pyuff-ascii.uff, 1e-10", "pyuff-binary.uff, 2e-16"})
    void universalFileSaysItsChannels(String name, double resolution) throws IOException {
        try (RowReader reader = open(MADE.resolve(name), "")) {
            assertEquals("[seat.acc.z, head.acc.z, head.gyr.y, seat.force.z]", reader.channels().toString());
            assertEquals(60, reader.metadata().rate().orElseThrow(), "1.66667e-02 s is the rounding of 60 Hz");
            assertTrue(reader.metadata().notes().get("not read").startsWith("1 "));
            List<double[]> rows = Samples.rows(reader);
            assertNear(expected(TIME), column(rows, 0), 1e-15);
            assertNear(expected(SEAT), column(rows, 1), resolution);
            assertNear(Arrays.stream(expected(HEAD)).map(value -> -value).toArray(), column(rows, 2), 10 * resolution);
            assertNear(expected(GYRO), column(rows, 3), resolution);
            assertNear(expected(FORCE), column(rows, 4), 1e3 * resolution);
        }
    }

    @Test
    void universalFileOfUnevenTimesKeepsThem() throws IOException {
        List<double[]> text = Samples.rows(open(MADE.resolve("pyuff-uneven.uff"), ""));
        assertNear(Arrays.stream(expected(TIME)).map(time -> time + 0.25).toArray(), column(text, 0), 1e-5); // six digits
        assertNear(expected(SEAT), column(text, 1), 1e-10);
        assertNear(expected(HEAD), column(text, 2), 1e-10);
        List<double[]> bigEndian = Samples.rows(open(MADE.resolve("struct-uneven.uff"), ""));
        assertEquals(0.25 + 119 / 64.0, bigEndian.get(119)[0]);
        assertNear(expected(SEAT), column(bigEndian, 1), 0);
    }

    /** Numbers without a unit are in those of dataset 164; a node without a name is a place by its number, or what the user says. */
    @Test
    void universalFileWithoutUnitsIsInThoseOfItsUnitsDataset() throws IOException {
        Path file = MADE.resolve("pyuff-millimetres.uff");
        try (RowReader reader = open(file, "")) {
            assertEquals("[node_7.acc.x, node_7.force.x]", reader.channels().toString());
            List<double[]> rows = Samples.rows(reader);
            assertNear(expected(SEAT), column(rows, 1), 1e-10);
            assertNear(expected(FORCE), column(rows, 2), 1e-6);
        }
        try (RowReader reader = new RecordingFile(file,
                new ReadOptions(Optional.empty(), OptionalDouble.empty(), Map.of("node_7", "sledge"))).open()) {
            assertEquals("[sledge.acc.x, sledge.force.x]", reader.channels().toString());
        }
    }

    @ParameterizedTest
    @CsvSource({"pyuff-no-direction.uff, does not say its direction", "pyuff-no-unit.uff, does not say its unit",
        "scipy-struct.mat, no signal says what it measures",
        "scipy-16.wav, no signal says what it measures"})
    void whatAFileCannotSayIsAskedForInOneLine(String name, String asked) {
        DataFault fault = assertThrows(DataFault.class, () -> open(MADE.resolve(name), ""));
        assertTrue(fault.getMessage().startsWith(MADE.resolve(name) + ": ") && fault.getMessage().contains(asked)
                && fault.getMessage().contains("wbv map"), fault.getMessage());
    }

    @ParameterizedTest
    @ValueSource(strings = {"scipy-5.mat", "scipy-7.mat"})
    void matFileNamesItsChannels(String name) throws IOException {
        try (RowReader reader = open(MADE.resolve(name), "")) {
            assertEquals("[seat.acc.z, head.acc.z, head.gyr.y]", reader.channels().toString());
            assertEquals("comment", reader.metadata().notes().get("not read"));
            List<double[]> rows = Samples.rows(reader);
            assertNear(expected(TIME), column(rows, 0), 0);
            assertNear(expected(SEAT), column(rows, 1), 0);
            assertNear(expected(HEAD), column(rows, 2), 0);
            assertNear(expected(GYRO), column(rows, 3), 0);
        }
    }

    /** Matrices in a struct by a map; the rate is the file's own fs. */
    @ParameterizedTest
    @CsvSource({"scipy-struct.mat, ride.acc", "hdf5storage-73.mat, acc"})
    void columnsOfMatricesAreNamedAsInMatlab(String name, String matrix) throws IOException {
        String map = """
                {"channels": {"head.acc.z": {"column": "%1$s(:,2)", "unit": "m/s2"},
                              "seat.acc.z": {"column": "%1$s(:,1)", "unit": "g", "scale": -1}}}
                """.formatted(matrix);
        try (RowReader reader = open(MADE.resolve(name), map)) {
            assertEquals(60, reader.metadata().rate().orElseThrow());
            List<double[]> rows = Samples.rows(reader);
            assertNear(expected(TIME), column(rows, 0), 1e-15);
            assertNear(expected(HEAD), column(rows, 1), 0);
            assertNear(Arrays.stream(expected(SEAT)).map(value -> -Unit.STANDARD_GRAVITY * value).toArray(), column(rows, 2), 1e-14);
        }
    }

    /** Version 7.3 without a map: what is named as a channel. */
    @Test
    void matFileOfVersion73IsHdf5() throws IOException {
        try (RowReader reader = open(MADE.resolve("hdf5storage-73.mat"), "")) {
            assertEquals("[head.gyr.y]", reader.channels().toString());
            assertTrue(reader.metadata().notes().get("not read").contains("acc(:,1), acc(:,2)"));
            assertNear(expected(GYRO), column(Samples.rows(reader), 1), 0);
        }
    }

    @Test
    void hdf5HasUnitsAndIsCompressed() throws IOException {
        try (RowReader reader = open(MADE.resolve("h5py.h5"), "")) {
            assertEquals(List.of("head.acc.z", "seat.acc.z"), reader.channels().stream().map(Channel::toString).sorted().toList());
            int seat = 1 + reader.channels().indexOf(Channel.parse("seat.acc.z"));
            List<double[]> rows = Samples.rows(reader);
            assertNear(expected(SEAT), column(rows, seat), 1e-15);
            assertNear(expected(HEAD), column(rows, 3 - seat), 0);
        }
        String map = "{\"channels\": {\"seat.acc.z\": {\"column\": \"ride/pads[:,0]\"}, \"head.acc.z\": {\"column\": \"ride/pads[:,1]\"}}}";
        List<double[]> rows = Samples.rows(open(MADE.resolve("h5py.h5"), map));
        assertNear(expected(SEAT), column(rows, 1), 0);
        assertNear(expected(HEAD), column(rows, 2), 0);
    }

    /**
     * A map gives channels their names and says what full scale is; half a step of each width is what may be lost, a whole one where it was
     * rounded down.
     */
    @ParameterizedTest
    @CsvSource({"soundfile-8.wav, 64", "scipy-16.wav, 32768", "soundfile-24.wav, 8388608", "soundfile-extensible-24.wav, 8388608",
        "scipy-32.wav, 2147483648", "scipy-float.wav, 1e300", "scipy-double.wav, 1e300", "soundfile-rf64.wav, 1e300"})
    void soundIsScaledByItsMap(String name, double steps) throws IOException {
        String map = "{\"channels\": {\"seat.acc.z\": {\"column\": \"1\", \"unit\": \"m/s2\", \"scale\": 20}, \"head.acc.z\": "
                + "{\"column\": \"2\", \"unit\": \"g\"}}}";
        try (RowReader reader = open(MADE.resolve(name), map)) {
            assertEquals(60, reader.metadata().rate().orElseThrow());
            List<double[]> rows = Samples.rows(reader);
            assertNear(expected(TIME), column(rows, 0), 1e-15);
            assertNear(Arrays.stream(expected(SEAT)).map(value -> 20 * value).toArray(), column(rows, 1), 20 * (0.5001 / steps) + 1e-15);
            assertNear(Arrays.stream(expected(HEAD)).map(value -> Unit.STANDARD_GRAVITY * value).toArray(), column(rows, 2),
                    10 * (0.5001 / steps) + 1e-15);
        }
    }

    private static final List<
            Channel> CHANNELS = List.of("left_shoulder.accg.x", "seat.gyr.z", "seat.force.z", "coil.volt.s", "head.quat.w").stream()
                    .map(Channel::parse).toList();

    private Path written(String name, double rate) throws IOException {
        Path file = room.resolve(name);
        try (RecordingWriter writer = RecordingWriter.create(file, CHANNELS, Metadata.NONE.withRate(OptionalDouble.of(rate)))) {
            for (int i = 0; i < 301; i++) {
                writer.write(new double[] {i / rate, Math.sin(i), i == 7 ? Double.NaN : Math.sin(2 * i) / 3, 1e3 * Math.cos(i), 1e-7 * i,
                    1 - 1e-9 * i});
            }
            writer.finish();
        }
        return file;
    }

    /** A sixth digit of the increment is all that a universal file's text has for the rate. */
    @ParameterizedTest
    @CsvSource({"r.mat, 0, 0", "r.h5, 0, 0", "r.uff, 0, 3e-7", "r.unv, 1e-12, 3e-7", "r.wav, 6e-8, 0"})
    void writtenFilesReadBackToTheirResolution(String name, double relative, double rate) throws IOException {
        double hertz = 59.9765;
        try (RowReader reader = open(written(name, hertz), "")) {
            assertEquals(CHANNELS, reader.channels());
            List<double[]> rows = Samples.rows(reader);
            assertEquals(301, rows.size());
            for (int i = 0; i < 301; i++) {
                double[] row = rows.get(i);
                assertEquals(i / hertz, row[0], rate * (1 + i / hertz) + 1e-15);
                double[] truth = {Math.sin(i), i == 7 ? Double.NaN : Math.sin(2 * i) / 3, 1e3 * Math.cos(i), 1e-7 * i, 1 - 1e-9 * i};
                for (int j = 0; j < truth.length; j++) {
                    assertEquals(truth[j], row[1 + j], Double.isNaN(truth[j]) ? 0 : relative * Math.abs(truth[j]),
                            CHANNELS.get(j) + " " + i);
                }
            }
        }
    }

    /** Java's own reader of sound as the oracle of what is written. */
    @Test
    void javaReadsTheSoundThatIsWritten() throws Exception {
        try (AudioInputStream sound = AudioSystem.getAudioInputStream(written("r.wav", 60).toFile())) {
            AudioFormat format = sound.getFormat();
            assertEquals(AudioFormat.Encoding.PCM_FLOAT, format.getEncoding());
            assertEquals(60, format.getSampleRate());
            assertEquals(301, sound.getFrameLength());
            ByteBuffer bytes = ByteBuffer.wrap(sound.readAllBytes()).order(ByteOrder.LITTLE_ENDIAN);
            assertEquals(301 * 4 * CHANNELS.size(), bytes.capacity());
            assertEquals((float) Math.sin(300), bytes.getFloat(300 * 4 * CHANNELS.size()));
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"pyuff-ascii.uff", "pyuff-binary.uff", "scipy-5.mat", "scipy-7.mat", "h5py.h5", "hdf5storage-73.mat", "scipy-16.wav",
                "soundfile-rf64.wav"})
    void halfAFileIsRefusedInOneLine(String name) throws IOException {
        byte[] whole = Files.readAllBytes(MADE.resolve(name));
        String map = name.endsWith(".wav") ? "{\"channels\": {\"seat.acc.z\": {\"column\": \"1\"}}}" : "";
        for (int part = 2; part <= 5; part++) {
            Path half = Files.write(room.resolve(name), Arrays.copyOf(whole, whole.length * (part - 1) / part - 100));
            DataFault fault = assertThrows(DataFault.class, () -> Samples.rows(open(half, map)), name + " " + part);
            assertTrue(fault.getMessage().startsWith(half.toString()) && !fault.getMessage().contains("\n"), fault.getMessage());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"pyuff-binary.uff", "scipy-7.mat"})
    void compressedFilesAreRead(String name) throws IOException {
        ByteArrayOutputStream zipped = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(zipped)) {
            Files.copy(MADE.resolve(name), gzip);
        }
        assertNear(expected(SEAT), column(Samples.rows(open(Files.write(room.resolve("r.gz"), zipped.toByteArray()), "")), 1), 1e-15);
    }

    @Test
    void unevenTimesAndOddRatesAreRefusedWhereAFormatHasNone() throws IOException {
        for (String name : List.of("r.uff", "r.wav")) {
            try (RecordingWriter writer = RecordingWriter.create(room.resolve(name), CHANNELS.subList(0, 1), Metadata.NONE)) {
                for (double time : new double[] {0, 0.1, 0.2, 0.35}) {
                    writer.write(new double[] {time, 1});
                }
                assertTrue(assertThrows(DataFault.class, writer::finish).getMessage().contains("not even"));
            }
            assertFalse(Files.exists(room.resolve(name)));
        }
        assertTrue(assertThrows(DataFault.class, () -> written("odd.wav", 12.5)).getMessage().contains("12.5"));
    }

    /** A map that says nothing of time is for files that know it. */
    @Test
    void tableNeedsATimeInItsMap() throws IOException {
        Path table = Files.write(room.resolve("a.csv"), "Az\n1\n2\n".getBytes(StandardCharsets.US_ASCII));
        DataFault fault = assertThrows(DataFault.class, () -> open(table, "{\"channels\": {\"seat.acc.z\": {\"column\": \"Az\"}}}"));
        assertTrue(fault.getMessage().contains("'time' is missing"), fault.getMessage());
    }
}

package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.yahoo.labs.samoa.instances.Instance;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import moa.streams.ArffFileStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;
import wbv.recording.RowReader;
import weka.core.Instances;
import weka.core.converters.ArffLoader;

/** What is written reads back bit by bit, by us, by Weka and by MOA. */
class RoundTripTest {

    private static final List<Channel> CHANNELS = List.of(Channel.parse("platform.acc.z"), Channel.parse("head.acc.z"));
    private static final double[] BORDER = {0.0, -0.0, Double.NaN, Double.MIN_VALUE, -Double.MIN_VALUE, Double.MIN_NORMAL, 1e-300,
        1e300, Double.MAX_VALUE, -Double.MAX_VALUE, 0.1, 1.0 / 3, 9007199254740993.0, -2147483648.0, 2147483648.0, 1e15,
        1e16, 123456.789};

    @TempDir
    Path folder;

    private static double[][] rows() {
        Random random = new Random(3);
        double[][] rows = new double[2000][3];
        for (int i = 0; i < rows.length; i++) {
            rows[i][0] = i / 60.0;
            rows[i][1] = i < BORDER.length ? BORDER[i] : random.nextGaussian();
            double any = Double.longBitsToDouble(random.nextLong());
            rows[i][2] = Double.isFinite(any) ? any : Double.NaN;
        }
        return rows;
    }

    private Path write(String name, double[][] rows) throws IOException {
        Path path = folder.resolve(name);
        try (RecordingWriter writer = RecordingWriter.create(path, CHANNELS, METADATA)) {
            for (double[] row : rows) {
                writer.write(row);
            }
            writer.finish();
        }
        return path;
    }

    private static final Metadata METADATA = new Metadata(OptionalDouble.of(60), new LinkedHashMap<>(Map.of("head", "00B42235")),
            Optional.of(new Metadata.Subject(OptionalDouble.of(79.4), OptionalDouble.of(1.8), OptionalDouble.empty(),
                    Optional.of("f"))),
            Optional.of("haul road, loaded"), OptionalDouble.of(380), Optional.of("a test"), Map.of("seed", "7"));

    private static void assertSameBits(double expected, double actual, String where) {
        assertEquals(Double.doubleToLongBits(expected), Double.doubleToLongBits(actual), where);
    }

    @ParameterizedTest
    @ValueSource(strings = {"r.csv", "r.csv.gz", "r.arff", "r.arff.gz"})
    void everyDoubleSurvives(String name) throws IOException {
        double[][] rows = rows();
        RowReader reader = new RecordingFile(write(name, rows)).open();
        assertEquals(CHANNELS, reader.channels());
        List<double[]> read = Samples.rows(reader);
        assertEquals(rows.length, read.size());
        for (int i = 0; i < rows.length; i++) {
            for (int j = 0; j < 3; j++) {
                assertSameBits(rows[i][j], read.get(i)[j], "row " + i + " column " + j);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"r.csv", "r.arff"})
    void metadataSurvivesInTheHeadAndTheContentIsRecognisedWhateverTheName(String name) throws IOException {
        Path other = folder.resolve("noname");
        Files.move(write(name, rows()), other);
        try (RowReader reader = new RecordingFile(other).open()) {
            assertEquals(METADATA, reader.metadata());
        }
    }

    @Test
    void wekaReadsTheArffToTheSameValues() throws IOException {
        double[][] rows = rows();
        ArffLoader loader = new ArffLoader();
        loader.setFile(write("r.arff", rows).toFile());
        Instances data = loader.getDataSet();
        assertEquals(rows.length, data.numInstances());
        assertEquals("head.acc.z", data.attribute(2).name());
        for (int i = 0; i < rows.length; i++) {
            for (int j = 0; j < 3; j++) {
                assertSameBits(rows[i][j], data.instance(i).value(j), "row " + i + " column " + j);
            }
        }
    }

    @Test
    void moaReadsTheArffToTheSameValues() throws IOException {
        double[][] rows = rows();
        ArffFileStream stream = new ArffFileStream(write("r.arff", rows).toString(), 3);
        stream.prepareForUse();
        for (int i = 0; i < rows.length; i++) {
            assertTrue(stream.hasMoreInstances(), "row " + i);
            Instance instance = stream.nextInstance().getData();
            for (int j = 0; j < 3; j++) {
                assertSameBits(rows[i][j], instance.value(j), "row " + i + " column " + j);
            }
        }
        assertFalse(stream.hasMoreInstances());
    }

    @Test
    void moasOwnTrailingCommaIsRead() throws IOException {
        RecordingFile file = Samples.recording(folder, "moa.arff",
                "@relation 'x -c 1'\n@attribute t numeric\n@ATTRIBUTE 'head.acc.z' REAL\n\n@DATA\n0,1.5,\n% between\n0.1,?,\n");
        List<double[]> rows = Samples.rows(file.open());
        assertArrayEquals(new double[] {0, 1.5}, rows.get(0));
        assertArrayEquals(new double[] {0.1, Double.NaN}, rows.get(1));
    }

    @Test
    void infinityIsRefusedAndNothingIsLeftBehind() throws IOException {
        Path path = folder.resolve("r.csv");
        try (RecordingWriter writer = RecordingWriter.create(path, CHANNELS, Metadata.NONE)) {
            assertThrows(IllegalArgumentException.class, () -> writer.write(new double[] {0, Double.POSITIVE_INFINITY, 0}));
        }
        try (var left = Files.list(folder)) {
            assertEquals(0, left.count());
        }
    }

    @Test
    void aFileThatWasThereStaysUntilTheNewOneIsFinished() throws IOException {
        Path path = Samples.file(folder, "r.csv", "old");
        try (RecordingWriter writer = RecordingWriter.create(path, CHANNELS, Metadata.NONE)) {
            writer.write(new double[] {0, 1, 2});
            assertEquals("old", Files.readString(path));
        }
        assertEquals("old", Files.readString(path));
        write("r.csv", new double[][] {{0, 1, 2}});
        assertTrue(Files.readString(path).endsWith("t,platform.acc.z,head.acc.z\n0,1,2\n"));
    }

    @Test
    void aWholeRecordingAndItsSidecarReadBack() throws IOException {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        values.put(CHANNELS.get(1), new double[] {1.5, Double.NaN, -0.25, 3});
        values.put(CHANNELS.get(0), new double[] {0.1, 0.2, 0.3, 0.4});
        Path path = folder.resolve("whole.csv.gz");
        RecordingWriter.write(path, new Recording(new Clock(2, 60), values, METADATA));
        Recording read = new RecordingFile(path).load();
        assertEquals(new Clock(2, 60), read.clock());
        assertEquals(List.copyOf(values.keySet()), read.channels());
        values.forEach((channel, samples) -> assertArrayEquals(samples, read.values(channel)));
        assertEquals(METADATA, read.metadata());
        assertEquals(METADATA, Sidecar.of(path).metadata());
    }
}

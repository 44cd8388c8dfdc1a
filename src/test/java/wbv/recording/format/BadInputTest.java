package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.RowSource;
import wbv.recording.inspect.Severity;

/** Each kind of bad input gives one clear line that names the file and, where there is one, the line. */
class BadInputTest {

    @TempDir
    Path folder;

    private void assertFault(RowSource source, String... words) {
        DataFault fault = assertThrows(DataFault.class, source::load);
        String message = fault.getMessage();
        assertFalse(message.contains("\n"), message);
        assertTrue(message.startsWith(source.toString()), message);
        for (String word : words) {
            assertTrue(message.contains(word), () -> "'" + word + "' is not in: " + message);
        }
    }

    private void assertFault(String name, String text, String... words) throws IOException {
        assertFault(Samples.recording(folder, name, text), words);
    }

    private void assertFault(String name, byte[] bytes, String... words) throws IOException {
        assertFault(new RecordingFile(Files.write(folder.resolve(name), bytes)), words);
    }

    @Test
    void missingFile() {
        assertFault(new RecordingFile(folder.resolve("none.csv")), "no such file");
    }

    @Test
    void directory() {
        assertFault(new RecordingFile(folder), "is a directory");
    }

    @Test
    void unreadableFile() throws IOException {
        Path path = Samples.file(folder, "r.csv", "t,head.acc.z\n0,1\n1,2\n");
        Assumptions.assumeTrue(Files.getFileStore(path).supportsFileAttributeView("posix"), "skipped: no permissions here");
        Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("---------"));
        Assumptions.assumeFalse(Files.isReadable(path), "skipped: this user may read everything");
        assertFault(new RecordingFile(path), "may not be read");
    }

    @Test
    void emptyFile() throws IOException {
        assertFault("r.csv", "", "is empty");
        assertFault("blank.csv", "\n \n\r\n", "is blank");
    }

    @Test
    void binaryFile() throws IOException {
        byte[] bytes = new byte[5000];
        new Random(1).nextBytes(bytes);
        assertFault("r.csv", bytes, "binary");
        assertFault("r.mvn", bytes, "binary", ".mvnx");
        assertFault("r.mtb", new byte[] {(byte) 0xFA, (byte) 0xFF, 1, 2, 3}, "MT Manager", ".txt");
        assertFault("r.xlsx", new byte[] {'P', 'K', 3, 4, 20, 0, 0, 0}, "export");
        assertFault("r16.csv", "\uFEFFt,head.acc.z\n0,1\n".getBytes("UTF-16LE"), "UTF-16");
    }

    @Test
    void headerOnly() throws IOException {
        assertFault("r.csv", "t,head.acc.z\n", "a header but no row");
        assertFault("r.arff", "@relation r\n@attribute t numeric\n@attribute head.acc.z numeric\n@data\n", "a header but no row");
        assertFault("m.txt", "// Update Rate: 100.0Hz\nPacketCounter\tAcc_X\n", "a header but no row");
    }

    @Test
    void oneSample() throws IOException {
        assertFault("r.csv", "t,head.acc.z\n0,1\n", "1 sample");
        assertFault("r2.csv", "t,head.acc.z\n0,1\n0,1\n", "at least two");
        assertFault("r3.csv", "t,head.acc.z\n0,1\n0,2\n0,3\n", "never increases");
        assertFault("r4.csv", "t,head.acc.z\n" + "7,1\n7,2\n".repeat(2000), "never increases over its 4000 rows");
    }

    @Test
    void aLocationThatIsNoWord() throws IOException {
        Path path = Samples.file(folder, "x.txt", "// Update Rate: 10Hz\nPacketCounter\tAcc_X\n1\t1\n2\t2\n");
        ReadOptions options = new ReadOptions(Optional.empty(), OptionalDouble.empty(), Map.of("x", "Left Shoulder"));
        assertFault(new RecordingFile(path, options), "'Left Shoulder'", "a-z");
    }

    @Test
    void textInANumberCellNamesLineAndColumn() throws IOException {
        assertFault("r.csv", "# made\nt,head.acc.z,seat.acc.z\n0,1,2\n1,2,3\n2,oops,4\n", "r.csv:5:", "head.acc.z", "'oops'");
        assertFault("r.arff", "@relation r\n@attribute t numeric\n@attribute head.acc.z numeric\n@data\n0,1\n1,x\n", "r.arff:6:",
                "'x'");
        assertFault("i.csv", "t,head.acc.z\n0,1\n1,Infinity\n", "i.csv:3:", "finite");
    }

    @Test
    void raggedRow() throws IOException {
        assertFault("r.csv", "t,head.acc.z\n0,1\n1\n", "r.csv:3:", "1 cell where", "2");
        assertFault("s.csv", "t,head.acc.z\n0,1\n1,2,3\n", "s.csv:3:", "3 cells");
    }

    @Test
    void rowWithoutTime() throws IOException {
        assertFault("r.csv", "t,head.acc.z\n0,1\n,2\n", "r.csv:3:", "no time");
    }

    @Test
    void columnsThatAreNoChannels() throws IOException {
        assertFault("r.csv", "t,Az\n0,1\n", "r.csv:1:", "'Az'", "--map");
        assertFault("s.csv", "time,az\n0,1\n", "s.csv:1:", "column t", "--map");
        assertFault("d.csv", "t,head.acc.z,head.acc.z\n0,1,2\n", "d.csv:1:", "stands twice");
        assertFault("q.csv", "t,head.acc.w\n0,1\n", "q.csv:1:", "one of xyz");
        assertFault("p.csv", "just some prose.\nAnd more of it.\n", "p.csv:1:");
    }

    @Test
    void arffOfOtherData() throws IOException {
        String iris = "% flowers\n@RELATION iris\n@ATTRIBUTE sepal REAL\n@ATTRIBUTE class {a,b}\n@DATA\n5.1,a\n";
        assertFault("iris.arff", iris, "iris.arff:4:", "class", "numeric");
        assertFault("n.arff", "@relation n\n@attribute a numeric\n@data\n1\n", "n.arff:3:", "column t");
        assertFault("s.arff", "@relation s\n@attribute t numeric\n@attribute head.acc.z string\n@data\n", "s.arff:3:", "string");
        assertFault("c.arff", "@relation s\n@attribute t numeric\n", "cut off");
    }

    @Test
    void missingChannelAndChannelWithoutANumber() throws IOException {
        RecordingFile file = Samples.recording(folder, "r.csv", "t,head.acc.z,seat.acc.z\n0,1,\n1,2,NaN\n2,3,?\n");
        Inspection inspection = file.inspect();
        inspection.require(Samples.HEAD);
        DataFault none = assertThrows(DataFault.class, () -> inspection.require(Channel.parse("pelvis.acc.z")));
        assertTrue(none.getMessage().contains("no channel pelvis.acc.z"), none.getMessage());
        DataFault nan = assertThrows(DataFault.class, () -> inspection.require(Channel.parse("seat.acc.z")));
        assertTrue(nan.getMessage().contains("holds no number"), nan.getMessage());
        Finding.Missing missing = Samples.find(inspection, Finding.Missing.class).orElseThrow();
        assertEquals(Severity.FAULT, missing.severity());
    }

    @Test
    void twoClocks() throws IOException {
        StringBuilder restart = new StringBuilder("t,head.acc.z\n");
        StringBuilder turns = new StringBuilder("t,head.acc.z\n");
        for (int i = 0; i < 100; i++) {
            restart.append(i % 50).append(',').append(Math.sin(i)).append('\n');
            turns.append(i + (i % 2) * 1000).append(',').append(Math.sin(i)).append('\n');
        }
        assertFault("r.csv", restart.toString(), "two clocks", "line 52", "starts again");
        assertFault("i.csv", turns.toString(), "two clocks", "line 3", "take turns");
    }

    @Test
    void gzipCutOffOrDamaged() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(bytes)) {
            gzip.write("t,head.acc.z\n".getBytes());
            Random random = new Random(4);
            for (int i = 0; i < 30_000; i++) {
                gzip.write((i + "," + random.nextGaussian() + "\n").getBytes());
            }
        }
        assertFault("r.csv.gz", Arrays.copyOf(bytes.toByteArray(), bytes.size() / 2), "cut off");
        assertFault("s.csv.gz", Arrays.copyOf(bytes.toByteArray(), 30), "cut off");
        assertFault("t.csv.gz", new byte[] {0x1f, (byte) 0x8b, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9}, "damaged");
    }

    @Test
    void writingWhereThereIsNoFolderOrToAnotherFormat() {
        List<Channel> channels = List.of(Samples.HEAD);
        DataFault none = assertThrows(DataFault.class,
                () -> RecordingWriter.create(folder.resolve("none/r.csv"), channels, Metadata.NONE));
        assertTrue(none.getMessage().contains("no folder"), none.getMessage());
        assertThrows(DataFault.class, () -> RecordingWriter.create(folder.resolve("r.xls"), channels, Metadata.NONE));
    }

    @Test
    void aTimeFarOffDoesNotFillTheDisk() throws IOException {
        assertFault("r.csv", "t,head.acc.z\n0,1\n0.01,2\n0.02,1\n0.03,2\n1e12,3\n", "a time in the file must be wrong");
    }

    /** Beyond 2^63 samples of 1/60 s a count would turn over and pass for a small one. */
    @ParameterizedTest
    @ValueSource(strings = {"1e9", "1e12", "1.6e17", "4e18", "1e300"})
    void aTimeFarOffIsSaidWhereverItIs(String time) throws IOException {
        StringBuilder text = new StringBuilder("t,head.acc.z\n");
        for (int i = 0; i < 700; i++) {
            text.append(i / 60.0).append(",").append(i % 7).append('\n');
        }
        assertFault("end.csv", text + time + ",1\n" + time + "5,2\n");
        assertFault("beginning.csv", text.toString().replaceFirst("0.0,0", "-" + time + ",0"));
    }

    @Test
    void whatNoSensorMeasuresIsRefusedWithItsLineAndChannel() throws IOException {
        assertFault("r.csv", "t,head.acc.z\n0,1\n0.01,-2e9\n0.02,1\n", ":3: ", "head.acc.z is -2.0E9 m/s²");
    }

    @Test
    void ratesThatNoRecordingHas() throws IOException {
        assertFault("r.csv", "t,head.acc.z\n0,1\n1e-300,2\n2e-300,1\n", "tell a rate of");
        assertFault("r.mvnx", "<mvnx><subject frameRate=\"2147483648\"><segments><segment label=\"Head\"/></segments><frames>"
                + "<frame index=\"0\"><acceleration>1 2 3</acceleration></frame></frames></subject></mvnx>", ":1: frameRate must be");
    }

    @Test
    void aPlaceholderStandsOnceInAPattern() throws IOException {
        Path map = Samples.file(folder, "map.json", "{\"time\": {\"rate_hz\": 60}, \"patterns\": [{\"column\": \"{axis}_{axis}\", "
                + "\"channel\": \"head.acc.{axis}\"}]}");
        DataFault fault = assertThrows(DataFault.class, () -> ColumnMap.read(map));
        assertTrue(fault.getMessage().startsWith(map + ": 'patterns[0].column'"), fault.getMessage());
    }

    /** Time that grows with the square of the blanks would take minutes. */
    @Test
    void aMegabyteOfBlanksInACommentIsReadAndWritten() throws IOException {
        String note = "a" + " ".repeat(1 << 20) + "b";
        RecordingFile file = Samples.recording(folder, "r.csv", "# note: " + note + "\nt,head.acc.z\n0,1\n0.01,2\n0.02,3\n");
        RecordingWriter.write(folder.resolve("copy.csv"), file.load());
        assertEquals(note, new RecordingFile(folder.resolve("copy.csv")).load().metadata().notes().get("note"));
    }
}

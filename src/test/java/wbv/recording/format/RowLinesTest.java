package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.RowReader;

class RowLinesTest {

    @TempDir
    private Path folder;

    private final List<double[]> rows = new ArrayList<>();
    private final List<String> seats = new ArrayList<>();
    private List<Channel> channels = List.of();

    private void take(RowLines lines, String text) {
        for (String line : text.split("\n", -1)) {
            byte[] bytes = ("xx" + line + "yy").getBytes(StandardCharsets.UTF_8);
            lines.accept(bytes, 2, bytes.length - 2, (seat, of, row) -> {
                seats.add(seat);
                channels = of;
                rows.add(row.clone());
            });
        }
    }

    private static RowLines lines() {
        return new RowLines("test", ReadOptions.DEFAULT);
    }

    /** The same file, read as a recording and as a stream, gives the same numbers. */
    @ParameterizedTest
    @ValueSource(strings = {"data/arff/one-dof-linear.arff", "data/arff/ride-subject1.arff"})
    void rowsAreThoseOfTheRecording(String file) throws IOException {
        same(Path.of(file));
    }

    @Test
    void theRowsOfADotAreThoseOfItsExport() throws IOException {
        String text = "sep=,\nDeviceTag:,D422CD0060A5\nOutputRate:,60Hz\n\nPacketCounter,SampleTimeFine,Quat_W,FreeAcc_X,FreeAcc_Z,Gyr_Y\n"
                + "1,4294950628,1,0.5,-0.25,180\n2,4294967295,0.9,0.4,,90\n3,16666,0.8,0.3,-0.5,45\n";
        same(Samples.file(folder, "dot.csv", text));
        assertEquals(List.of(Math.PI, Math.PI / 2, Math.PI / 4), rows.stream().map(row -> row[1 + 3]).toList());
        assertEquals(0.033334, rows.get(2)[0] - rows.get(0)[0], 1e-9);
    }

    private void same(Path file) throws IOException {
        RowReader reader = new RecordingFile(file).open();
        List<double[]> expected = Samples.rows(reader);
        take(lines(), Files.readString(file));
        assertEquals(reader.channels(), channels);
        assertEquals(expected.size(), rows.size());
        double offset = rows.get(0)[0] - expected.get(0)[0];
        for (int i = 0; i < rows.size(); i++) {
            assertEquals(expected.get(i)[0], rows.get(i)[0] - offset, 1e-6, "time of row " + i);
            rows.get(i)[0] = expected.get(i)[0];
            assertArrayEquals(expected.get(i), rows.get(i), "row " + i);
        }
    }

    @Test
    void objectsHoldRowsAndListsOfThem() {
        RowLines lines = lines();
        take(lines, "{\"seat\": \"truck 7\", \"t\": 0.5, \"seat.acc.z\": 0.25, \"head.acc.z\": null}\n"
                + "  {\"seat\": 8, \"t\": [1, 1.5], \"seat.acc.z\": [3, null], \"head.acc.z\": [5, 6]}\r");
        assertEquals(List.of("truck 7", "8", "8"), seats);
        assertArrayEquals(new double[] {0.5, 0.25, Double.NaN}, rows.get(0));
        assertArrayEquals(new double[] {1, 3, 5}, rows.get(1));
        assertArrayEquals(new double[] {1.5, Double.NaN, 6}, rows.get(2));
    }

    @Test
    void aSensorsTagSaysWhereItSat() {
        RowLines lines = new RowLines("test", new ReadOptions(Optional.empty(), OptionalDouble.empty(), Map.of("D4:22", "head")));
        take(lines, "{\"sensor\":\"D4:22\",\"SampleTimeFine\":1000000,\"FreeAcc_Z\":2,\"Gyr_X\":180}");
        assertEquals(List.of(Channel.parse("head.acc.z"), Channel.parse("head.gyr.x")), channels);
        assertArrayEquals(new double[] {1, 2, Math.PI}, rows.get(0));
    }

    @Test
    void aColumnSaysWhoseRowItIs() {
        take(lines(), "t;seat;seat.acc.z\n0,5;\"truck 7\";1,25\n1;8;2");
        assertEquals(List.of("truck 7", "8"), seats);
        assertArrayEquals(new double[] {0.5, 1.25}, rows.get(0));
    }

    @Test
    void aHeaderMayComeAgainAndBeAnother() {
        take(lines(), "# made by hand\nt,seat.acc.z\n0,1\nt,seat.acc.z\n1,2\n\nt,head.acc.z\n2,3");
        assertEquals(3, rows.size());
        assertEquals(List.of(Channel.parse("head.acc.z")), channels);
    }

    @Test
    void aMapNamesForeignColumns() throws IOException {
        Path map = Samples.file(folder, "map.json",
                "{\"time\": {\"column\": \"ms\", \"unit\": \"ms\"}, \"channels\": {\"seat.acc.z\": {\"column\": \"az\", \"unit\": "
                        + "\"g\"}}}");
        RowLines lines = new RowLines("test", new ReadOptions(Optional.of(ColumnMap.read(map)), OptionalDouble.empty(), Map.of()));
        take(lines, "ms,ax,az\n500,9,2");
        assertArrayEquals(new double[] {0.5, 2 * 9.80665}, rows.get(0));
    }

    /** What cannot be read is refused with its line and its reason, and the row after it is read as if it had not been there. */
    @ParameterizedTest
    @CsvSource(delimiter = '|',
            value = {"1,2,3|has 3 cells where the header names 2", "1|has 1 cell where", "1,x|column seat.acc.z must be a finite number",
                ",1|the row has no time", "1e300,1|is not within", "1,1e12|which no sensor measures", "{\"t\":1|is not JSON",
                "{\"t\":1,\"t\":2,\"seat.acc.z\":1}|is not JSON: Duplicate field", "{\"t\":1}|but no channel",
                "{\"seat.acc.z\":1}|must have a column t",
                "{\"t\":\"1\",\"seat.acc.z\":1}|field t must be a number", "{\"t\":[1,2],\"seat.acc.z\":[1]}|equally long",
                "{\"t\":[],\"seat.acc.z\":[]}|equally long",
                "{\"t\":[1,2],\"seat.acc.z\":3}|must be a list", "{\"t\":1,\"seat.acc.z\":1} {}|is not one JSON object",
                "{\"t\":{\"a\":1}}|must be a number",
                "{\"t\":1,\"seat\":[1],\"seat.acc.z\":1}|must be a word", "{\"t\":1e999,\"seat.acc.z\":1}|finite",
                "{\"t\":1,\"seat.acc.zz\":1}|a channel is named",
                "{\"SampleTimeFine\":-1,\"Acc_X\":1}|counts microseconds", "t,nonsense|a channel is named", "t,t|stands twice",
                "@nonsense|attribute lines only"})
    void aLineThatCannotBeReadIsRefusedByItself(String bad, String why) {
        RowLines lines = lines();
        take(lines, "t,seat.acc.z\n0,1");
        DataFault fault = assertThrows(DataFault.class, () -> take(lines, bad));
        assertTrue(fault.getMessage().startsWith("test:3: ") && fault.getMessage().contains(why), fault.getMessage());
        take(lines, "2,3");
        assertArrayEquals(new double[] {2, 3}, rows.get(1));
    }

    @Test
    void rowsWithoutAHeaderAreRefused() {
        DataFault fault = assertThrows(DataFault.class, () -> take(lines(), "1,2"));
        assertTrue(fault.getMessage().contains("no header yet"), fault.getMessage());
    }
}

package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.RowReader;

class ColumnMapTest {

    @TempDir
    Path folder;

    private RecordingFile mapped(String table, String map) throws IOException {
        ColumnMap read = ColumnMap.read(Samples.file(folder, "map.json", map));
        return new RecordingFile(Samples.file(folder, "r.csv", table), new ReadOptions(Optional.of(read), OptionalDouble.empty(),
                Map.of()));
    }

    @ParameterizedTest
    @CsvSource({"acc, g, 1, 9.80665", "acc, mg, 1000, 9.80665", "acc, m/s^2, 3, 3", "acc, m/s², 3, 3",
        "gyr, deg/s, 180, 3.141592653589793", "gyr, °/s, 180, 3.141592653589793",
        "gyr, rpm, 30, 3.141592653589793", "pos, mm, 7, 0.007", "pos, um, 7, 7e-6",
        "pos, in, 1, 0.0254", "vel, mm/s, 3, 0.003", "vel, km/h, 36, 10", "force, kN, 2.5, 2500",
        "ang, deg, 90, 1.5707963267948966", "force, lbf, 1, 4.4482216152605"})
    void unitsComeOutInSiWithTheExactFactor(String quantity, String unit, double value, double si) throws IOException {
        RecordingFile file = mapped("time,a\n0," + value + "\n1," + value + "\n",
                "{\"time\": {\"column\": \"time\"}, \"channels\": {\"seat."
                        + quantity + ".z\": {\"column\": \"a\", \"unit\": \"" + unit + "\"}}}");
        assertEquals(si, Samples.rows(file.open()).get(0)[1], unit.equals("rpm") ? Math.ulp(si) : 0);
    }

    @Test
    void patternsNameManyColumnsAndOthersAreLeftOut() throws IOException {
        RecordingFile file = mapped("\"note; free\";\"Time (ms)\";Seat_aX;Seat_aZ;Head_wY\n\"a;b\";1000;1;2;90\nx;1010;-1,5;?;\n",
                """
                        {"comment": "a logger", "time": {"column": "Time (ms)", "unit": "ms", "from_zero": true},
                         "channels": {"seat.acc.z": {"column": "Seat_aZ", "unit": "g", "scale": -1}},
                         "patterns": [{"column": "{location}_a{axis}", "channel": "{location}.acc.{axis}", "unit": "m/s2"},
                                      {"column": "{location}_w{axis}", "channel": "{location}.gyr.{axis}", "unit": "deg/s"}]}""");
        RowReader reader = file.open();
        assertEquals("seat.acc.z seat.acc.x head.gyr.y",
                reader.channels().stream().map(Channel::toString).collect(Collectors.joining(" ")));
        List<double[]> rows = Samples.rows(reader);
        assertArrayEquals(new double[] {0, -2 * 9.80665, 1, Math.PI / 2}, rows.get(0));
        assertArrayEquals(new double[] {0.01, Double.NaN, -1.5, Double.NaN}, rows.get(1), 1e-15);
    }

    @Test
    void aTableWithoutTimesIsCounted() throws IOException {
        RecordingFile file = mapped("logger 7\nserial,12\naz\n1\n2\n3\n",
                "{\"time\": {\"rate_hz\": 50}, \"channels\": {\"seat.acc.z\": {\"column\": \"az\"}}}");
        assertEquals(new Clock(0, 50), file.inspect().clock());
        assertEquals(3, file.inspect().rows());
    }

    private void assertFault(String map, String... words) throws IOException {
        DataFault fault = assertThrows(DataFault.class, () -> mapped("t_s,az\n0,1\n1,2\n", map).load());
        for (String word : words) {
            assertTrue(fault.getMessage().contains(word), () -> "'" + word + "' is not in: " + fault.getMessage());
        }
    }

    @Test
    void faultsNameTheField() throws IOException {
        assertFault("{\"channels\": {\"seat.acc.z\": {\"column\": \"az\"}}}", "map.json", "'time'");
        assertFault("{\"time\": {\"unit\": \"s\"}}", "'time'", "column");
        assertFault("{\"time\": {\"column\": \"t_s\", \"unit\": \"g\"}}", "'time.unit'", "ms");
        assertFault("{\"time\": {\"column\": \"t_s\"}, \"channels\": {\"az\": {\"column\": \"az\"}}}", "'channels.az'");
        assertFault("{\"time\": {\"column\": \"t_s\"}, \"channels\": {\"seat.acc.z\": {\"column\": \"az\", \"unit\": \"deg/s\"}}}",
                "'channels.seat.acc.z.unit'", "mg");
        assertFault("{\"time\": {\"column\": \"t_s\"}, \"channels\": {\"a.acc.z\": {\"column\": \"az\", \"unti\": \"g\"}}}",
                "unti");
        assertFault("{\"time\": {\"column\": \"t_s\"}, \"channels\": {\"seat.acc.z\": {\"column\": \"bz\"}}}", "r.csv:1", "'bz'");
        assertFault("{\"time\": {\"column\": \"T\"}, \"channels\": {\"seat.acc.z\": {\"column\": \"az\"}}}", "r.csv", "'T'");
        assertFault("{\"time\": {\"column\": \"t_s\"}}", "at least one column");
        assertFault("{\"time\": {\"column\": \"t_s\"}, \"patterns\": [{\"column\": \"x\"}]}", "'patterns[0].channel'");
        assertFault("{\"time\": ", "map.json:1", "not JSON");
        assertFault("[]", "JSON object");
    }
}

package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.OffsetDateTime;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.DataFault;

/** Dates and times in the column of times; the oracle is {@code java.time}. */
class TimestampsTest {

    @TempDir
    private Path folder;

    private List<double[]> rows(String first, String second) throws IOException {
        return Samples.rows(Samples.recording(folder, "r.csv", "t;head.acc.z\n" + first + ";1\n" + second + ";2\n").open());
    }

    @ParameterizedTest
    @CsvSource({"2025-03-04T10:00:00.000, 2025-03-04T10:00:00.017, 0.017", "2025-03-04 10:00:00, 2025-03-04 10:00:01, 1",
        "2024-02-28T23:59:59.5Z, 2024-02-29T00:00:00Z, 0.5", "2025-03-30T01:59:59+01:00, 2025-03-30T03:00:00+0200, 1",
        "1969-12-31T23:59:59.123456789-05, 1969-12-31T23:59:59.123457789-05, 1e-6", "\"2025-03-04T10:00:00\", 2025-03-05T10:00:00, 86400"})
    void theyAreSecondsFromTheFirst(String first, String second, double apart) throws IOException {
        List<double[]> rows = rows(first, second);
        assertArrayEquals(new double[] {0, 1}, rows.get(0));
        assertEquals(apart, rows.get(1)[0], 1e-15);
        String zoned = first.contains("Z") ? first : "";
        if (!zoned.isEmpty()) {
            Timestamps clock = new Timestamps();
            clock.of(zoned);
            assertEquals(OffsetDateTime.parse(zoned).toInstant().toEpochMilli() / 1e3, clock.origin().orElseThrow().seconds());
        }
    }

    @ParameterizedTest
    @CsvSource({"2025-03-04T10:00:00, 0.5", "2025-03-04T10:00:00, 2025-03-04T10:00:01Z", "2025-03-04T10:00:00, 2025-02-30T10:00:00",
        "2025-03-04T10:00:00, 2025-03-04T25:00:00", "2025-03-04T10:00:00, 2025-03-04T10:00:01.", "0, 2025-03-04T10:00:00"})
    void whatIsNotAsTheFirstIsRefusedWithItsLine(String first, String second) {
        String told = assertThrows(DataFault.class, () -> rows(first, second)).getMessage();
        assertTrue(told.contains("r.csv:3: column t must be") && told.contains(second), told);
    }

    @ParameterizedTest
    @ValueSource(strings = {"Timestamp", "Datum"})
    void aDraftedMapTakesThemForTimes(String name) throws IOException {
        StringBuilder text = new StringBuilder(name + ",Seat X [g],Seat Z [g]\n");
        for (int i = 0; i < 40; i++) {
            text.append("2025-03-04T10:15:00.").append(String.format("%03d", 5 * i)).append(",0.1,1.0").append(i % 7).append('\n');
        }
        Path file = Samples.file(folder, "r.csv", text.toString());
        MapDraft draft = MapDraft.of(file);
        assertEquals(List.of(), draft.questions());
        assertTrue(draft.lines().get(0).startsWith(name + ": time in s, 200 samples a second"), draft.lines().get(0));
        Path map = Files.writeString(folder.resolve("map.json"), draft.json("r.csv"));
        List<double[]> rows = mapped(file, map);
        assertEquals(0.195, rows.get(39)[0], 1e-15);
        Files.writeString(map, draft.json("r.csv").replace("\"unit\" : \"s\"", "\"unit\" : \"ms\""));
        assertTrue(assertThrows(DataFault.class, () -> mapped(file, map)).getMessage().contains("no unit and no scale"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"04.03.2025 10:15:%02d", "3/4/2025 10:15:%02d PM", "10:15:%02d,25"})
    void aDraftedMapAsksForClocksThatItDoesNotRead(String clock) throws IOException {
        StringBuilder alone = new StringBuilder("Zeit;Seat X [g];Seat Z [g]\n");
        StringBuilder beside = new StringBuilder("Zeit;t [s];Seat X [g];Seat Z [g]\n");
        for (int i = 0; i < 40; i++) {
            String now = String.format(clock, i) + ";";
            String values = "0,1;1,0" + i % 7 + "\n";
            alone.append(now).append(values);
            beside.append(now).append(i).append(';').append(values);
        }
        String asked = MapDraft.of(Samples.file(folder, "r.csv", alone.toString())).questions().get(0);
        assertTrue(asked.startsWith("When is '" + String.format(clock, 0) + "' of 'Zeit'?"), asked);
        assertTrue(asked.contains("2025-03-04T10:15:00.005"), asked);
        assertEquals(List.of(), MapDraft.of(Samples.file(folder, "t.csv", beside.toString())).questions());
    }

    private static List<double[]> mapped(Path file, Path map) throws IOException {
        return Samples.rows(new RecordingFile(file, new ReadOptions(Optional.of(ColumnMap.read(map)), OptionalDouble.empty(), Map.of()))
                .open());
    }

    /** Each counts from its own first row, which are half a second apart. */
    @Test
    void filesAreJoinedByTheirDates() throws IOException {
        RecordingFile late = Samples.recording(folder, "a.csv",
                "# rate: 2 Hz\nt,head.acc.z\n2025-03-04T10:00:00.5,1\n2025-03-04T10:00:01,2\n");
        RecordingFile early = Samples.recording(folder, "b.csv",
                "# rate: 2 Hz\nt,seat.acc.z\n2025-03-04T10:00:00,3\n2025-03-04T10:00:00.5,4\n");
        List<double[]> rows = Samples.rows(new MergedReader(List.of(late.open(), early.open())));
        assertArrayEquals(new double[] {0, Double.NaN, 3}, rows.get(0));
        assertArrayEquals(new double[] {0.5, 1, 4}, rows.get(1));
        assertArrayEquals(new double[] {1, 2, Double.NaN}, rows.get(2));
        RecordingFile counted = Samples.recording(folder, "c.csv", "# rate: 2 Hz\nt,back.acc.z\n0,1\n0.5,2\n");
        String told = assertThrows(DataFault.class, () -> new MergedReader(List.of(late.open(), counted.open()))).getMessage();
        assertTrue(told.contains("share no clock"), told);
        RecordingFile zoned = Samples.recording(folder, "d.csv",
                "# rate: 2 Hz\nt,back.acc.z\n2025-03-04T10:00:00Z,1\n2025-03-04T10:00:00.5Z,2\n");
        String apart = assertThrows(DataFault.class, () -> new MergedReader(List.of(late.open(), zoned.open()))).getMessage();
        assertTrue(apart.contains("may be hours apart"), apart);
    }
}

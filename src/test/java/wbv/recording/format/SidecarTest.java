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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.RowReader;

class SidecarTest {

    @TempDir
    Path folder;

    private RowReader open(String json) throws IOException {
        Samples.file(folder, "r.json", json);
        return Samples.recording(folder, "r.csv",
                "# rate: 50 Hz\n# task: from the file\nt,seat.acc.y,seat.acc.z,head.acc.z\n0,1,2,3\n1,2,3,4\n")
                .open();
    }

    @Test
    void itStandsBesideTheRecordingWhateverItsEnding() {
        assertEquals(Path.of("a/r.json"), Sidecar.beside(Path.of("a/r.csv")));
        assertEquals(Path.of("a/r.json"), Sidecar.beside(Path.of("a/r.csv.gz")));
        assertEquals(Path.of("r.v2.json"), Sidecar.beside(Path.of("r.v2.arff")));
        assertEquals(Path.of("r.json"), Sidecar.beside(Path.of("r")));
    }

    @Test
    void itGoesBeforeTheFileAndFillsIn() throws IOException {
        Metadata metadata = open("""
                {"rate_hz": 60, "daily_minutes": 380, "subject": {"mass_kg": 79.4, "sex": "male"},
                 "serials": {"seat": "00B4", "head": "00A1"},
                 "notes": {"b": "1", "a": "2"}}""").metadata();
        assertEquals(OptionalDouble.of(60), metadata.rate());
        assertEquals("from the file", metadata.task().orElseThrow());
        assertEquals(380, metadata.dailyMinutes().orElseThrow());
        assertEquals(79.4, metadata.subject().orElseThrow().mass().orElseThrow());
        assertEquals(List.of("seat", "head"), List.copyOf(metadata.serials().keySet()));
        assertEquals(List.of("b", "a"), List.copyOf(metadata.notes().keySet()));
    }

    @Test
    void axesMountedTheWrongWayRoundAreTurned() throws IOException {
        assertArrayEquals(new double[] {0, -1, -2, 3},
                Samples.rows(open("{\"axis_signs\": {\"seat\": {\"y\": -1, \"z\": -1}}}")).get(0));
    }

    private void assertFault(String json, String... words) {
        DataFault fault = assertThrows(DataFault.class, () -> open(json));
        for (String word : words) {
            assertTrue(fault.getMessage().contains(word), () -> "'" + word + "' is not in: " + fault.getMessage());
        }
    }

    @Test
    void faultsNameTheField() {
        assertFault("{\"rate_hz\": -1}", "r.json", "'rate_hz'");
        assertFault("{\"rate_hz\": \"60\"}", "'rate_hz'");
        assertFault("{\"subject\": {\"mass\": 80}}", "'subject.mass'", "mass_kg");
        assertFault("{\"subject\": {\"mass_kg\": 7940}}", "'subject.mass_kg'");
        assertFault("{\"daily_minutes\": 2000}", "'daily_minutes'", "1440");
        assertFault("{\"axis_signs\": {\"seat\": {\"y\": 0.5}}}", "'axis_signs.seat.y'");
        assertFault("{\"axis_signs\": {\"toe\": {\"y\": -1}}}", "'axis_signs.toe'");
        assertFault("{\"task\": {}}", "'task'");
        assertFault("{\"task\": \"a\",}", "r.json:1", "JSON");
    }

    @Test
    void theUserGoesBeforeIt() throws IOException {
        Samples.file(folder, "r.json", "{\"rate_hz\": 60}");
        Path path = Samples.file(folder, "r.csv", "t,head.acc.z\n0,1\n1,2\n");
        ReadOptions options = new ReadOptions(Optional.empty(), OptionalDouble.of(1), Map.of());
        assertEquals(OptionalDouble.of(1), new RecordingFile(path, options).open().metadata().rate());
    }
}

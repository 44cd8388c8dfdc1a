package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SuspensionSeatTest {

    @TempDir
    private Path room;

    @Test
    void comparesAndReports() throws IOException {
        Path out = room.resolve("out");
        Run run = Run.of("seat", "--floor", "em4,road:B:40", "--mass", "70", "--controller", "passive", "--seconds", "5", "--jolt", "4",
                "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("EM4, graders") && run.out().contains("road of class B") && run.out().contains("skyhook"), run.out());
        String page = Files.readString(out.resolve("report.html"));
        assertTrue(page.contains("SEAT over stroke") && page.contains("assumed"));
        assertTrue(Files.readString(out.resolve("seat.json")).contains("\"simulated\" : true"));
    }

    /** A person on a cushion is no inert mass on a suspension: the figures are there, and what they are worth. */
    @Test
    void testsARecordedSeat() throws IOException {
        Path out = room.resolve("out");
        Run run = Run.of("seat", "--recording", "data/arff/ride-subject1.arff", "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("platform.acc.z to seat.acc.z") && run.out().contains("(assumed)"), run.out());
        assertTrue(Files.readString(out.resolve("report.html")).contains("ISO 10326-1"));
        assertTrue(Files.readString(out.resolve("seat.json")).contains("\"wbv-seat-test\""));
        Run none = Run.of("seat", "--recording", "data/arff/one-dof-linear.arff", "--out", room.resolve("none").toString());
        assertEquals(1, none.code());
        assertTrue(none.err().contains("a test of a seat needs its sensor"), none.err());
        assertFalse(Files.exists(room.resolve("none")));
    }

    @ParameterizedTest
    @CsvSource({"--floor, EM10, EM1 to EM9", "--floor, road:C, road:CLASS:KM_PER_H", "--floor, road:C:900, 0 to 200 km/h",
        "--mass, 5, 30 to 200 kg",
        "--controller, magic, clipped-lqg", "--seconds, 1, 5 to 600", "--sitters, 0, 1 to 1000", "--faults, 0, 1 to 100000"})
    void wrongUsageIsOneLine(String option, String value, String hint) {
        Run run = Run.of("seat", option, value, "--out", room.resolve("none").toString());
        assertEquals(2, run.code());
        assertTrue(run.err().contains(hint), run.err());
        assertFalse(Files.exists(room.resolve("none")));
    }
}

package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.DataFault;
import wbv.recording.RowReader;

/** Units that stand beside the numbers of a table that is named as ours are, and times that stand nowhere. */
class StatedUnitsTest {

    private static final double GRAVITY = 9.80665;

    @TempDir
    Path folder;

    private double[] second(String csv) throws IOException {
        try (RowReader reader = Samples.recording(folder, "r.csv", csv).open()) {
            return Samples.rows(reader).get(1);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"t_ms,rail.acc.y [g],ram.force.x_kN", "t [ms],rail.acc.y (g),ram.force.x {kN}",
        "t(ms),rail.acc.y_g,ram.force.x [kN]",
        "t_ms,rail.acc.y_G,ram.force.x_kN"})
    void aUnitBehindANameIsTakenOff(String header) throws IOException {
        assertArrayEquals(new double[] {0.004, 2 * GRAVITY, 3000}, second(header + "\n0,1,1\n4,2,3\n"), 1e-12);
    }

    @Test
    void aRowOfUnitsBelowTheNamesIsRead() throws IOException {
        assertArrayEquals(new double[] {0.5, 0.002, 3}, second("t,ram.pos.x,ram.force.x\ns,mm,N\n0,1,1\n0.5,2,3\n"), 1e-12);
    }

    @Test
    void numbersAreNoUnits() throws IOException {
        assertArrayEquals(new double[] {1, 1}, second("t,ram.pos.x\n0,1\n1,1\n"));
    }

    @Test
    void theSidecarStatesThemByTheClosestName() throws IOException {
        Samples.file(folder, "r.json", "{\"units\": {\"t\": \"us\", \"acc\": \"mg\", \"rail.acc\": \"g\", \"rail.acc.z\": \"m/s2\"}}");
        assertArrayEquals(new double[] {0.5, 0.002 * GRAVITY, 2 * GRAVITY, 2},
                second("t,bogie.acc.y,rail.acc.y,rail.acc.z\n0,1,1,1\n500000,2,2,2\n"), 1e-12);
    }

    @Test
    void whatIsStatedIsKnown() throws IOException {
        try (RowReader reader = Samples.recording(folder, "r.csv", "t,rail.acc.y [m/s^2],rail.acc.z\n0,1,1\n1,2,2\n").open()) {
            assertEquals(Set.of("rail.acc.y"), reader.metadata().units().keySet());
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "t,rail.acc.y [parsec]|{}|r.csv:1: the unit of 'rail.acc.y' must be one of m/s2",
        "t,rail.acc.y_mm|{}|must be one of m/s2",
        "t,rail.acc.y|{\"units\": {\"rail.acc.y\": \"kN\"}}|must be one of m/s2",
        "t,rail.acc.y|{\"units\": {\"rail.acc.y\": \"parsec\"}}|'units.rail.acc.y' is no unit that is known",
        "t,rail.acc.y|{\"units\": {\"reil.acc\": \"g\"}}|no column that 'reil.acc' in the sidecar's 'units' is about",
        "t,rail.acc.y [g]|{\"units\": {\"acc\": \"mg\"}}|is in g by the header and in mg by the sidecar",
        "rail.acc.y|{}|no column t of times; say the rate: --rate HZ"})
    void whatCannotBeIsSaid(String header, String sidecar, String words) throws IOException {
        Samples.file(folder, "r.json", sidecar);
        RecordingFile file = Samples.recording(folder, "r.csv", header + "\n0,1\n1,2\n");
        DataFault fault = assertThrows(DataFault.class, file::open);
        assertTrue(fault.getMessage().contains(words), fault.getMessage());
    }

    @Test
    void whatSaysItsUnitsItselfTakesNoneFromTheSidecar() throws IOException {
        Samples.file(folder, "r.json", "{\"units\": {\"acc\": \"g\"}}");
        Path table = Samples.file(folder, "r.csv", "time,a\n0,1\n1,2\n");
        ColumnMap map = ColumnMap.read(
                Samples.file(folder, "map.json",
                        "{\"time\": {\"column\": \"time\"}, \"channels\": {\"rail.acc.z\": {\"column\": \"a\"}}}"));
        RecordingFile file = new RecordingFile(table, new ReadOptions(Optional.of(map), OptionalDouble.empty(), Map.of()));
        assertTrue(assertThrows(DataFault.class, file::open).getMessage().contains("has its units from the map"));
    }

    @Test
    void rowsWithoutTimesComeAtTheRateThatIsSaid() throws IOException {
        Path table = Samples.file(folder, "r.csv", "rail.acc.y,rail.acc.z\n1,2\n3,4\n");
        RecordingFile file = new RecordingFile(table, new ReadOptions(Optional.empty(), OptionalDouble.of(8), Map.of()));
        try (RowReader reader = file.open()) {
            assertArrayEquals(new double[] {0.125, 3, 4}, Samples.rows(reader).get(1));
        }
    }

    @Test
    void rowsWithoutTimesComeAtTheRateOfTheSidecar() throws IOException {
        Samples.file(folder, "r.json", "{\"rate_hz\": 250}");
        try (RowReader reader = Samples.recording(folder, "r.arff", "@relation r\n@attribute rail.acc.y numeric\n@data\n1\n3\n").open()) {
            assertArrayEquals(new double[] {0.004, 3}, Samples.rows(reader).get(1));
        }
    }

    private RecordingFile ticking(String time, double step) throws IOException {
        StringBuilder text = new StringBuilder(time + ",rail.acc.y\n");
        for (int i = 0; i < 3000; i++) {
            text.append(Math.round(10 * step * i) / 10.0).append(',').append(Math.sin(0.7 * i)).append('\n');
        }
        return Samples.recording(folder, "r.csv", text.toString());
    }

    @ParameterizedTest
    @CsvSource({"1,ms", "4,ms", "16.7,ms", "1000,us", "16667,us"})
    void timesThatAreTooSlowForSecondsAreAskedFor(double step, String unit) throws IOException {
        RecordingFile file = ticking("t", step);
        String fault = assertThrows(DataFault.class, file::inspect).getMessage();
        assertTrue(fault.contains("look to be in " + unit + "; name their column t_" + unit), fault);
        double factor = unit.equals("ms") ? 1e3 : 1e6;
        assertEquals(factor / step, ticking("t_" + unit, step).inspect().clock().rate(), 0.01 * factor / step);
    }

    @Test
    void whatIsSoSlowMaySaySo() throws IOException {
        assertEquals(0.25, ticking("t_s", 4).inspect().clock().rate(), 1e-6);
        assertEquals(0.25, ticking("t [s]", 4).inspect().clock().rate(), 1e-6);
        Samples.file(folder, "r.json", "{\"rate_hz\": 0.25}");
        assertEquals(0.25, ticking("t", 4).inspect().clock().rate(), 1e-6);
    }
}

package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Severity;
import wbv.recording.inspect.Summary;

/**
 * Recordings measured by others, beside the project where they are. The expected numbers were computed from the files with NumPy
 * (counts of rows, differences of the counters, means and standard deviations of the columns as they stand), not with this
 * program.
 */
class RealRecordingsTest {

    private static void assertSummary(Inspection inspection, String channel, double mean, double rms) {
        Summary summary = inspection.summaries().get(Channel.parse(channel));
        assertEquals(mean, summary.mean(), 1e-9, channel);
        assertEquals(rms, summary.rms(), 1e-9, channel);
    }

    private static RecordingFile export(String name) {
        return new RecordingFile(Samples.shared("real/exports").resolve(name));
    }

    private static void assertHealthy(Inspection inspection) {
        assertEquals(List.of(), inspection.findings());
    }

    @Test
    void mtManagerTabsWithEmptyCellsAndRotationMatrix() throws IOException {
        Inspection inspection = export("MT_012005D6_009-001_00B421EE.txt").inspect();
        assertEquals(2452, inspection.rows());
        assertEquals(2452, inspection.samples());
        assertEquals(new Clock(0, 100), inspection.clock());
        assertSummary(inspection, "sensor_00b421ee.accg.x", 9.655362480831974, 1.2166687104072538);
        assertSummary(inspection, "sensor_00b421ee.accg.z", 0.5654459033442089, 1.5131730856888377);
        assertHealthy(inspection);
    }

    @Test
    void mtManagerCommasWithQuaternion() throws IOException {
        Inspection inspection = export("S02-Trial-Walk-1-000_00B40C55.txt").inspect();
        assertEquals(2503, inspection.rows());
        assertEquals(2503, inspection.samples());
        assertEquals(new Clock(0, 100), inspection.clock());
        assertSummary(inspection, "sensor_00b40c55.accg.z", 8.848484941669996, 2.1778738853598516);
        assertSummary(inspection, "sensor_00b40c55.gyr.y", 0.014850448661606059, 1.4354562105529853);
        assertSummary(inspection, "sensor_00b40c55.mag.x", 0.5643776044746305, 0.17204951067828184);
        assertSummary(inspection, "sensor_00b40c55.quat.w", -0.6853999256891731, 0.08725352366398696);
        assertHealthy(inspection);
    }

    @Test
    void olderMtExport() throws IOException {
        Inspection inspection = export("data_xsens.txt").inspect();
        assertEquals(953, inspection.rows());
        assertEquals(953, inspection.samples());
        assertEquals(new Clock(0, 50), inspection.clock());
        assertSummary(inspection, "data_xsens.accg.y", 8.877922822665267, 2.5345205547348817);
        assertSummary(inspection, "data_xsens.gyr.x", 0.037955020986358876, 0.522930869807642);
        assertSummary(inspection, "data_xsens.quat.z", 0.4216412140608604, 0.20534994072681423);
        assertHealthy(inspection);
    }

    @Test
    void dotWithAllItsPackets() throws IOException {
        Inspection inspection = export("Pelvis_20210820_202113_836.csv").inspect();
        assertEquals(382, inspection.rows());
        assertEquals(382, inspection.samples());
        assertEquals(new Clock(0, 60), inspection.clock());
        assertSummary(inspection, "yao.acc.z", -0.03146137434554973, 2.7223413096198645);
        assertSummary(inspection, "yao.quat.y", -0.811258445026178, 0.0812237686819332);
        assertHealthy(inspection);
    }

    @Test
    void dotWithNearlyHalfItsPacketsLost() throws IOException {
        Inspection inspection = export("LFemur_20210820_202113_831.csv").inspect();
        assertEquals(195, inspection.rows());
        assertEquals(352, inspection.samples());
        assertEquals(new Clock(0, 60), inspection.clock());
        assertSummary(inspection, "zdt.acc.x", -0.052351676923076934, 1.2483080929415862);
        Finding.DroppedPackets lost = (Finding.DroppedPackets) inspection.findings().get(0);
        assertEquals(138, lost.count());
        assertEquals(157, lost.missing());
        assertEquals(5 * 16_667e-6, lost.longest(), 1e-9);
        assertEquals(1, inspection.findings().size());
    }

    @Test
    void twoDotsOfOneSittingAreJoinedOnTheirClock() throws IOException {
        Path folder = Samples.shared("real/exports");
        RecordingSet set = new RecordingSet(List.of(new RecordingFile(folder.resolve("LFemur_20210820_202113_831.csv")),
                new RecordingFile(folder.resolve("Pelvis_20210820_202113_836.csv"))));
        // The pelvis starts one tick (16 667 µs) before the femur and ends 29 ticks after it: 382 ticks in all.
        Inspection inspection = set.inspect();
        assertEquals(382, inspection.samples());
        assertEquals(382 - 195, inspection.summaries().get(Channel.parse("zdt.acc.x")).missing());
        assertEquals(0, inspection.summaries().get(Channel.parse("yao.acc.x")).missing());
    }

    private static Inspection wobble(String name) throws IOException {
        Path file = Samples.shared("real/wobble").resolve(name);
        ColumnMap map = ColumnMap.read(Path.of("data/maps/wobble.json"));
        return new RecordingFile(file, new ReadOptions(Optional.of(map), OptionalDouble.empty(), Map.of())).inspect();
    }

    private static List<Finding.ZeroRows> zeros(Inspection inspection) {
        return inspection.findings().stream().filter(Finding.ZeroRows.class::isInstance)
                .map(Finding.ZeroRows.class::cast).toList();
    }

    @Test
    void wobbleOfThe27thHasGravityLeftInEverywhereAndNoBias() throws IOException {
        Inspection inspection = wobble("wobble_20211027T145614.csv.gz");
        assertEquals(3798, inspection.samples());
        assertEquals(116.72947128783537, inspection.clock().rate(), 1e-6);
        assertSummary(inspection, "axle_pass.acc.z", 9.781641175829384, 3.859369120385349);
        assertEquals(4, inspection.findings().stream().filter(Finding.GravityLeftIn.class::isInstance).count());
        assertTrue(Samples.find(inspection, Finding.GrossBias.class).isEmpty());
        assertEquals(List.of(new Finding.ZeroRows("knuckle_pass", 2, 1384, false),
                new Finding.ZeroRows("knuckle_driver", 2, 1614, false),
                new Finding.ZeroRows("axle_pass", 2, 1699, false)), zeros(inspection));
    }

    @Test
    void wobbleOfThe29thHasAGrossBiasOnThePassengersAxle() throws IOException {
        Inspection inspection = wobble("wobble_20211029T125712.csv.gz");
        assertEquals(4874, inspection.samples());
        assertEquals(117.34871906910028, inspection.clock().rate(), 1e-6);
        Finding.GrossBias bias = Samples.find(inspection, Finding.GrossBias.class).orElseThrow();
        assertEquals("axle_pass", bias.location());
        assertEquals(-27.5533, bias.x(), 0.02);
        assertEquals(-26.6339, bias.y(), 0.02);
        assertEquals(-41.9716, bias.z(), 0.05);
        assertEquals(3, inspection.findings().stream().filter(Finding.GravityLeftIn.class::isInstance).count());
        assertEquals(List.of(new Finding.ZeroRows("knuckle_driver", 2, 645, false),
                new Finding.ZeroRows("axle_pass", 2, 939, false),
                new Finding.ZeroRows("axle_driver", 2, 3155, false)), zeros(inspection));
    }

    /** Displacement, velocity and force of two damper rigs: standing still before the test is no fault of a sensor there. */
    @Test
    void recordingsOfDamperRigsAreHealthy() throws IOException {
        Map<Channel, ColumnMap.Column> columns = Map.of(Channel.parse("rod.pos.x"), new ColumnMap.Column("disp_m", "m", 1),
                Channel.parse("rod.vel.x"), new ColumnMap.Column("vel_m_s", "m/s", 1),
                Channel.parse("rod.force.x"), new ColumnMap.Column("force_N", "N", 1));
        ColumnMap.Time time = new ColumnMap.Time(Optional.of(new ColumnMap.Column("t_s", "s", 1)), OptionalDouble.empty(), false);
        ReadOptions options = new ReadOptions(Optional.of(new ColumnMap("rig", time, columns, List.of())), OptionalDouble.empty(),
                Map.of());
        for (String rig : List.of("friction_backlash", "mr_shake")) {
            try (Stream<Path> files = Files.list(Samples.shared("real").resolve(rig))) {
                for (Path file : files.filter(path -> path.toString().contains(".csv")).toList()) {
                    Inspection inspection = new RecordingFile(file, options).inspect();
                    assertEquals(rig.equals("mr_shake") ? 100 : 1024, inspection.clock().rate(), file.toString());
                    assertEquals(List.of(), inspection.findings(), file.toString());
                }
            }
        }
    }

    @Test
    void thePracticeRecordingsAreClean() throws IOException {
        try (Stream<Path> folders = Files.list(Samples.shared("practice"))) {
            for (Path folder : folders.filter(Files::isDirectory).toList()) {
                for (String name : List.of("recording.csv.gz", "clean.csv.gz")) {
                    Inspection inspection = new RecordingFile(folder.resolve(name)).inspect();
                    assertEquals(new Clock(0, 60), inspection.clock(), folder.toString());
                    assertEquals(inspection.rows(), inspection.samples(), folder.toString());
                    assertEquals(List.of(), inspection.findings().stream().filter(finding -> finding.severity() != Severity.NOTE)
                            .map(Finding::message).toList(), folder + " " + name);
                }
            }
        }
    }
}

package wbv.task;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import moa.evaluation.preview.LearningCurve;
import moa.options.ClassOption;
import moa.tasks.MainTask;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.exposure.DailyExposure;
import wbv.exposure.Directive;
import wbv.exposure.SeatAxis;
import wbv.exposure.SeatMeasurement;
import wbv.exposure.SeatMeter;
import wbv.exposure.Vibration;
import wbv.recording.format.RecordingFile;

class MeasureExposureTest {

    private static final String RIDE = "data/arff/ride-subject1.arff";

    private static LearningCurve curve(String task) throws Exception {
        MainTask parsed = (MainTask) ClassOption.cliStringToObject(task, MainTask.class, null);
        parsed.prepareForUse();
        return (LearningCurve) parsed.doTask();
    }

    private static double at(LearningCurve curve, int entry, String name) {
        for (int i = 0; i < curve.getMeasurementNameCount(); i++) {
            if (curve.getMeasurementName(i).equals(name)) {
                return curve.getMeasurement(entry, i);
            }
        }
        throw new AssertionError("no measurement " + name + " in " + curve.headerToString());
    }

    /** The stream ends where the exact evaluation of the recording does. */
    @Test
    void theStreamEndsWhereTheRecordingDoes() throws Exception {
        LearningCurve curve = curve("wbv.task.MeasureExposure -e 10 -m 240 -s (wbv.stream.RecordingStream -f " + RIDE
                + " -i seat.acc.x,seat.acc.y -o seat.acc.z)");
        SeatMeasurement exact = SeatMeter.measure(new RecordingFile(Path.of(RIDE)),
                new SeatMeter.Setup(Optional.empty(), Optional.empty(), false), share -> {});
        int last = curve.numEntries() - 1;
        for (SeatAxis axis : SeatAxis.values()) {
            Vibration expected = exact.axes().get(axis);
            assertEquals(expected.rms(), at(curve, last, "a_w " + axis.letter() + " [m/s2]"), 0.005 * expected.rms());
            assertEquals(expected.vdv(), at(curve, last, "VDV " + axis.letter() + " [m/s^1.75]"), 0.01 * expected.vdv());
            assertEquals(expected.mtvv(), at(curve, last, "MTVV " + axis.letter() + " [m/s2]"), 0.01 * expected.mtvv());
        }
        double z = exact.axes().get(SeatAxis.Z).rms();
        assertEquals(z * Math.sqrt(0.5), at(curve, last, "A(8) [m/s2]"), 0.005 * z);
        double until = new DailyExposure(List.of(exact.task("ride", 240))).minutesUntil(Directive.ACTION);
        assertEquals(until, at(curve, last, "until action value [min]"), 0.04 * until);
        assertEquals(15, curve.numEntries());
        for (int i = 1; i < curve.numEntries(); i++) {
            assertTrue(at(curve, i, "VDV z [m/s^1.75]") >= at(curve, i - 1, "VDV z [m/s^1.75]"), "a dose never falls");
        }
    }

    /** Another stream than ours may lack rows: the time passes all the same, and what comes after is what it was. */
    @Test
    void rowsThatAreLackingAreTimeThatPasses(@TempDir Path folder) throws Exception {
        List<String> lines = Files.readAllLines(Path.of("data/arff/one-dof-linear.arff"));
        int head = 1 + IntStream.range(0, lines.size()).filter(i -> lines.get(i).equalsIgnoreCase("@data")).findFirst()
                .orElseThrow();
        List<String> rows = new ArrayList<>(lines.subList(0, head + 2400));
        rows.addAll(lines.subList(head + 2400 + 150, head + 3600));
        Path lacking = Files.write(folder.resolve("lacking.arff"), rows);
        LearningCurve found = curve("wbv.task.MeasureExposure -p head -e 10 -s (ArffFileStream -f " + lacking + ")");
        LearningCurve expected = curve("wbv.task.MeasureExposure -p head -e 10 -s (wbv.stream.RecordingStream -f " + lacking
                + ")");
        int last = expected.numEntries() - 1;
        assertEquals(expected.numEntries(), found.numEntries());
        assertEquals(60, at(found, last, "time [s]"), 1e-6);
        for (String name : List.of("a_w z [m/s2]", "VDV z [m/s^1.75]", "MTVV z [m/s2]")) {
            assertEquals(at(expected, last, name), at(found, last, name), 1e-9 * at(expected, last, name), name);
        }
    }

    /** A stream from the rig at another place and one axis; the others are unknown, not nothing. */
    @Test
    void oneAxisOfAnotherPlace() throws Exception {
        LearningCurve curve = curve("wbv.task.MeasureExposure -p head -s (wbv.stream.RigStream -e 'sitter=one-dof seconds=20')");
        int last = curve.numEntries() - 1;
        assertTrue(at(curve, last, "a_w z [m/s2]") > 0.1);
        assertTrue(Double.isNaN(at(curve, last, "a_w x [m/s2]")));
        assertEquals(at(curve, last, "a_w z [m/s2]"), at(curve, last, "A(8) [m/s2]"), 1e-12);
    }

    @Test
    void aStreamWithoutThePlaceIsRefused() {
        RuntimeException fault = assertThrows(RuntimeException.class,
                () -> curve("wbv.task.MeasureExposure -s (wbv.stream.RigStream -e 'sitter=one-dof seconds=5')"));
        StringBuilder said = new StringBuilder();
        for (Throwable cause = fault; cause != null; cause = cause.getCause()) {
            said.append(cause.getMessage());
        }
        assertTrue(said.toString().contains("no acceleration of seat"), said.toString());
    }
}

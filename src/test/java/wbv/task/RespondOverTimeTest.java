package wbv.task;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import moa.evaluation.preview.LearningCurve;
import moa.options.ClassOption;
import moa.tasks.MainTask;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RespondOverTimeTest {

    private static final String STEP = "(wbv.stream.RecordingStream -f data/arff/one-dof-step.arff"
            + " -i platform.acc.z -o head.acc.z)";

    private static LearningCurve curve(String task) throws Exception {
        MainTask parsed = (MainTask) ClassOption.cliStringToObject("wbv.task.RespondOverTime " + task, MainTask.class, null);
        parsed.prepareForUse();
        return (LearningCurve) parsed.doTask();
    }

    private static double at(LearningCurve curve, int row, String name) {
        for (int i = 0; i < curve.getMeasurementNameCount(); i++) {
            if (curve.getMeasurementName(i).startsWith(name)) {
                return curve.getMeasurement(row, i);
            }
        }
        throw new AssertionError(name);
    }

    /** The spring becomes stiffer by a quarter after a minute: the peak rises by √1.25, and a memory without end sees it late. */
    @Test
    void aHalfLifeLetsTheResponseFollowTheBody() throws Exception {
        LearningCurve forgets = curve("-h 10 -e 10 -s " + STEP);
        LearningCurve keeps = curve("-e 10 -s " + STEP);
        assertEquals(12, forgets.numEntries());
        double before = (at(forgets, 3, "peak frequency") + at(forgets, 4, "peak frequency")) / 2;
        double after = (at(forgets, 10, "peak frequency") + at(forgets, 11, "peak frequency")) / 2;
        assertEquals(Math.sqrt(1.25), after / before, 0.06);
        double mixed = at(keeps, 11, "peak frequency");
        assertTrue(before < mixed && mixed < after, before + " " + mixed + " " + after);
        assertTrue(at(keeps, 11, "independent averages") > 3 * at(forgets, 11, "independent averages"));
    }

    @Test
    void severalInputsAreToldApart() throws Exception {
        LearningCurve curve = curve("-e 1000 -s (wbv.stream.RecordingStream -f data/arff/ride-subject1.arff"
                + " -i platform.acc.x,platform.acc.y,platform.acc.z,platform.gyr.y -o head.acc.z)");
        assertEquals(1, curve.numEntries());
        // The rig's first person at 1 m/s² in closed form: 1.22 to the seat, times 1.65 to the head.
        assertEquals(2.0, at(curve, 0, "peak of H1 from platform.acc.z"), 0.15);
        assertTrue(at(curve, 0, "partial coherence at peak from platform.acc.z") > 0.9);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "1 | -s (wbv.stream.RecordingStream -f no/such.csv)                     | no such file",
        "1 | -s (wbv.stream.RigStream -e 'sitter=one-dof seconds=3')            | independent segments",
        "2 | -g 0 -s (wbv.stream.RigStream -e 'sitter=one-dof seconds=3')       | out of range",
        "1 | -s (wbv.stream.RecordingStream -f data/arff/two-dof.arff -o knee.acc.z) | knee.acc.z"})
    void failuresAreToldAsTheyAre(int code, String task, String said) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        assertEquals(code, TaskRunner.run("wbv.task.RespondOverTime " + task.trim(), new PrintStream(out, true,
                StandardCharsets.UTF_8), new PrintStream(err, true, StandardCharsets.UTF_8)), err::toString);
        assertTrue(err.toString(StandardCharsets.UTF_8).contains(said.trim()), err::toString);
        assertEquals("", out.toString());
    }
}

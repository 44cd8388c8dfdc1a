package wbv.task;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import moa.evaluation.preview.LearningCurve;
import moa.options.ClassOption;
import moa.tasks.MainTask;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.recording.RowReader;
import wbv.recording.format.RecordingWriter;
import wbv.rig.RigSpec;
import weka.core.Instances;
import weka.core.converters.ConverterUtils.DataSource;

class TaskTest {

    private static final String RIG = "(wbv.stream.RigStream -r 3 -e 'sitter=one-dof zeta=0.3 f0=4.5 seconds=25')";

    @TempDir
    private Path folder;

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private int run(String task) {
        out.reset();
        err.reset();
        return TaskRunner.run(task, new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(err, true, StandardCharsets.UTF_8));
    }

    private static LearningCurve curve(String task) throws Exception {
        MainTask parsed = (MainTask) ClassOption.cliStringToObject(task, MainTask.class, null);
        parsed.prepareForUse();
        return (LearningCurve) parsed.doTask();
    }

    private static double last(LearningCurve curve, String name) {
        for (int i = 0; i < curve.getMeasurementNameCount(); i++) {
            if (curve.getMeasurementName(i).equals(name)) {
                return curve.getMeasurement(curve.numEntries() - 1, i);
            }
        }
        throw new AssertionError("no measurement " + name + " in " + curve.headerToString());
    }

    @Test
    void theBodyOfTheRigIsFollowed() throws Exception {
        LearningCurve curve = curve("wbv.task.TrackBody -e 5 -s " + RIG);
        assertEquals(5, curve.numEntries());
        assertEquals(4.5, last(curve, "natural frequency [Hz]"), 0.1);
        assertEquals(0.3, last(curve, "damping ratio [1]"), 0.01);
        assertEquals(25, last(curve, "time [s]"), 0.02);
    }

    @Test
    void aRecordingOfTheRigGivesWhatTheRigGives() throws Exception {
        Path file = folder.resolve("rig.csv.gz");
        try (RowReader run = RigSpec.parse("sitter=one-dof zeta=0.3 f0=4.5 seconds=25 seed=3").run();
                RecordingWriter writer = RecordingWriter.create(file, run.channels(), run.metadata())) {
            double[] row = new double[1 + run.channels().size()];
            while (run.read(row)) {
                writer.write(row);
            }
            writer.finish();
        }
        assertEquals(curve("wbv.task.TrackBody -s " + RIG).toString(),
                curve("wbv.task.TrackBody -s (wbv.stream.RecordingStream -f " + file + ")").toString());
    }

    @Test
    void tracksAreWrittenAsCsvAndAsArffWithTheSameNumbers() throws Exception {
        Path csv = folder.resolve("tracks.csv");
        Path arff = folder.resolve("tracks.arff");
        assertEquals(TaskRunner.DONE, run("wbv.task.TrackBody -s " + RIG + " -t " + csv), err::toString);
        assertEquals(TaskRunner.DONE, run("wbv.task.TrackBody -s " + RIG + " -t " + arff), err::toString);
        List<String> lines = Files.readAllLines(csv);
        assertEquals(1 + 1500, lines.size());
        Instances read = DataSource.read(arff.toString());
        assertEquals(1500, read.numInstances());
        String[] names = lines.get(0).split(",");
        for (int r : new int[] {0, 100, 1499}) {
            String[] cells = lines.get(1 + r).split(",", -1);
            for (int c = 0; c < names.length; c++) {
                assertEquals(names[c], read.attribute(c).name());
                assertEquals(cells[c].isEmpty() ? Double.NaN : Double.parseDouble(cells[c]), read.instance(r).value(c), 0);
            }
        }
    }

    @Test
    void aFailedTaskLeavesNoFile() throws Exception {
        assertEquals(TaskRunner.WRONG_USAGE,
                run("wbv.task.TrackBody -l (wbv.learn.AdwinKalman -i nope) -s " + RIG + " -t " + folder.resolve("t.csv")));
        try (var left = Files.list(folder)) {
            assertEquals(0, left.count());
        }
    }

    @Test
    void moasOwnEvaluationRunsWithOurStreamAndLearner() throws Exception {
        LearningCurve curve = curve("EvaluatePrequentialRegression -l (wbv.learn.AdwinKalman -f 6.0) -s " + RIG + " -f 500");
        assertEquals(3, curve.numEntries());
        assertEquals(4.5, last(curve, "natural frequency [Hz]"), 0.1);
        assertTrue(last(curve, "coefficient of determination") > 0.99);
        LearningCurve whole = curve("EvaluatePrequentialRegression -l (wbv.learn.AdwinKalman -f 6.0) -s " + RIG
                + " -e BasicRegressionPerformanceEvaluator -f 500");
        // The first sample counts differently.
        assertEquals(last(whole, "coefficient of determination"), last(whole, "share explained [1]"), 1e-5);
        assertEquals(0, last(whole, "lost samples"));
    }

    /** The sideways motion of the base does not explain how the head goes up and down: that is told, whether it diverged or not. */
    @Test
    void aRunThatExplainsNothingSaysHowMuchIsLost() throws Exception {
        LearningCurve curve = curve("wbv.task.TrackBody -l wbv.learn.AdwinKalman -s (wbv.stream.RecordingStream "
                + "-f data/arff/ride-subject1.arff -i platform.acc.y -o head.acc.z)");
        assertTrue(last(curve, "share explained [1]") < 0.1, "share " + last(curve, "share explained [1]"));
        assertTrue(last(curve, "lost samples") > 2000, "lost " + last(curve, "lost samples"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "1 | wbv.task.TrackBody -s (wbv.stream.RecordingStream -f no/such.csv) | no such file",
        "1 | wbv.task.TrackBody -t no/such/folder.csv                          | no folder",
        "1 | wbv.task.TrackBody -t tracks.txt                                  | .csv or .arff",
        "2 | wbv.task.TrackBody -q                                             | Unknown option: -q",
        "2 | wbv.task.Nothing                                                  | Class not found: wbv.task.Nothing",
        "2 | wbv.task.TrackBody -l wbv.stream.RigStream                        | not an instance of",
        "2 | wbv.task.TrackBody -l (wbv.learn.AdwinKalman -d 9)                | out of range",
        "2 | ''                                                                | a task is needed"})
    void failuresAreToldAsTheyAre(int code, String task, String said) {
        assertEquals(code, run(task.trim()), err::toString);
        assertTrue(err.toString().contains(said.trim()), err::toString);
        assertTrue(err.toString().startsWith("wbv: "), err::toString);
        assertEquals("", out.toString());
    }

    @Test
    void theResultIsTheTextOfMoasDoTask() throws Exception {
        String task = "wbv.task.TrackBody -e 5 -s " + RIG;
        assertEquals(TaskRunner.DONE, run(task));
        Path result = folder.resolve("result.txt");
        Process moa = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), "moa.DoTask", task, "-S")
                .redirectOutput(result.toFile()).redirectError(folder.resolve("status.txt").toFile()).start();
        assertTrue(moa.waitFor(60, TimeUnit.SECONDS));
        assertFalse(out.toString(StandardCharsets.UTF_8).isBlank());
        assertEquals(out.toString(StandardCharsets.UTF_8), Files.readString(result));
    }
}

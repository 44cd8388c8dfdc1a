package wbv.task;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import moa.evaluation.preview.LearningCurve;
import moa.options.ClassOption;
import moa.tasks.MainTask;
import moa.tasks.StandardTaskMonitor;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The chain of chapter 6 as one streaming task. */
class PredictWithoutSensorTest {

    private static final String TASK = "wbv.task.PredictWithoutSensor -l (wbv.learn.SensorRemover -w 10 -h 2 -b 8 -k 30) -s "
            + "(wbv.stream.RigStream -e 'subject=2 excitation=random:z:0.5-12:0.8 seconds=100 seed=6' -i "
            + "platform.acc.z,platform.acc.x,platform.gyr.y,seat.acc.z) -a 60 -e 10";

    @TempDir
    private Path folder;

    /** Asks the task to stop after so many thousand instances, as a kill would: nothing is written then. */
    private static final class Impatient extends StandardTaskMonitor {
        private int thousands;

        Impatient(int thousands) {
            this.thousands = thousands;
        }

        @Override
        public void setCurrentActivityFractionComplete(double fraction) {
            thousands -= fraction > 0 ? 1 : 0;
        }

        @Override
        public boolean taskShouldAbort() {
            return thousands <= 0;
        }
    }

    private static MainTask task(String text) throws Exception {
        MainTask task = (MainTask) ClassOption.cliStringToObject(text, MainTask.class, null);
        task.prepareForUse();
        return task;
    }

    @Tag("slow")
    @Test
    void theHeadIsPredictedAfterItsSensorHasGone() throws Exception {
        LearningCurve curve = (LearningCurve) task(TASK + " -n 3").doTask();
        assertEquals(3, curve.numEntries(), "the newest rows alone");
        assertEquals("error over variance", curve.getMeasurementName(2));
        for (int row = 0; row < 3; row++) {
            assertEquals(0, curve.getMeasurement(row, 1), "the sensor has gone");
            assertTrue(curve.getMeasurement(row, 2) < 0.1, row + ": " + curve.getMeasurement(row, 2));
        }
    }

    @Tag("slow")
    @Test
    void aRunThatWasKilledGoesOnAsIfNothingHadHappened() throws Exception {
        Path whole = folder.resolve("whole.csv");
        task(TASK + " -t " + whole).doTask();
        Path table = folder.resolve("table.csv");
        Path checkpoint = folder.resolve("checkpoint.wbv");
        String again = TASK + " -t " + table + " -c " + checkpoint + " -k 20";
        for (int looks : new int[] {1, 1}) { // 33 s; from the checkpoint of 20 s on to 50 s
            task(again).doTask(new Impatient(looks), null);
        }
        assertTrue(Files.readAllLines(table).size() < Files.readAllLines(whole).size());
        task(again).doTask();
        assertArrayEquals(Files.readAllBytes(whole), Files.readAllBytes(table));
    }

    @Tag("slow")
    @Test
    void aCheckpointOfAnotherRunOrNoneIsRefused() throws Exception {
        Path checkpoint = folder.resolve("checkpoint.wbv");
        String end = " -c " + checkpoint + " -k 5";
        task(TASK + end).doTask(new Impatient(2), null);
        String other = assertThrows(RuntimeException.class, () -> task(TASK.replace("seed=6", "seed=7") + end).doTask()).getMessage();
        assertTrue(other.contains("is of another run") && other.contains("seed=6"), other);
        byte[] bytes = Files.readAllBytes(checkpoint);
        for (byte[] damaged : List.of(new byte[0], java.util.Arrays.copyOf(bytes, bytes.length / 2), "no checkpoint".getBytes())) {
            Files.write(checkpoint, damaged);
            String fault = assertThrows(RuntimeException.class, () -> task(TASK + end).doTask()).getMessage();
            assertTrue(fault.contains("checkpoint.wbv") && fault.contains("is no checkpoint"), fault);
        }
    }
}

package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.IntPredicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.Inspection;

/** Files of one sensor each become one recording. */
class MergedReaderTest {

    @TempDir
    Path folder;

    /** A sensor whose reading is its number times 10 000 plus the sample. */
    private RecordingFile sensor(String location, int number, int from, int to, IntPredicate lost) throws IOException {
        StringBuilder text = new StringBuilder("// Update Rate: 100.0Hz\nPacketCounter\tFreeAcc_Z\n");
        for (int i = from; i < to; i++) {
            if (!lost.test(i)) {
                text.append((65_000 + i) % 65_536).append('\t').append(number * 10_000 + i).append('\n');
            }
        }
        String serial = "00B4000" + number;
        return new RecordingFile(Samples.file(folder, "T_" + serial + ".txt", text.toString()),
                new ReadOptions(Optional.empty(), OptionalDouble.empty(), Map.of(serial, location)));
    }

    @Test
    void tenSensorsAreOneRecordingOverAWrapOfTheCounter() throws IOException {
        List<RecordingFile> files = new ArrayList<>();
        for (int k = 0; k < 10; k++) {
            int number = k;
            files.add(sensor("place_" + k, k, k == 3 ? 540 : k, 1000, i -> number == 5 && i % 100 == 50 || i == 777));
        }
        RecordingSet set = new RecordingSet(files);
        Inspection inspection = set.inspect();
        assertEquals(new Clock(0, 100), inspection.clock());
        assertEquals(1000, inspection.samples());
        assertEquals(1, Samples.find(inspection, Finding.DroppedPackets.class).orElseThrow().missing());
        Recording recording = set.load(inspection);
        for (int k = 0; k < 10; k++) {
            double[] values = recording.values(Channel.parse("place_" + k + ".acc.z"));
            for (int i = 0; i < 1000; i++) {
                boolean absent = i == 777 || i < (k == 3 ? 540 : k) || k == 5 && i % 100 == 50;
                assertEquals(absent ? Double.NaN : k * 10_000 + i, values[i], "sensor " + k + " sample " + i);
            }
        }
        assertEquals(10, recording.metadata().serials().size());
    }

    @Test
    void tablesAreJoinedOnTheirTimes() throws IOException {
        RecordingFile one = Samples.recording(folder, "a.csv", "# rate: 10 Hz\nt,a.acc.z\n0,1\n0.1,2\n0.2,3\n");
        RecordingFile two = Samples.recording(folder, "b.csv", "# rate: 10 Hz\nt,b.acc.z\n0.104,5\n0.201,6\n0.3,7\n");
        List<double[]> rows = Samples.rows(new RecordingSet(List.of(one, two)).open());
        assertEquals(4, rows.size());
        assertArrayEquals(new double[] {0, 1, Double.NaN}, rows.get(0));
        assertArrayEquals(new double[] {0.1, 2, 5}, rows.get(1));
        assertArrayEquals(new double[] {0.3, Double.NaN, 7}, rows.get(3));
    }

    @Test
    void whatCannotBeJoinedIsRefused() throws IOException {
        RecordingFile one = Samples.recording(folder, "a.csv", "# rate: 10 Hz\nt,a.acc.z\n0,1\n0.1,2\n");
        RecordingFile fast = Samples.recording(folder, "f.csv", "# rate: 20 Hz\nt,f.acc.z\n0,1\n0.05,2\n");
        RecordingFile silent = Samples.recording(folder, "s.csv", "t,s.acc.z\n0,1\n0.05,2\n");
        RecordingFile counted = sensor("c", 1, 0, 10, i -> false);
        assertFault("stands in two", one, one);
        assertFault("10.0 and 20.0 Hz", one, fast);
        assertFault("--rate", silent);
        assertFault("100", one, counted);
    }

    private static void assertFault(String word, RecordingFile... files) {
        DataFault fault = assertThrows(DataFault.class, () -> new RecordingSet(List.of(files)).open());
        assertTrue(fault.getMessage().contains(word), fault.getMessage());
    }
}

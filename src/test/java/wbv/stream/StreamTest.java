package wbv.stream;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.yahoo.labs.samoa.instances.Instance;
import java.io.IOException;
import java.io.InputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import moa.options.AbstractOptionHandler;
import moa.options.ClassOption;
import moa.streams.InstanceStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.DataFault;
import wbv.rig.RigRun;
import wbv.rig.RigSpec;

class StreamTest {

    private static final String RIG = "wbv.stream.RigStream -e 'sitter=one-dof zeta=0.3 f0=4.5 seconds=5' -r 9";

    @TempDir
    private Path folder;

    private static InstanceStream stream(String cli) throws Exception {
        AbstractOptionHandler stream = (AbstractOptionHandler) ClassOption.cliStringToObject(cli, InstanceStream.class, null);
        stream.prepareForUse();
        return (InstanceStream) stream;
    }

    private static List<String> rest(InstanceStream stream) {
        List<String> rows = new ArrayList<>();
        while (stream.hasMoreInstances()) {
            rows.add(Arrays.toString(stream.nextInstance().getData().toDoubleArray()));
        }
        return rows;
    }

    private String recording(String text) throws IOException {
        return "wbv.stream.RecordingStream -f " + Files.writeString(folder.resolve("r.csv"), text);
    }

    private String tenthsOfSeconds() throws IOException {
        StringBuilder text = new StringBuilder("t,platform.acc.z,seat.acc.z,head.acc.z\n");
        for (int i = 0; i < 20; i++) {
            if (i == 7) {
                text.append(i / 10.0).append(",1,2,\n");
            } else if (i != 12) {
                text.append(i / 10.0).append(',').append(i % 3).append(',').append(i % 4).append(',').append(-i % 5).append('\n');
            }
        }
        return recording(text.toString());
    }

    @Test
    void theRigIsStreamedAsItPlays() throws Exception {
        InstanceStream stream = stream(RIG);
        RigRun run = RigSpec.parse("sitter=one-dof zeta=0.3 f0=4.5 seconds=5 seed=9").run();
        double[] row = new double[1 + run.channels().size()];
        int output = 1 + run.channels().stream().map(Object::toString).toList().indexOf("head.acc.z");
        int input = 1 + run.channels().stream().map(Object::toString).toList().indexOf("platform.acc.z");
        assertEquals(300, stream.estimatedRemainingInstances());
        for (int i = 0; i < 300; i++) {
            assertTrue(run.read(row));
            Instance instance = stream.nextInstance().getData();
            assertEquals(row[0], instance.value(0), 0);
            assertEquals(row[input], instance.value(1), 0);
            assertEquals(row[output], instance.classValue(), 0);
        }
        assertFalse(stream.hasMoreInstances());
        assertEquals(0, stream.estimatedRemainingInstances());
    }

    @Test
    void aRecordingLiesOnItsClockWithHolesAsMissingValues() throws Exception {
        InstanceStream stream = stream(tenthsOfSeconds() + " -i platform.acc.z,seat.acc.z");
        assertEquals("head.acc.z", stream.getHeader().classAttribute().name());
        assertEquals(4, stream.getHeader().numAttributes());
        assertEquals(20, stream.estimatedRemainingInstances());
        for (int i = 0; i < 20; i++) {
            Instance instance = stream.nextInstance().getData();
            assertEquals(i / 10.0, instance.value(0), 1e-12);
            assertEquals(i == 7 || i == 12, Double.isNaN(instance.classValue()), "class at " + i);
            assertEquals(i == 12, instance.isMissing(1), "input at " + i);
            if (i != 7 && i != 12) {
                assertEquals(-i % 5, instance.classValue(), 0);
                assertEquals(i % 4, instance.value(2), 0);
            }
        }
        assertFalse(stream.hasMoreInstances());
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void restartReplaysAndACopyGoesOn(boolean rig) throws Exception {
        InstanceStream stream = stream(rig ? RIG : tenthsOfSeconds());
        List<String> all = rest(stream);
        stream.restart();
        assertEquals(all, rest(stream));
        stream.restart();
        for (int i = 0; i < 11; i++) {
            stream.nextInstance();
        }
        InstanceStream copy = (InstanceStream) stream.copy();
        assertEquals(all.subList(11, all.size()), rest(copy));
        assertEquals(all.subList(11, all.size()), rest(stream));
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void commandLinesRoundTrip(boolean rig) throws Exception {
        InstanceStream stream = stream(rig ? RIG : tenthsOfSeconds() + " -o seat.acc.z");
        String text = ((AbstractOptionHandler) stream).getCLICreationString(InstanceStream.class);
        assertEquals(rest(stream), rest(stream(text)), text);
        assertEquals(text, stream.getHeader().getRelationName());
    }

    @Test
    void otherSeedsAreOtherRuns() throws Exception {
        assertFalse(rest(stream(RIG)).equals(rest(stream(RIG + "1"))));
    }

    @Test
    void faultsOfTheDataAreSaidInOneLine() throws Exception {
        String text = tenthsOfSeconds();
        assertThrows(DataFault.class, () -> stream(text + " -o nowhere.acc.z"));
        assertThrows(DataFault.class, () -> stream("wbv.stream.RecordingStream -f " + folder.resolve("missing.csv")));
        assertThrows(IllegalArgumentException.class, () -> stream(text + " -o head.z"));
        assertThrows(IllegalArgumentException.class, () -> stream("wbv.stream.RigStream -e sitter=nobody"));
        assertThrows(DataFault.class, () -> stream(RIG + " -o sternum.acc.z"));
    }

    /** A pipe gives the instances that the file gives, before its writer has ended. */
    @Test
    @Timeout(60)
    void standardInputIsStreamedAsItComes() throws Exception {
        StringBuilder text = new StringBuilder("t,platform.acc.z,head.acc.z\n");
        for (int i = 0; i < 300; i++) {
            if (i % 37 != 5) {
                text.append(String.format(java.util.Locale.ROOT, "%.6f,%d,%d%n", i / 60.0, i % 7, i % 11));
            }
        }
        List<String> expected = rest(stream(recording(text.toString())));
        InputStream input = System.in;
        try (PipedOutputStream out = new PipedOutputStream(); PipedInputStream in = new PipedInputStream(out, 1 << 16)) {
            System.setIn(in);
            out.write(text.toString().getBytes(StandardCharsets.UTF_8));
            InstanceStream stream = stream("wbv.stream.RecordingStream -f -");
            List<String> rows = new ArrayList<>();
            while (rows.size() < expected.size() - 1) { // one row is read ahead
                rows.add(Arrays.toString(stream.nextInstance().getData().toDoubleArray()));
            }
            assertEquals(-1, stream.estimatedRemainingInstances());
            assertFalse(stream.isRestartable());
            assertThrows(DataFault.class, stream::restart);
            out.close();
            rows.addAll(rest(stream));
            assertEquals(expected, rows);
        } finally {
            System.setIn(input);
        }
    }
}

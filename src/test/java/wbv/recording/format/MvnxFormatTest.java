package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.RowReader;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.Inspection;

class MvnxFormatTest {

    private static final String HEAD = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            + "<mvnx version=\"4\" xmlns=\"http://www.xsens.com/mvn/mvnx\">\n"
            + "<subject label=\"S\" frameRate=\"60\" segmentCount=\"2\" recDate=\"Mon\">\n"
            + "<segments><segment label=\"Pelvis\" id=\"1\"/>"
            + "<segment label=\"LeftUpperArm\" id=\"2\"/></segments>\n<frames segmentCount=\"2\">\n"
            + "<frame time=\"0\" index=\"\" type=\"npose\"><orientation>1 0 0 0 1 0 0 0</orientation>"
            + "<position>9 9 9 9 9 9</position></frame>\n";
    private static final String TAIL = "</frames></subject></mvnx>\n";

    @TempDir
    Path folder;

    private static String frame(int index, double a) {
        return "<frame time=\"" + index * 17 + "\" index=\"" + index
                + "\" type=\"normal\"><orientation>1 0 0 0 0 1 0 0</orientation>"
                + "<position>1 2 3 4 5 6</position><acceleration>" + a + " 0 0 0 0 -1e-3</acceleration>"
                + "<angularVelocity>0 0 0.5 0 0 0</angularVelocity><jointAngle>1 2 3</jointAngle></frame>\n";
    }

    @Test
    void segmentsBecomeLocationsAndPosesArePassedOver() throws IOException {
        RowReader reader = Samples.recording(folder, "r.mvnx", HEAD + frame(0, 0.25) + frame(1, 0.5) + TAIL).open();
        assertEquals(2 * (3 + 3 + 3 + 4), reader.channels().size());
        assertEquals("pelvis.acc.x", reader.channels().get(0).toString());
        assertEquals("left_upper_arm.acc.z", reader.channels().get(5).toString());
        assertEquals("left_upper_arm.quat.x", reader.channels().get(23).toString());
        assertEquals(OptionalDouble.of(60), reader.metadata().rate());
        List<double[]> rows = Samples.rows(reader);
        assertEquals(2, rows.size());
        assertArrayEquals(new double[] {1 / 60.0, 0.5, 0, 0, 0, 0, -1e-3, 0, 0, 0.5, 0, 0, 0, 1, 2, 3, 4, 5, 6, 1, 0, 0, 0, 0, 1,
            0, 0},
                rows.get(1), 1e-15);
    }

    @Test
    void aLostFrameIsALostPacket() throws IOException {
        Inspection inspection = Samples.recording(folder, "r.mvnx",
                HEAD + frame(0, 0.1) + frame(1, 0.2) + frame(4, 0.3) + frame(5, 0.4) + TAIL).inspect();
        assertEquals(2, Samples.find(inspection, Finding.DroppedPackets.class).orElseThrow().missing());
        assertEquals(new Clock(0, 60), inspection.clock());
    }

    @Test
    void externalEntitiesAreNotFollowed() throws IOException {
        Path secret = Samples.file(folder, "secret", "0.125");
        String text = "<?xml version=\"1.0\"?><!DOCTYPE mvnx [<!ENTITY e SYSTEM \"" + secret.toUri() + "\">]>"
                + (HEAD + frame(0, 0.25)).replaceFirst("<\\?xml.*\\?>", "").replace("0.25 0 0", "&e; 0 0") + TAIL;
        DataFault fault = assertThrows(DataFault.class, () -> Samples.recording(folder, "r.mvnx", text).load());
        assertTrue(fault.getMessage().contains("r.mvnx:"), fault.getMessage());
    }

    private void assertFault(String text, String word) throws IOException {
        RecordingFile file = Samples.recording(folder, "r.mvnx", text);
        DataFault fault = assertThrows(DataFault.class, file::load);
        assertTrue(fault.getMessage().contains(word) && !fault.getMessage().contains("\n"), fault.getMessage());
    }

    @Test
    void damagedFilesAreNamed() throws IOException {
        assertFault(HEAD + frame(0, 1) + frame(1, 1), "not sound XML");
        assertFault(HEAD + frame(0, 1).replace("1 2 3 4 5 6", "1 2 3 4 5") + TAIL, "position has 5 numbers");
        assertFault(HEAD + frame(0, 1) + frame(1, 1).replace("1 2 3 4 5 6", "1 2 x 4 5 6") + TAIL, "'x'");
        assertFault(HEAD + TAIL, "no frame");
        assertFault("<html><body>no</body></html>", "not MVNX");
    }
}

package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.RowReader;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.Inspection;

/** Exports of MT Manager and of DOT, with what makes them awkward. */
class SensorFormatsTest {

    @TempDir
    Path folder;

    private static String names(RowReader reader) {
        return reader.channels().stream().map(Channel::toString).collect(Collectors.joining(" "));
    }

    private static ReadOptions rate(double rate) {
        return new ReadOptions(Optional.empty(), OptionalDouble.of(rate), Map.of());
    }

    @Test
    void tabsEmptyCellsAndARotationMatrixByColumns() throws IOException {
        // 90 degrees about z: columns (0 1 0), (-1 0 0), (0 0 1); the quaternion is (cos 45°, 0, 0, sin 45°).
        String text = "// Start Time: Unknown\r\n// Update Rate: 100.0Hz\r\n// Firmware Version: 4.0.2\r\n"
                + "PacketCounter\tSampleTimeFine\tAcc_X\tAcc_Y\tAcc_Z\tMat[1][1]\tMat[2][1]\tMat[3][1]"
                + "\tMat[1][2]\tMat[2][2]\tMat[3][2]"
                + "\tMat[1][3]\tMat[2][3]\tMat[3][3]\r\n"
                + "00472\t\t9.5\t1.5\t0.5\t0\t1\t0\t-1\t0\t0\t0\t0\t1\r\n00473\t\t9.5\t\t0.5\t1\t0\t0\t0\t1\t0\t0\t0\t1\r\n";
        RowReader reader = Samples.recording(folder, "MT_012005D6_009-001_00B421EE.txt", text).open();
        String s = "sensor_00b421ee.";
        assertEquals(s + "accg.x " + s + "accg.y " + s + "accg.z " + s + "quat.w " + s + "quat.x " + s + "quat.y " + s + "quat.z",
                names(reader));
        assertEquals(OptionalDouble.of(100), reader.metadata().rate());
        assertEquals("00B421EE", reader.metadata().serials().get("sensor_00b421ee"));
        assertEquals("4.0.2", reader.metadata().notes().get("Firmware Version"));
        List<double[]> rows = Samples.rows(reader);
        double half = Math.sqrt(0.5);
        assertArrayEquals(new double[] {0, 9.5, 1.5, 0.5, half, 0, 0, half}, rows.get(0), 1e-15);
        assertArrayEquals(new double[] {0.01, 9.5, Double.NaN, 0.5, 1, 0, 0, 0}, rows.get(1), 1e-15);
    }

    @Test
    void everyRotationBecomesItsQuaternion() {
        Random random = new Random(8);
        for (int i = 0; i < 10_000; i++) {
            double[] q = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
            q[i % 4] *= i % 7 == 0 ? 1e-9 : 1;
            double norm = Math.copySign(Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]), q[0]);
            double w = q[0] / norm;
            double x = q[1] / norm;
            double y = q[2] / norm;
            double z = q[3] / norm;
            double[] m = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 2 * (x * y - w * z),
                1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
            double[] back = new double[4];
            Rotation.quaternion(m, 0, back, 0);
            double sign = w < 1e-6 ? Math.signum(back[1] * x + back[2] * y + back[3] * z) : 1;
            assertArrayEquals(new double[] {w, x, y, z},
                    new double[] {sign * back[0], sign * back[1], sign * back[2], sign * back[3]}, 1e-12);
        }
    }

    @Test
    void commasQuaternionAnglesAndFreeAcceleration() throws IOException {
        String text = "// Update Rate: 50.0Hz\n"
                + "PacketCounter,SampleTimeFine,FreeAcc_X,Gyr_Y,Mag_Z,Quat_q0,Quat_q1,Quat_q2,Quat_q3,Roll,Pitch,Yaw,"
                + "VelInc_X\n1,,0.5,0.25,0.75,1,0,0,0,180,90,-45,7\n2,,0.5,0.25,0.75,1,0,0,0,180,90,-45,7\n";
        RowReader reader = Samples.recording(folder, "x_00B42235.csv", text).open();
        String s = "sensor_00b42235.";
        assertEquals(s + "acc.x " + s + "gyr.y " + s + "mag.z " + s + "quat.w " + s + "quat.x " + s + "quat.y " + s + "quat.z "
                + s + "ang.x " + s + "ang.y " + s + "ang.z", names(reader));
        assertArrayEquals(new double[] {0.02, 0.5, 0.25, 0.75, 1, 0, 0, 0, Math.PI, Math.PI / 2, -Math.PI / 4},
                Samples.rows(reader).get(1), 1e-15);
    }

    @Test
    void theOlderExportHasACounterAndASampleRate() throws IOException {
        String text = "// Sample rate: 50.0Hz\n"
                + "Counter\tAcc_X\tQuat_w\tQuat_x\tQuat_y\tQuat_z\n 2552\t4.3\t1\t0\t0\t0\t\n 2555\t4.4\t1\t0\t0\t0\t\n";
        RecordingFile file = Samples.recording(folder, "data_xsens.txt", text);
        assertEquals(4, file.inspect().samples());
        assertEquals(50, file.inspect().clock().rate());
    }

    @Test
    void decimalCommasAreRead() throws IOException {
        String text = "// Update Rate: 100,0Hz\nPacketCounter\tAcc_X\n1\t9,75\n2\t-1,5\n";
        List<double[]> rows = Samples.rows(Samples.recording(folder, "k.txt", text).open());
        assertEquals(9.75, rows.get(0)[1]);
        assertEquals(-1.5, rows.get(1)[1]);
    }

    @Test
    void theCounterWrapsAndItsHolesAreLostPackets() throws IOException {
        StringBuilder text = new StringBuilder("// Update Rate: 100.0Hz\nPacketCounter\tAcc_X\n");
        for (int i = 0; i < 2000; i++) {
            if (i != 500 && i != 1036 && i != 1037) {
                text.append((64_500 + i) % 65_536).append('\t').append(Math.sin(i)).append('\n');
            }
        }
        Inspection inspection = Samples.recording(folder, "w.txt", text.toString()).inspect();
        assertEquals(new Clock(0, 100), inspection.clock());
        assertEquals(2000, inspection.samples());
        Finding.DroppedPackets lost = Samples.find(inspection, Finding.DroppedPackets.class).orElseThrow();
        assertEquals(2, lost.count());
        assertEquals(3, lost.missing());
        assertEquals(1, inspection.findings().size(), () -> inspection.findings().toString());
    }

    @Test
    void aMissingUpdateRateIsInferredFromTheSampleTimes() throws IOException {
        StringBuilder text = new StringBuilder("// Firmware Version: 4.6\nPacketCounter\tSampleTimeFine\tAcc_X\n");
        for (int i = 0; i < 100; i++) {
            text.append(i + i / 50).append('\t').append(1_000_000 + 100 * (i + i / 50)).append('\t')
                    .append(Math.sin(i)).append('\n');
        }
        RecordingFile file = Samples.recording(folder, "m.txt", text.toString());
        assertEquals(100, file.inspect().clock().rate());
        assertEquals(1, Samples.find(file.inspect(), Finding.DroppedPackets.class).orElseThrow().missing());
    }

    @Test
    void withoutAnyRateTheUserIsAskedForIt() throws IOException {
        Path path = Samples.file(folder, "m.txt",
                "// Firmware Version: 4.6\nPacketCounter\tSampleTimeFine\tAcc_X\n1\t\t1\n2\t\t2\n");
        DataFault fault = assertThrows(DataFault.class, new RecordingFile(path)::open);
        assertTrue(fault.getMessage().contains("--rate"), fault.getMessage());
        assertEquals(80, new RecordingFile(path, rate(80)).inspect().clock().rate());
    }

    private static final String DOT = "sep=,\nDeviceTag:,zdt\nFirmwareVersion:,1.6.0\nAppVersion:,2021.0\nOutputRate:,60Hz\n"
            + "StartTime: ,2021-08-30_17:05:05_000 GMT+8\n\u00a9 Xsens\n\nPacketCounter,SampleTimeFine,Euler_X,Euler_Y,Euler_Z,"
            + "Acc_X,Acc_Y,Acc_Z,Gyr_X,Gyr_Y,Gyr_Z,Status\n";

    @Test
    void dotCountsMicrosecondsThatWrapAndDegreesPerSecond() throws IOException {
        String text = DOT + "0,0,0,0,0,0,0,0,0,0,0,0\n"
                + "1,4294958962,180,0,0,0.1,0.2,9.8,90,0,-180,0\n2,4294967295,180,0,0,0.1,0.2,9.8,90,0,-180,0\n"
                + "3,8332,180,0,0,0.1,0.2,9.8,90,0,-180,0\n";
        RowReader reader = Samples.recording(folder, "D4_2021.csv", text).open();
        assertEquals("zdt", reader.channels().get(0).location());
        assertEquals(OptionalDouble.of(60), reader.metadata().rate());
        assertEquals("1.6.0", reader.metadata().notes().get("FirmwareVersion"));
        List<double[]> rows = Samples.rows(reader);
        assertEquals(3, rows.size());
        assertEquals(0, rows.get(0)[0]);
        assertEquals(8333e-6, rows.get(1)[0], 1e-12);
        assertEquals(16_666e-6, rows.get(2)[0], 1e-12);
        assertArrayEquals(new double[] {Math.PI, 0, 0, 0.1, 0.2, 9.8, Math.PI / 2, 0, -Math.PI},
                Arrays.copyOfRange(rows.get(2), 1, 10), 1e-15);
    }

    @Test
    void aRowOfZerosBeforeTheFirstSampleIsPassedOverAndTold() throws IOException {
        StringBuilder text = new StringBuilder(DOT + "0,0,0,0,0,0,0,0,0,0,0,0\n");
        for (int i = 0; i < 60; i++) {
            text.append(i + 1).append(',').append(3_343_427_885L + 16_667L * i).append(",180,0,0,0.1,").append(0.01 * i)
                    .append(",9.8,90,0,-180,0\n");
        }
        Inspection inspection = Samples.recording(folder, "D4.csv", text.toString()).inspect();
        assertEquals(60, inspection.samples());
        Finding.PassedOver zeros = Samples.find(inspection, Finding.PassedOver.class).orElseThrow();
        assertEquals("1 row of zeros, the time too, before the first sample: passed over", zeros.message());
        Samples.file(folder, "D5.csv", text.toString().replace("zdt", "other"));
        RecordingSet both = new RecordingSet(
                List.of(new RecordingFile(folder.resolve("D4.csv")), new RecordingFile(folder.resolve("D5.csv"))));
        assertEquals(2, Samples.find(both.inspect(), Finding.PassedOver.class).orElseThrow().count());
    }

    @Test
    void aRowOfZerosInStepIsASample() throws IOException {
        String text = DOT + "0,0,0,0,0,0,0,0,0,0,0,0\n1,16667,0,0,0,0,0,0.2,0,0,0,0\n2,33334,0,0,0,0,0,0.3,0,0,0,0\n";
        try (RowReader reader = Samples.recording(folder, "D4.csv", text).open()) {
            assertEquals(0, reader.passedOver());
            double[] row = new double[1 + reader.channels().size()];
            double[][] expected = {{0, 0, 10}, {0.016667, 0.2, 11}, {0.033334, 0.3, 12}};
            for (double[] each : expected) {
                assertTrue(reader.read(row));
                assertArrayEquals(each, new double[] {row[0], row[6], reader.line()}, 1e-12);
            }
        }
    }

    @Test
    void aFirstRowOfZerosOfMtManagerIsASample() throws IOException {
        String text = "// Update Rate: 100.0Hz\nPacketCounter\tFreeAcc_X\n0\t0\n1\t0.5\n2\t0.25\n";
        RowReader reader = Samples.recording(folder, "k.txt", text).open();
        assertEquals(0, reader.passedOver());
        List<double[]> rows = Samples.rows(reader);
        assertEquals(3, rows.size());
        assertArrayEquals(new double[] {0.01, 0.5}, rows.get(1), 1e-15);
    }

    @Test
    void theLocationComesFromTheUserOrTheSidecar() throws IOException {
        String rows = "1,1000,180,0,0,0.1,0.2,9.8,90,0,-180,0\n";
        Path path = Samples.file(folder, "D4.csv", DOT + rows);
        ReadOptions byTag = new ReadOptions(Optional.empty(), OptionalDouble.empty(), Map.of("zdt", "left_shoulder"));
        ReadOptions byFile = new ReadOptions(Optional.empty(), OptionalDouble.empty(), Map.of("D4.csv", "pelvis"));
        assertEquals("left_shoulder", new RecordingFile(path, byTag).open().channels().get(0).location());
        assertEquals("pelvis", new RecordingFile(path, byFile).open().channels().get(0).location());
        Samples.file(folder, "D4.json", "{\"locations\": {\"zdt\": \"seat\"}}");
        assertEquals("seat", new RecordingFile(path).open().channels().get(0).location());
        assertEquals("zdt", new RecordingFile(path).open().metadata().serials().get("seat"));
    }
}

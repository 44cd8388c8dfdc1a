package wbv.recording.inspect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.recording.Clock;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.recording.format.Samples;

/** Rows laid on a uniform clock: what is kept, what is missing, what is interpolated, and the account of it. */
class UniformReaderTest {

    @TempDir
    Path folder;

    private RecordingFile file(int count, IntPredicate kept, IntToDoubleFunction time, IntToDoubleFunction value)
            throws IOException {
        StringBuilder text = new StringBuilder("t,head.acc.z\n");
        for (int i = 0; i < count; i++) {
            if (kept.test(i)) {
                text.append(time.applyAsDouble(i)).append(',').append(value.applyAsDouble(i)).append('\n');
            }
        }
        return Samples.recording(folder, "r.csv", text.toString());
    }

    @Test
    void rowsBecomeTheirSamplesUntouchedAndHolesAreNaN() throws IOException {
        RecordingFile file = file(2000, i -> i % 100 != 50 && i / 10 != 77, i -> Samples.significant(i / 60.0, 6),
                i -> i + 1.0 / 3);
        Inspection inspection = file.inspect();
        Recording recording = file.load(inspection);
        assertEquals(new Clock(0, 60), recording.clock());
        assertEquals(2000, recording.length());
        double[] values = recording.values(Samples.HEAD);
        for (int i = 0; i < 2000; i++) {
            assertEquals(i % 100 != 50 && i / 10 != 77 ? i + 1.0 / 3 : Double.NaN, values[i], "sample " + i);
        }
        try (UniformReader reader = file.uniform(inspection)) {
            List<double[]> rows = Samples.rows(reader);
            assertEquals(33.0, rows.get(1980)[0], 1e-12);
            assertEquals(new Relay(1970, 2000, 30, 0, 0, 0), reader.relay());
            assertEquals("1970 rows laid on 2000 samples of a uniform clock, 30 missing and left empty.",
                    reader.relay().sentence());
        }
    }

    /** How finely times above a hundred seconds are written is not known from the first of them. */
    @Test
    void theFirstTimeOfANewMagnitudeIsASample() throws IOException {
        IntPredicate kept = i -> i < 7000 || i >= 27000;
        RecordingFile file = file(30000, kept, i -> Samples.significant(i / 200.0, 9), i -> i + 1.0);
        Recording recording = file.load(file.inspect());
        assertEquals(30000, recording.length());
        double[] values = recording.values(Samples.HEAD);
        for (int i = 0; i < 30000; i++) {
            assertEquals(kept.test(i) ? i + 1.0 : Double.NaN, values[i], "sample " + i);
        }
    }

    /** Blocks show every row once and in order to each who looks, whatever is left over for the last. */
    @Test
    void blocksShowWhatRowsShow() throws IOException {
        for (int count : new int[] {511, 512, 1025}) {
            RecordingFile file = file(count, i -> i % 100 != 50, i -> i / 50.0, i -> i);
            Inspection inspection = file.inspect();
            List<String> expected = new ArrayList<>();
            try (UniformReader reader = file.uniform(inspection)) {
                Samples.rows(reader).forEach(row -> expected.add(Arrays.toString(row)));
            }
            List<String> rows = new ArrayList<>();
            List<Double> values = new ArrayList<>();
            try (UniformReader reader = file.uniform(inspection)) {
                RowBlock block = new RowBlock(1 + reader.channels().size());
                List<Consumer<RowBlock>> takers = List.of(RowBlock.each(row -> rows.add(Arrays.toString(row))),
                        RowBlock.each(reader, List.of(Samples.HEAD), motion -> values.add(motion[0])));
                while (block.read(reader)) {
                    block.show(takers);
                }
            }
            assertEquals(expected, rows);
            assertEquals(count, values.size());
            assertEquals(count - 1.0, values.get(count - 1));
        }
    }

    @Test
    void repeatedAndBackwardRowsAreLeftOut() throws IOException {
        StringBuilder text = new StringBuilder("t,head.acc.z\n");
        for (int i = 0; i < 100; i++) {
            text.append(i / 50.0).append(',').append(i).append('\n');
            text.append(i == 30 ? "0.6,30\n0.6,99\n" : "").append(i == 60 ? "0.5,98\n" : "");
        }
        RecordingFile file = Samples.recording(folder, "r.csv", text.toString());
        Inspection inspection = file.inspect();
        double[] values = file.load(inspection).values(Samples.HEAD);
        assertEquals(100, values.length);
        for (int i = 0; i < 100; i++) {
            assertEquals(i, values[i]);
        }
        try (UniformReader reader = file.uniform(inspection)) {
            Samples.rows(reader);
            assertEquals(new Relay(103, 100, 0, 2, 1, 0), reader.relay());
        }
    }

    @Test
    void aTimeFarAheadIsLeftOut() throws IOException {
        RecordingFile file = file(500, i -> true, i -> i == 200 ? 1e9 : i / 50.0, i -> i);
        Inspection inspection = file.inspect();
        double[] values = file.load(inspection).values(Samples.HEAD);
        assertEquals(500, values.length);
        for (int i = 0; i < 500; i++) {
            assertEquals(i == 200 ? Double.NaN : i, values[i]);
        }
        try (UniformReader reader = file.uniform(inspection)) {
            Samples.rows(reader);
            assertEquals(new Relay(500, 500, 1, 0, 1, 0), reader.relay());
        }
    }

    /** The cubic's error is at most max|x| / 24 times the product of the distances to its four rows. */
    @Test
    void whereTimesJitterSamplesAreInterpolatedByCubics() throws IOException {
        Random random = new Random(6);
        double[] times = new double[3000];
        for (int i = 0; i < times.length; i++) {
            times[i] = i / 60.0 + (random.nextDouble() - 0.5) * 0.4 / 60;
        }
        RecordingFile file = file(times.length, i -> true, i -> times[i], i -> Math.sin(2 * Math.PI * 4 * times[i]));
        Inspection inspection = file.inspect();
        assertTrue(inspection.timing().irregular());
        Recording recording = file.load(inspection);
        double[] values = recording.values(Samples.HEAD);
        assertEquals(3000, values.length, 2);
        double cubic = Math.pow(2 * Math.PI * 4 / 60, 4) / 24 * Math.pow(1.4, 2) * Math.pow(0.7, 2);
        for (int i = 2; i < values.length - 2; i++) {
            assertEquals(Math.sin(2 * Math.PI * 4 * recording.clock().time(i)), values[i], cubic, "sample " + i);
        }
        try (UniformReader reader = file.uniform(inspection)) {
            Samples.rows(reader);
            assertEquals(3000, reader.relay().rows());
            assertTrue(reader.relay().interpolated() > 2900, reader.relay().sentence());
        }
    }

    @Test
    void aHoleStaysEmptyWhereTimesJitter() throws IOException {
        Random random = new Random(7);
        RecordingFile file = file(2000, i -> i < 1000 || i >= 1010, i -> i / 60.0 + random.nextGaussian() * 0.05 / 60,
                i -> 1.0 + i % 7);
        Recording recording = file.load();
        double[] values = recording.values(Samples.HEAD);
        int missing = 0;
        for (double value : values) {
            missing += Double.isNaN(value) ? 1 : 0;
        }
        assertEquals(10, missing, 1);
        assertTrue(Double.isNaN(values[(int) recording.clock().nearest(1005 / 60.0)]));
    }
}

package wbv.task;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Recordings of bodies that the model of one degree of freedom is not: finite, consistent, and no storm of new beginnings. */
class RealRecordingTest {

    private static final Path SHARED = Path.of("../shared");

    @TempDir
    private Path folder;

    private List<double[]> tracks(String stream) throws Exception {
        Path csv = folder.resolve("tracks.csv");
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        PrintStream nowhere = new PrintStream(new ByteArrayOutputStream());
        int code = TaskRunner.run("wbv.task.TrackBody -s (" + stream + ") -t " + csv, nowhere, new PrintStream(err, true));
        assertEquals(TaskRunner.DONE, code, err::toString);
        return Files.readAllLines(csv).stream().skip(1).map(line -> List.of(line.split(",", -1)).stream()
                .mapToDouble(cell -> cell.isEmpty() ? Double.NaN : Double.parseDouble(cell)).toArray()).toList();
    }

    private static void assertFinite(List<double[]> tracks) {
        for (double[] row : tracks) {
            for (int i = 0; i < 5; i++) {
                assertTrue(Double.isFinite(row[i]), "at " + row[0] + " s");
            }
        }
    }

    /** An estimate that begins anew is at the start's 5 Hz exactly. */
    private static long beginnings(List<double[]> tracks) {
        long count = 0;
        for (int i = 1; i < tracks.size(); i++) {
            count += Math.abs(tracks.get(i)[1] - 5) < 1e-12 && Math.abs(tracks.get(i - 1)[1] - 5) >= 1e-12 ? 1 : 0;
        }
        return count;
    }

    @ParameterizedTest
    @CsvSource({"20211027T145614", "20211029T125712"})
    void anAxleIsNoBodyOnASpringAndIsNotMadeOne(String record) throws Exception {
        Path file = SHARED.resolve("real/wobble/wobble_" + record + ".csv.gz");
        assumeTrue(Files.exists(file), "no " + file);
        Path map = Files.writeString(folder.resolve("map.json"), """
                {"time": {"column": "t_s", "unit": "s"},
                 "patterns": [{"column": "{location}_a{axis}_m_s2", "channel": "{location}.acc.{axis}", "unit": "m/s²"}]}
                """);
        List<double[]> tracks = tracks("wbv.stream.RecordingStream -f " + file + " -m " + map
                + " -i axle_pass.acc.z -o knuckle_pass.acc.z");
        assertTrue(tracks.size() > 3000, tracks.size() + " samples");
        assertFinite(tracks);
        assertTrue(beginnings(tracks) <= 6, beginnings(tracks) + " new beginnings in " + tracks.size() / 117 + " s");
    }

    @Test
    void aSitterWithASofteningSeatIsFollowed() throws Exception {
        Path file = SHARED.resolve("practice/003/recording.csv.gz");
        assumeTrue(Files.exists(file), "no " + file);
        for (String output : new String[] {"pelvis.acc.z", "sternum.acc.z", "head.acc.z"}) {
            List<double[]> tracks = tracks("wbv.stream.RecordingStream -f " + file + " -o " + output);
            assertFinite(tracks);
            assertTrue(beginnings(tracks) <= 2, output + ": " + beginnings(tracks) + " new beginnings");
            assertEquals(1, medianOfBlocks(tracks, 7, 300), 0.3, output + ": mean ν²/S of five seconds");
        }
    }

    /** Median over blocks of the mean of a column: what holds most of the time, whatever happens at changes. */
    private static double medianOfBlocks(List<double[]> tracks, int column, int length) {
        double[] means = IntStream.range(0, tracks.size() / length)
                .mapToDouble(block -> tracks.subList(block * length, (block + 1) * length).stream().mapToDouble(row -> row[column])
                        .filter(Double::isFinite).average().orElse(Double.NaN))
                .sorted().toArray();
        return means[means.length / 2];
    }
}

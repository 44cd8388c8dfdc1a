package wbv.rig;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import wbv.recording.DataFault;

/** The recordings in {@code data/arff} are what their specs give; {@code -Dwbv.regenerate=true} writes them anew. */
class ShippedTest {

    private static final Path FOLDER = Path.of("data/arff");

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.MATCH_ALL, names = "ONE_DOF.*")
    void shippedRecordingIsGivenByItsSpecToTheByte(Shipped shipped, @TempDir Path folder) throws IOException {
        isGiven(shipped, folder);
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.MATCH_NONE, names = "ONE_DOF.*")
    void soAreAllOthers(Shipped shipped, @TempDir Path folder) throws IOException {
        isGiven(shipped, folder);
    }

    private static void isGiven(Shipped shipped, Path folder) throws IOException {
        Path fresh = folder.resolve(shipped.fileName());
        List<Path> written = RigFiles.write(shipped.spec(), fresh, shipped.full());
        for (Path path : written) {
            Path kept = FOLDER.resolve(path.getFileName());
            if (path.toString().endsWith(".gz")) {
                assertEquals(unzipped(path), unzipped(kept), kept.toString());
            } else {
                assertEquals(-1, Files.mismatch(path, kept), kept.toString());
            }
        }
    }

    @Test
    void shippedRecordingsSayWhatTheyAreAndStayBelow12Megabytes() throws IOException {
        long total = 0;
        for (Shipped shipped : Shipped.values()) {
            Path path = FOLDER.resolve(shipped.fileName());
            String head = String.join("\n", Files.readAllLines(path).subList(0, 8));
            assertTrue(head.contains("simulated by wbv rig") && head.contains("AGPL-3.0-or-later"), head);
            assertTrue(head.contains("% rig: " + shipped.spec()), head);
        }
        try (Stream<Path> files = Files.list(FOLDER)) {
            for (Path path : files.toList()) {
                total += Files.size(path);
            }
        }
        assertTrue(total < 12_000_000, total + " bytes");
    }

    @Test
    void truthStandsRowByRowBesideTheRecording(@TempDir Path folder) throws IOException {
        RigSpec spec = RigSpec.oneDof(0.3, 4, 1, 3, 1).withStiffnessStep(1.44, 1);
        RigFiles.write(spec, folder.resolve("a.csv.gz"), true);
        List<String> lines = unzipped(folder.resolve("a.truth.csv.gz"));
        assertEquals("t,zeta,omega,stretch1_m,stretch_rate1_m_per_s,platform.acc.z,head.acc.z", lines.get(0));
        assertEquals(181, lines.size());
        double[] last = Stream.of(lines.get(180).split(",")).mapToDouble(Double::parseDouble).toArray();
        assertArrayEquals(new double[] {179 / 60.0, 0.25, 2 * Math.PI * 4 * 1.2}, Stream.of(last[0], last[1], last[2])
                .mapToDouble(Double::doubleValue).toArray(), 1e-12);
        assertTrue(Files.readString(folder.resolve("a.truth.json")).contains("\"zeta\": 0.3"));
    }

    @Test
    void nothingHalfWrittenIsLeftWhereTheFormatIsUnknown(@TempDir Path folder) throws IOException {
        assertThrows(DataFault.class, () -> RigFiles.write(RigSpec.parse("seconds=1"), folder.resolve("a.xlsx"), false));
        try (Stream<Path> files = Files.list(folder)) {
            assertFalse(files.findAny().isPresent());
        }
    }

    @Test
    void regenerates() throws IOException {
        Assumptions.assumeTrue(Boolean.getBoolean("wbv.regenerate"), "only with -Dwbv.regenerate=true");
        Files.createDirectories(FOLDER);
        for (Shipped shipped : Shipped.values()) {
            RigFiles.write(shipped.spec(), FOLDER.resolve(shipped.fileName()), shipped.full());
        }
    }

    private static List<String> unzipped(Path path) throws IOException {
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(Files.newInputStream(path)), StandardCharsets.UTF_8))) {
            return reader.lines().toList();
        }
    }
}

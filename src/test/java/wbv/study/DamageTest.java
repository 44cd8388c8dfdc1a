package wbv.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.recording.Channel;
import wbv.recording.format.RecordingFile;
import wbv.recording.inspect.Inspection;

/** What is told of a recording that a diagnosis is made on. */
class DamageTest {

    private static final Channel RAIL = Channel.parse("rail.acc.z");
    private static final Channel CART = Channel.parse("cart.acc.z");

    @TempDir
    Path folder;

    /** The rail clips at 1.2 and 13 of its samples are empty, the cart at 2; from 4 s to 4.5 s there is no row. */
    private Inspection damaged() throws IOException {
        List<String> lines = new ArrayList<>(List.of("t,rail.acc.z,cart.acc.z"));
        for (int i = 0; i < 2000; i++) {
            double rail = 1.6 * Math.sin(0.31 * i) * Math.sin(0.0127 * i + 1);
            double cart = 2.5 * Math.sin(0.23 * i + 2) * Math.sin(0.0071 * i);
            if (i < 400 || i >= 450) {
                lines.add(String.format(Locale.ROOT, "%.2f,%s,%.5f", i / 100.0,
                        i >= 900 && i < 913 ? "" : String.format(Locale.ROOT, "%.5f", Math.max(-1.2, Math.min(1.2, rail))),
                        Math.max(-2, Math.min(2, cart))));
            }
        }
        Path file = folder.resolve("r.csv");
        Files.write(file, lines);
        return new RecordingFile(file).inspect();
    }

    @Test
    void everyKindHasALineWithItsCounts() throws IOException {
        List<String> lines = FoldedFindings.damage(damaged(), Set.of(RAIL, CART)).stream().map(FoldedFindings.Line::message).toList();
        assertEquals(3, lines.size(), lines::toString);
        assertTrue(lines.stream().anyMatch(line -> line.contains("1 gap in the times, 50 samples missing")), lines::toString);
        assertTrue(lines.stream().anyMatch(line -> line.contains("rail.acc.z lacks 13 samples")), lines::toString);
        assertTrue(lines.stream()
                .anyMatch(line -> line.contains("rail.acc.z stays at its extreme value") && line.contains("; cart.acc.z stays")
                        || line.contains("cart.acc.z stays") && line.contains("; rail.acc.z stays")),
                lines::toString);
    }

    @Test
    void whatIsNotUsedIsNotTold() throws IOException {
        List<String> lines = FoldedFindings.damage(damaged(), Set.of(CART)).stream().map(FoldedFindings.Line::message).toList();
        assertTrue(lines.stream().noneMatch(line -> line.contains("rail")), lines::toString);
    }
}

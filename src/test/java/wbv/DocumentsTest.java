package wbv;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Every table of figures says by which command, and of which commit, it was measured. */
class DocumentsTest {

    private static final Pattern NOTE = Pattern.compile("\\*(Older: commit|Commit) [0-9a-f]{7,}\\b.*\\. Command: .+\\*");

    @ParameterizedTest
    @ValueSource(strings = {"thesis.md", "proof.md", "proof-history.md", "proof-real.md", "benchmarks.md", "export.md", "seat.md"})
    void everyTableNamesItsCommandAndItsCommit(String name) throws IOException {
        List<String> lines = Files.readAllLines(Path.of("docs", name));
        for (int i = 0; i < lines.size(); i++) {
            boolean tableEnds = lines.get(i).startsWith("|") && (i + 1 == lines.size() || !lines.get(i + 1).startsWith("|"));
            if (tableEnds) {
                assertTrue(i + 2 < lines.size() && lines.get(i + 1).isEmpty() && NOTE.matcher(lines.get(i + 2)).matches(),
                        "docs/" + name + ":" + (i + 1)
                                + ": below the table, after an empty line, must stand: *Commit 0123abc. Command: `…`.* "
                                + "(or *Older: commit …* if it was not measured again)");
            }
        }
    }
}

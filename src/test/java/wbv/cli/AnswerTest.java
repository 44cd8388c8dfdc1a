package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** What commands say where: the answer on standard output, in words or as JSON, and nothing else there. */
class AnswerTest {

    /** Of these {@code live} prints JSON alone, {@code task} what MOA prints, and the others text that is for a shell or a person. */
    private static final Set<String> WITHOUT = Set.of("live", "task", "completion", "help");
    private static final String LINEAR = "data/arff/one-dof-linear.arff";
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    @Test
    void everyCommandThatAnswersDoesSoAsJsonAndQuietly() {
        require(Commands.all());
    }

    private static void require(CommandLine command) {
        command.getSubcommands().values().stream().distinct().forEach(AnswerTest::require);
        String name = command.getCommandName();
        if (command.getSubcommands().isEmpty()) {
            assertEquals(!WITHOUT.contains(name), command.getCommandSpec().optionsMap().keySet().containsAll(List.of("--json", "--quiet")),
                    name);
        }
    }

    /** What is printed is the file of results. */
    @ParameterizedTest
    @ValueSource(strings = {"analyze", "track --estimator ekf", "exposure"})
    void jsonIsThatOfTheFile(String command) throws IOException {
        String[] words = (command + " " + LINEAR + (command.equals("exposure") ? " --seat platform" : "") + " --json --out "
                + folder.resolve("out")).split(" ");
        Run run = Run.of(words);
        assertEquals(0, run.code(), run.err());
        String file = command.equals("exposure") ? "exposure.json" : "results.json";
        assertEquals(Files.readString(folder.resolve("out").resolve(file)), run.out());
    }

    @ParameterizedTest
    @ValueSource(strings = {"simulate --models", "export wei-griffin-1998-1dof --to modelica --out FOLDER/a.mo",
        "convert " + LINEAR + " --out FOLDER/a.csv",
        "simulate sitter=one-dof seconds=5 --out FOLDER/b.csv", "map src/test/resources/map/phyphox.csv --out FOLDER/map.json",
        "map " + LINEAR, "fleet " + LINEAR + " --seats 2 --out FOLDER/fleet", "exposure --magnitude z=0.7 --hours 4"})
    void jsonIsAllThatIsPrinted(String command) throws IOException {
        Run run = Run.of((command + " --json").replace("FOLDER", folder.toString()).split(" "));
        assertEquals(0, run.code(), run.err());
        JsonNode root = JSON.readTree(run.out());
        assertTrue(root.isContainerNode() && !root.isEmpty(), run.out());
        if (root.path("wrote").isArray()) {
            root.get("wrote").forEach(file -> assertTrue(Files.exists(Path.of(file.asText())), file.asText()));
        }
    }

    @Test
    void quietIsTheAnswerAlone() {
        Run full = Run.of("analyze", LINEAR, "--out", folder.resolve("out").toString());
        Run quiet = Run.of("analyze", LINEAR, "--quiet", "--out", folder.resolve("out").toString());
        assertEquals(0, quiet.code(), quiet.err());
        assertTrue(full.out().startsWith(quiet.out()) && full.out().substring(quiet.out().length()).startsWith("Wrote "), quiet.out());
        Run conversion = Run.of("convert", "data/arff/ride-subject1.arff", "--quiet", "--out", folder.resolve("ride.csv").toString());
        assertEquals(new Run(0, "", ""), conversion);
    }

    @Test
    void aConvertedRecordingGoesToStandardOutput() throws IOException {
        Path file = folder.resolve("ride.csv");
        assertEquals(0, Run.of("convert", LINEAR, "--out", file.toString()).code());
        Run piped = Run.of("convert", LINEAR, "--out", "-");
        assertEquals(0, piped.code());
        assertEquals(Files.readString(file), piped.out());
        assertTrue(piped.err().contains("7200 rows laid on 7200 samples"), piped.err());
        assertFalse(Files.exists(Path.of("-")) || Files.exists(Path.of("-.json")));
        assertEquals(2, Run.of("convert", LINEAR, "--out", "-", "--json").code());
    }

    @Test
    void colourMarksWhatAsksForAttentionAndNothingElse() {
        String text = "  WARNING: a\nNOTE: b\na WARNING: c\n";
        assertEquals(text, Answer.coloured(text, false));
        assertEquals("  \u001b[1;33mWARNING\u001b[0m: a\n\u001b[1;36mNOTE\u001b[0m: b\na WARNING: c\n", Answer.coloured(text, true));
    }

    /** A step that tells nothing for long is drawn all the same, and wiped. */
    @Test
    @Timeout(60)
    void progressIsDrawnByItselfAndWiped() throws InterruptedException {
        ByteArrayOutputStream drawn = new ByteArrayOutputStream();
        try (ProgressBar bar = new ProgressBar(new PrintStream(drawn, true, StandardCharsets.UTF_8), true)) {
            bar.at("reading", 0.5);
            while (drawn.size() == 0) {
                Thread.sleep(20);
            }
            bar.at("thinking", Double.NaN);
            while (!drawn.toString(StandardCharsets.UTF_8).contains("thinking ... ")) {
                Thread.sleep(20);
            }
        }
        String text = drawn.toString(StandardCharsets.UTF_8);
        assertTrue(text.startsWith("\r\u001b[Kreading [###############---------------]  50 %"), text);
        assertTrue(text.endsWith("\r\u001b[K"), text);
        ByteArrayOutputStream hidden = new ByteArrayOutputStream();
        try (ProgressBar bar = new ProgressBar(new PrintStream(hidden, true, StandardCharsets.UTF_8), false)) {
            bar.at("reading", 0.5);
            Thread.sleep(700);
        }
        assertEquals(0, hidden.size());
    }
}

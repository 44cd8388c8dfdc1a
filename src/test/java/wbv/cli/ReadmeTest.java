package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import wbv.network.WithEngine;
import wbv.task.TaskRunner;

/**
 * What README.md, the tutorial and the pages of how to do something print is what their commands print: every fenced block of
 * {@code ./wbv} commands is run, in the document's order, and compared with the block behind it. There a line {@code …} stands for any
 * lines, and {@code …} in a line for any text. Blocks of {@code java … moa.DoTask} are run as well; they have no output to compare.
 * Results go to another folder; nothing else is changed.
 */
class ReadmeTest {

    private static final String FENCE = "```";
    private static final Pattern WORD = Pattern.compile("'([^']*)'|\"([^\"]*)\"|(\\S+)");
    private static final String WBV = "./wbv ";
    private static final String DIAGNOSE = WBV + "diagnose ";
    private static final String MOA = "java -cp target/wbv.jar moa.DoTask ";

    @TempDir
    private static Path rooms;

    /** Commands that stand in one block. @param printed what the document says they print; empty where it says nothing */
    private record Block(List<String> commands, List<String> printed) {}

    private static List<Path> documents() throws IOException {
        List<Path> documents = new ArrayList<>(List.of(Path.of("README.md"), Path.of("docs/tutorial.md")));
        try (Stream<Path> pages = Files.list(Path.of("docs/howto"))) {
            pages.sorted().forEach(documents::add);
        }
        return documents;
    }

    private static List<Block> blocks(Path document) throws IOException {
        List<Block> blocks = new ArrayList<>();
        List<String> lines = Files.readAllLines(document);
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i).startsWith(FENCE)) {
                int end = end(lines, i);
                List<String> commands = String.join("\n", lines.subList(i + 1, end)).replace("\\\n", " ").lines().toList();
                if (commands.stream().anyMatch(line -> line.startsWith(WBV) || line.startsWith(MOA))) {
                    boolean shown = end + 1 < lines.size() && lines.get(end + 1).equals(FENCE);
                    blocks.add(new Block(commands, shown ? lines.subList(end + 2, end(lines, end + 1)) : List.of()));
                }
                i = end;
            }
        }
        return blocks;
    }

    private static int end(List<String> lines, int begin) {
        return begin + 1 + lines.subList(begin + 1, lines.size()).indexOf(FENCE);
    }

    @TestFactory
    Stream<DynamicTest> commandsPrintWhatTheReadmeSays() throws IOException {
        return tests(false);
    }

    @Tag("slow")
    @TestFactory
    Stream<DynamicTest> diagnosesPrintWhatTheReadmeSays() throws IOException {
        return tests(true);
    }

    /**
     * Whether a block searches for physics, or takes the model that such a search has written.
     *
     * @param searched names of folders that searches write to
     */
    private static boolean diagnoses(Block block, TreeSet<String> searched) {
        return block.commands().stream().anyMatch(command -> command.startsWith(DIAGNOSE)
                || searched.stream().anyMatch(out -> command.contains(" " + out + "/model.json")));
    }

    private static TreeSet<String> results(List<Block> blocks, String begin) {
        TreeSet<String> results = new TreeSet<>();
        blocks.forEach(block -> block.commands().stream().filter(command -> command.startsWith(begin)).map(ReadmeTest::words)
                .filter(words -> words.contains("--out")).forEach(words -> results.add(words.get(words.indexOf("--out") + 1))));
        return results;
    }

    /** @param searching whether of blocks that search for physics, or of the others */
    private static Stream<DynamicTest> tests(boolean searching) throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        for (Path document : documents()) {
            List<Block> blocks = blocks(document);
            assertTrue(blocks.size() >= (document.endsWith("README.md") ? 8 : 1), document + " has lost its commands");
            TreeSet<String> results = results(blocks, "");
            TreeSet<String> searched = results(blocks, DIAGNOSE);
            Path room = Files.createDirectories(rooms.resolve(document.getFileName().toString()));
            blocks.stream().filter(block -> diagnoses(block, searched) == searching).forEach(block -> tests.add(DynamicTest.dynamicTest(
                    document.getFileName() + ": " + block.commands().get(0).strip(), () -> check(block, results, room))));
        }
        return tests.stream();
    }

    private static void check(Block block, TreeSet<String> results, Path room) throws Exception {
        StringBuilder printed = new StringBuilder();
        for (String command : block.commands()) {
            printed.append(run(command, results, room));
        }
        if (!block.printed().isEmpty()) {
            assertTrue(says(block.printed()).matcher(printed).matches(),
                    () -> "the document says\n" + String.join("\n", block.printed()) + "\nbut printed is\n" + printed);
        }
    }

    /**
     * Runs a command with its results elsewhere.
     *
     * @param results names of folders that commands write to
     * @param room what is to hold them
     */
    private static String run(String command, TreeSet<String> results, Path room) {
        if (command.startsWith(WBV)) {
            if (command.startsWith(WBV + "net ")) {
                WithEngine.orSkip();
            }
            Run run = Run
                    .of(words(command.substring(WBV.length())).stream().map(word -> moved(word, results, room)).toArray(String[]::new));
            assertEquals(0, run.code(), run.err());
            assertEquals("", run.err(), "beside what the document shows");
            return run.out().replace(room + "/", "");
        }
        if (command.startsWith(MOA)) {
            String task = words(command.substring(MOA.length())).get(0);
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            ByteArrayOutputStream err = new ByteArrayOutputStream();
            for (String folder : results) {
                task = task.replace(" " + folder + "/", " " + room.resolve(folder) + "/");
            }
            assertEquals(0, TaskRunner.run(task, new PrintStream(out, true, StandardCharsets.UTF_8),
                    new PrintStream(err, true, StandardCharsets.UTF_8)), err.toString(StandardCharsets.UTF_8));
            return out.toString(StandardCharsets.UTF_8);
        }
        return "";
    }

    private static String moved(String word, TreeSet<String> results, Path room) {
        return results.stream().anyMatch(folder -> word.equals(folder) || word.startsWith(folder + "/"))
                ? room.resolve(word).toString() : word;
    }

    /** The words that a shell makes of a line. */
    private static List<String> words(String line) {
        List<String> words = new ArrayList<>();
        Matcher word = WORD.matcher(line);
        while (word.find()) {
            words.add(word.group(1) != null ? word.group(1) : word.group(2) != null ? word.group(2) : word.group(3));
        }
        return words;
    }

    private static Pattern says(List<String> printed) {
        StringBuilder pattern = new StringBuilder();
        for (String line : printed) {
            if (line.strip().equals("…")) {
                pattern.append("(?:.*\\n)*?");
            } else {
                for (String piece : line.split("…", -1)) {
                    pattern.append(Pattern.quote(piece)).append(".*");
                }
                pattern.setLength(pattern.length() - 2);
                pattern.append("\\n");
            }
        }
        return Pattern.compile(pattern.toString());
    }
}

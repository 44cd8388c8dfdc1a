package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * The first table of docs/thesis.md names every numbered table of the thesis and every figure with data, and its commands run:
 * those of wbv as they stand, those of proofs at the sizes below. A command with a word in capitals is asked for its help.
 */
class ThesisTest {

    private static final String WBV = "./wbv ";
    private static final Pattern NUMBER = Pattern.compile("\\b(\\d)-(\\d+)(?: to \\d-(\\d+))?");

    /** Numbered tables by chapter, and figures that show data; the others are diagrams and photographs. */
    private static final Map<String, int[]> WANTED = Map.of("Table 2", range(1, 5), "Table 3", range(1, 3), "Table 4", range(1, 1),
            "Table 5", range(1, 4), "Table 6", range(1, 2), "Table 7", range(1, 2), "Table 8", range(1, 3));
    private static final Map<String, int[]> FIGURES = Map.of("Figure 2", new int[] {2, 3, 4, 10}, "Figure 3",
            new int[] {8, 11, 12, 13, 14, 15}, "Figure 4", range(3, 8), "Figure 5", range(2, 5), "Figure 6",
            new int[] {1, 2, 3, 4, 5, 7, 8, 9, 11, 12}, "Figure 7", range(1, 5), "Figure 8", new int[] {2, 6, 7});

    /** How a proof is run here: fewer people, shorter rides. */
    private static final Map<String, String> REDUCED = Map.of(
            "wbv.exposure.VehiclesProof", "",
            "wbv.signal.ResponseProof", "1",
            "wbv.rig.SitterProof regimes", "regimes 2",
            "wbv.bench.FilterProof cells", "cells seat 31 1 1 particle/1",
            "wbv.pole.RemovalProof", "2 1 40",
            "wbv.state.StatesProof methods", "methods 6 3");

    @TempDir
    private Path room;

    /** @param of the thesis, first cell @param commands in backticks, third cell */
    private record Row(String of, List<String> commands) {}

    private static int[] range(int first, int last) {
        return IntStream.rangeClosed(first, last).toArray();
    }

    private static List<Row> rows() throws IOException {
        String text = Files.readString(Path.of("docs/thesis.md"));
        String table = text.substring(text.indexOf("## Table by table"));
        return table.lines().skip(1).takeWhile(line -> !line.startsWith("## ")).filter(line -> line.startsWith("| "))
                .map(line -> line.split(" \\| ")).filter(cells -> cells.length == 4 && NUMBER.matcher(cells[0]).find())
                .map(cells -> new Row(cells[0], Pattern.compile("`([^`]+)`").matcher(cells[2]).results().map(m -> m.group(1)).toList()))
                .toList();
    }

    @Test
    void everyTableAndEveryFigureWithDataHasARow() throws IOException {
        TreeSet<String> named = new TreeSet<>();
        for (Row row : rows()) {
            String kind = "";
            for (String part : row.of().split("(?=Table |Figure )|, ")) {
                kind = part.contains("Table") ? "Table" : part.contains("Figure") ? "Figure" : kind;
                for (MatchResult number : NUMBER.matcher(part).results().toList()) {
                    int last = Integer.parseInt(number.group(3) == null ? number.group(2) : number.group(3));
                    for (int i = Integer.parseInt(number.group(2)); i <= last; i++) {
                        named.add(kind + " " + number.group(1) + "-" + i);
                    }
                }
            }
            assertFalse(row.commands().isEmpty(), row.of() + " has no command");
        }
        for (Map<String, int[]> each : List.of(WANTED, FIGURES)) {
            each.forEach((chapter, numbers) -> Arrays.stream(numbers).forEach(i -> assertTrue(named.contains(chapter + "-" + i),
                    "no row for " + chapter + "-" + i)));
        }
    }

    @Tag("slow")
    @TestFactory
    Stream<DynamicTest> everyCommandRuns() throws IOException {
        return commands().filter(command -> !isProof(command)).map(command -> DynamicTest.dynamicTest(command, () -> {
            if (command.startsWith(WBV)) {
                run(words(command.substring(WBV.length())));
            } else {
                String named = command.substring(command.indexOf("-Dtest=") + "-Dtest=".length());
                try (Stream<Path> tests = Files.walk(Path.of("src/test/java"))) {
                    assertTrue(command.startsWith("mvn test -Dtest=") && tests.anyMatch(path -> path.endsWith(named + ".java")), command);
                }
            }
        }));
    }

    @Tag("slow")
    @TestFactory
    Stream<DynamicTest> everyProofRuns() throws IOException {
        return commands().filter(ThesisTest::isProof).map(command -> DynamicTest.dynamicTest(command, () -> prove(command)));
    }

    private static Stream<String> commands() throws IOException {
        return rows().stream().flatMap(row -> row.commands().stream()).distinct();
    }

    private static boolean isProof(String command) {
        return command.startsWith("wbv.");
    }

    private void run(List<String> words) {
        List<String> all = new ArrayList<>(words);
        if (words.stream().anyMatch(word -> word.matches(".*\\b[A-Z]{5,}\\b.*"))) {
            all = new ArrayList<>(List.of(words.get(0), "--help"));
        } else if (!words.contains("--help")) {
            all.addAll(List.of("--out", room.resolve(words.get(0).equals("simulate") ? "out.csv" : "out").toString()));
        }
        if (words.contains("--models")) {
            all = words;
        }
        Run run = Run.of(all.toArray(String[]::new));
        assertEquals(0, run.code(), run::err);
        assertFalse(run.out().isBlank(), "nothing printed");
    }

    private static void prove(String command) throws Exception {
        String key = REDUCED.keySet().stream().filter(command::startsWith).findFirst()
                .orElseThrow(() -> new AssertionError("say how to run at a reduced size: " + command));
        String small = REDUCED.get(key);
        Method main = Class.forName(key.split(" ")[0]).getDeclaredMethod("main", String[].class);
        main.setAccessible(true);
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        PrintStream before = System.out;
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        try {
            main.invoke(null, (Object) (small.isEmpty() ? new String[0] : small.split(" ")));
        } finally {
            System.setOut(before);
        }
        assertTrue(printed.toString(StandardCharsets.UTF_8).lines().filter(line -> line.startsWith("|")).count() >= 3, "no table");
    }

    private static List<String> words(String line) {
        return Pattern.compile("\"([^\"]*)\"|(\\S+)").matcher(line).results()
                .map(m -> m.group(1) != null ? m.group(1) : m.group(2)).toList();
    }
}

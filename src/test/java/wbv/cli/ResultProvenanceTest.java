package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParseResult;

/** The command line that a result carries, read by a shell, makes the result again. */
class ResultProvenanceTest {

    @TempDir
    private Path folder;

    @BeforeAll
    static void aShellReadsLines() {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "no /bin/sh here: no line is read");
    }

    @TestFactory
    Stream<DynamicTest> everyCommandWithAllOfItsOptionsIsReadBack() {
        return leaves(Commands.all().getCommandSpec()).stream()
                .map(command -> DynamicTest.dynamicTest(command.qualifiedName(), () -> {
                    List<String> words = new ArrayList<>(path(command));
                    command.options().stream().filter(option -> !option.usageHelp() && !option.versionHelp())
                            .forEach(option -> words.addAll(option.arity().max() == 0 ? List.of(option.longestName())
                                    : List.of(option.longestName(), invented(option))));
                    command.positionalParameters()
                            .forEach(each -> words.addAll(each.arity().max() > 1 ? List.of(invented(each), "-") : List.of(invented(each))));
                    readsBack(words);
                }));
    }

    @TestFactory
    Stream<DynamicTest> everyCommandWithItsDefaultsIsReadBack() {
        return leaves(Commands.all().getCommandSpec()).stream()
                .map(command -> DynamicTest.dynamicTest(command.qualifiedName(), () -> {
                    List<String> words = new ArrayList<>(path(command));
                    command.requiredArgs().forEach(each -> words.addAll(
                            each instanceof OptionSpec option ? List.of(option.longestName(), invented(each)) : List.of(invented(each))));
                    readsBack(words);
                }));
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '"', value = {
        "track|-|wbv track -",
        "track|--|-ride.csv|wbv track --start-frequency",
        "track|@@ride.csv|wbv track @@ride.csv --start-frequency",
        "track|my ride's.csv|wbv track 'my ride'\\''s.csv' --start-frequency",
        "exposure|a.csv|--boxcar=false|--task|-3=4|wbv exposure a.csv --task -3=4 --from-age",
        "prove|--only||wbv prove --",
    })
    void oddWordsAreReadBack(String row) throws Exception {
        List<String> words = new ArrayList<>(Arrays.asList(row.split("\\|")));
        String begins = words.remove(words.size() - 1);
        String line = readsBack(words);
        assertTrue(line.startsWith(begins), line);
    }

    @ParameterizedTest
    @CsvSource({
        "identification.json,identify data/arff/two-dof.arff --poles 4 --output head.acc.z --input platform.acc.z --json",
        "results.json,track data/arff/one-dof-step.arff --estimator ekf,particle --particles 60 --seed 3 --detector none --quiet",
        "frf.json,frf data/arff/one-dof-step.arff --wavelet --segment 4 --skin head=30:0.35",
        "exposure.json,exposure --boxcar data/arff/ride-subject1.arff --task haul=380",
        "seat.json,seat --floor EM1 --mass 55 --controller passive --seconds 5",
    })
    void aResultIsMadeAgainByItsOwnLine(String result, String given) throws Exception {
        byte[] first = made(List.of(given.split(" ")), result, "first");
        List<String> line = shell(new ObjectMapper().readTree(first).get("provenance").get("command").asText());
        assertEquals("wbv", line.get(0));
        assertEquals(new String(first, StandardCharsets.UTF_8),
                new String(made(line.subList(1, line.size()), result, "second"), StandardCharsets.UTF_8));
    }

    @Test
    void linesNameNoPlaceOfResultsAndNoWayOfTelling() {
        CommandSpec spec = parsed(List.of("analyze", "a.csv", "--gz", "--out", "there", "--json", "--quiet"));
        assertEquals("wbv analyze a.csv --start-frequency 5 --start-damping 0.4 --gz", ResultProvenance.line(spec));
    }

    private byte[] made(List<String> words, String result, String name) throws IOException {
        List<String> all = new ArrayList<>(words);
        all.addAll(List.of("--out", folder.resolve(name).toString()));
        Run run = Run.of(all.toArray(String[]::new));
        assertEquals(0, run.code(), run.err());
        return Files.readAllBytes(folder.resolve(name).resolve(result));
    }

    /** Every option has the same value when the line is read, and nothing is said that changes no result. */
    private static String readsBack(List<String> words) throws Exception {
        CommandSpec given = parsed(words);
        String line = ResultProvenance.line(given);
        List<String> again = shell(line);
        assertEquals("wbv", again.get(0));
        assertEquals(List.of(), again.stream().filter(ResultProvenance.WITHOUT_EFFECT::contains).toList(), line);
        List<String> whole = new ArrayList<>(again.subList(1, again.size()));
        if (given.findOption("--out") != null && given.findOption("--out").required()) {
            whole.addAll(List.of("--out", "it"));
        }
        CommandSpec read = parsed(whole);
        assertEquals(values(given), values(read), line);
        assertEquals(line, ResultProvenance.line(read));
        return line;
    }

    private static Map<String, String> values(CommandSpec command) {
        Map<String, String> values = new TreeMap<>();
        for (ArgSpec each : command.args()) {
            if (!(each instanceof OptionSpec option && ResultProvenance.WITHOUT_EFFECT.contains(option.longestName()))) {
                values.put(each instanceof OptionSpec option ? option.longestName() : each.paramLabel(),
                        String.valueOf(each.<Object>getValue()));
            }
        }
        return values;
    }

    private static CommandSpec parsed(List<String> words) {
        ParseResult result = Commands.all().parseArgs(words.toArray(String[]::new));
        while (result.hasSubcommand()) {
            result = result.subcommand();
        }
        return result.commandSpec();
    }

    private static List<String> shell(String line) throws Exception {
        Process shell = new ProcessBuilder("/bin/sh", "-c", "printf '%s\\0' " + line).redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        String out = new String(shell.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, shell.waitFor());
        return List.of(out.substring(0, out.length() - 1).split("\0", -1));
    }

    private static String invented(ArgSpec each) {
        Class<?> type = each.auxiliaryTypes()[0];
        return each.typeInfo().isMap() ? "a b=it's" : type == boolean.class ? "true" : type == char.class ? "x"
                : type.isPrimitive() || Number.class.isAssignableFrom(type) ? "7" : "it's $HOME/@ *.csv";
    }

    private static List<CommandSpec> leaves(CommandSpec command) {
        return command.subcommands().isEmpty() ? List.of(command) : command.subcommands().values().stream().map(CommandLine::getCommandSpec)
                .filter(each -> !each.name().equals("help")).flatMap(each -> leaves(each).stream()).toList();
    }

    private static List<String> path(CommandSpec command) {
        List<String> names = List.of(command.qualifiedName().split(" "));
        return names.subList(1, names.size());
    }
}

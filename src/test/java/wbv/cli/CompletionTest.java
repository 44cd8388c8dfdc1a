package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** Shells complete what wbv knows. A shell that is not here is not asked. */
class CompletionTest {

    @TempDir
    private Path folder;

    private Path script(String shell) throws IOException {
        Run run = Run.of("completion", shell);
        assertEquals(0, run.code(), run.err());
        return Files.writeString(folder.resolve("script"), run.out());
    }

    private static String said(String... line) throws IOException, InterruptedException {
        Assumptions.assumeTrue(
                Arrays.stream(System.getenv("PATH").split(":")).anyMatch(place -> Files.isExecutable(Path.of(place, line[0]))),
                line[0] + " is not here");
        Process process = new ProcessBuilder(line).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), text);
        return text;
    }

    private String bash(Path script, String words) throws IOException, InterruptedException {
        return said("bash", "-c",
                "source '" + script + "'; COMP_WORDS=(" + words
                        + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _complete_wbv; echo ${COMPREPLY[@]}")
                .strip();
    }

    @Test
    void bashCompletesCommandsAndOptions() throws Exception {
        Path script = script("bash");
        assertEquals("analyze", bash(script, "wbv ana"));
        assertEquals("--quiet", bash(script, "wbv analyze --qu"));
        assertEquals("apply", bash(script, "wbv states a"));
        assertEquals("--estimator", bash(script, "wbv track --est"));
    }

    @Test
    void zshTakesThatOfBash() throws Exception {
        assertEquals("_bash_complete -F _complete_wbv -o default\n",
                said("zsh", "-fc", "autoload -U compinit && compinit -u -D; source '" + script("zsh")
                        + "'; print ${_comps[wbv]}"));
    }

    private static Set<String> fish(Path script, String line) throws IOException, InterruptedException {
        Set<String> words = new TreeSet<>();
        said("fish", "-c", "source '" + script + "'; complete -C '" + line + "'").lines().forEach(each -> words.add(each.split("\t")[0]));
        return words;
    }

    @Test
    void fishCompletesEveryCommandWithItsOptions() throws Exception {
        Path script = script("fish");
        CommandLine whole = Commands.all();
        assertEquals(new TreeSet<>(whole.getSubcommands().keySet()), fish(script, "wbv "));
        for (List<String> path : List.of(List.of("analyze"), List.of("export"), List.of("net", "export"), List.of("states", "train"))) {
            CommandLine command = whole;
            for (String word : path) {
                command = command.getSubcommands().get(word);
            }
            Set<String> options = new TreeSet<>();
            command.getCommandSpec().options().stream().map(OptionSpec::longestName).forEach(options::add);
            assertEquals(options, fish(script, "wbv " + String.join(" ", path) + " --"), path.toString());
        }
        assertTrue(fish(script, "wbv analyze data/").contains("data/arff/"), "files");
    }

    @Test
    void anotherShellIsRefused() {
        Run run = Run.of("completion", "tcsh");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("SHELL must be bash, zsh or fish: tcsh"), run.err());
    }
}

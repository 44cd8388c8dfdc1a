package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/**
 * docs/reference/commands.md says what {@code --help} of every command prints, neither more nor less. It is written by
 * {@code mvn -B -q test -Dtest=CommandReferenceTest -Dwbv.regenerate=true}, from what picocli prints {@code --help} from. (picocli's own
 * pages of a manual are AsciiDoc, which MkDocs does not read.)
 */
class CommandReferenceTest {

    private static final Path PAGE = Path.of("docs/reference/commands.md");
    private static final String TOP = """
            # Commands

            What `--help` prints, command by command. On Windows type `wbv` for `./wbv`. Exit codes: 0 done, 1 the data or the model \
            is at fault,
            2 wrong usage, 3 wbv is at fault.

            """;

    private static List<CommandLine> commands() {
        List<CommandLine> commands = new ArrayList<>();
        gather(Commands.all(), commands);
        return commands;
    }

    private static void gather(CommandLine command, List<CommandLine> commands) {
        if (!(command.getCommand() instanceof CommandLine.HelpCommand)) {
            commands.add(command);
            command.getSubcommands().values().forEach(below -> gather(below, commands));
        }
    }

    @Test
    void thePageIsWhatTheProgramSays() throws IOException {
        StringBuilder page = new StringBuilder(TOP);
        commands().forEach(command -> page.append(section(command)));
        if (Boolean.getBoolean("wbv.regenerate")) {
            Files.writeString(PAGE, page);
        }
        assertEquals(page.toString(), Files.readString(PAGE),
                PAGE + " is not what the program says now; write it anew with -Dwbv.regenerate=true");
    }

    /** Held to what is printed, whose words are the page's, in the same order. */
    @TestFactory
    Stream<DynamicTest> theSectionOfACommandSaysWhatItsHelpPrints() throws IOException {
        Assumptions.assumeFalse(Boolean.getBoolean("wbv.regenerate"), "the page is being written");
        String page = Files.readString(PAGE);
        return commands().stream().map(CommandLine::getCommandSpec).map(spec -> DynamicTest.dynamicTest(spec.qualifiedName(), () -> {
            List<String> words = new ArrayList<>(Arrays.asList(spec.qualifiedName().split(" ")));
            words.remove(0);
            words.add("--help");
            Run help = Run.of(words.toArray(String[]::new));
            String begin = "\n## " + spec.qualifiedName() + "\n";
            String section = page.substring(page.indexOf(begin) + begin.length()).split("\n## ")[0];
            assertEquals(bare(help.out()), bare(plain(section)));
        }));
    }

    private static String bare(String text) {
        return text.replaceAll("\\s", "");
    }

    /** What stays of Markdown where its marks are left out. */
    private static String plain(String markdown) {
        StringBuilder text = new StringBuilder();
        boolean code = false;
        for (String line : markdown.lines().toList()) {
            if (line.startsWith("```")) {
                code = !code;
            } else if (code) {
                text.append(line).append('\n');
            } else if (!line.matches("\\| \\w+ \\| what it does \\||[|-]+")) {
                text.append(
                        line.replaceAll("\\[`([^`]*)`]\\([^)]*\\)", "$1").replaceAll("(?<!\\\\)\\||`", "").replaceAll("\\\\([|<*])", "$1"))
                        .append('\n');
            }
        }
        return text.toString();
    }

    private static String section(CommandLine command) {
        CommandSpec spec = command.getCommandSpec();
        Help help = command.getHelp();
        StringBuilder text = new StringBuilder("## " + spec.qualifiedName() + "\n\n");
        text.append("```text\nUsage: ").append(help.synopsis("Usage: ".length())).append("```\n\n");
        text.append(prose(String.join(" ", spec.usageMessage().description()))).append("\n\n");
        List<String> rows = new ArrayList<>();
        Help.ColorScheme plain = Help.defaultColorScheme(Ansi.OFF);
        spec.positionalParameters()
                .forEach(each -> rows.add(row(help.createDefaultParameterRenderer().render(each, help.parameterLabelRenderer(), plain),
                        each.description())));
        spec.options().stream().sorted(Help.createShortOptionNameComparator()).forEach(each -> rows.add(row(
                help.createDefaultOptionRenderer().render(each, help.parameterLabelRenderer(), plain), each.description())));
        text.append("| option | what it does |\n|---|---|\n");
        rows.forEach(text::append);
        text.append('\n');
        return text.append(below(spec)).append(footer(spec)).toString();
    }

    private static String row(Help.Ansi.Text[][] cells, String[] description) {
        StringBuilder name = new StringBuilder();
        for (int i = 0; i < cells[0].length - 1; i++) {
            name.append(cells[0][i].plainString().strip()).append(cells[0][i].plainString().equals(",") ? " " : "");
        }
        return "| `" + name.toString().replace("|", "\\|") + "` | " + prose(String.join(" ", description)).replace("|", "\\|") + " |\n";
    }

    private static String prose(String text) {
        return text.replace("%%", "%").replace("%n", " ").replace("<", "\\<").replace("*", "\\*");
    }

    private static String below(CommandSpec spec) {
        if (spec.subcommands().isEmpty()) {
            return "";
        }
        StringBuilder text = new StringBuilder("Commands:\n\n| command | what it does |\n|---|---|\n");
        spec.subcommands().forEach((name, each) -> {
            UsageMessageSpec usage = each.getCommandSpec().usageMessage();
            String description = prose(String.join(" ", usage.header().length > 0 ? usage.header() : usage.description())).replace("|",
                    "\\|");
            String anchor = each.getCommandSpec().qualifiedName().replace(' ', '-');
            text.append(
                    each.getCommand() instanceof CommandLine.HelpCommand ? "| `" + name + "` | " : "| [`" + name + "`](#" + anchor + ") | ")
                    .append(description).append(" |\n");
        });
        return text.append('\n').toString();
    }

    private static String footer(CommandSpec spec) {
        String lines = String.join("\n", spec.usageMessage().footer()).replace("%%", "%").strip();
        return lines.isEmpty() ? "" : "```text\n" + lines + "\n```\n\n";
    }
}

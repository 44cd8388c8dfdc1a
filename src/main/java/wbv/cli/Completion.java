package wbv.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code wbv completion}: what a shell needs to complete commands, options and file names. */
@Command(name = "completion", mixinStandardHelpOptions = true,
        description = "Prints what a shell needs to complete commands and options of wbv after TAB; files are completed where no word "
                + "fits. The line of the example in ~/.bashrc, ~/.zshrc or ~/.config/fish/config.fish keeps it.",
        footer = {"", "Examples:", "  source <(wbv completion bash)", "  source <(wbv completion zsh)", "  wbv completion fish | source"})
final class Completion implements Callable<Integer> {

    /** Characters of a description that have room beside a word. */
    private static final int WIDE = 80;

    @Parameters(paramLabel = "SHELL", description = "bash, zsh or fish")
    private String shell;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        CommandLine whole = spec.root().commandLine();
        spec.commandLine().getOut().print(switch (shell.toLowerCase(Locale.ROOT)) {
            case "bash", "zsh" -> AutoComplete.bash(spec.root().name(), whole); // which loads zsh's way of taking bash's
            case "fish" -> fish(spec.root());
            default -> throw new ParameterException(spec.commandLine(), "SHELL must be bash, zsh or fish: " + shell);
        });
        spec.commandLine().getOut().flush();
        return 0;
    }

    /** The same for fish, which picocli does not write: a line for each command and each option, where it may stand. */
    private static String fish(CommandSpec root) {
        StringBuilder text = new StringBuilder("# fish completion of " + root.name() + "\n");
        fish(root, new ArrayList<>(), text);
        return text.toString();
    }

    private static void fish(CommandSpec command, List<String> path, StringBuilder text) {
        List<String> names = List.copyOf(command.subcommands().keySet());
        List<String> conditions = new ArrayList<>();
        path.forEach(word -> conditions.add("__fish_seen_subcommand_from " + word));
        command.root().subcommands().forEach((name, each) -> {
            if (path.size() == 1 && each.getSubcommands().containsKey(path.get(0))) {
                conditions.add("not __fish_seen_subcommand_from " + name); // as 'net export' is not 'export'
            }
        });
        if (path.isEmpty()) {
            conditions.add("__fish_use_subcommand");
        } else if (!names.isEmpty()) {
            conditions.add("not __fish_seen_subcommand_from " + String.join(" ", names));
        }
        String line = "complete -c " + command.root().name() + " -n " + quoted(String.join("; and ", conditions));
        command.subcommands().forEach((name, each) -> text.append(line).append(" -f -a ").append(name).append(" -d ").append(quoted(brief(
                each.getCommandSpec().usageMessage().description()))).append('\n'));
        for (OptionSpec option : command.options()) {
            text.append(line);
            for (String name : option.names()) {
                text.append(name.startsWith("--") ? " -l " + name.substring(2) : " -s " + name.substring(1));
            }
            text.append(option.arity().max() > 0 ? " -r" : "").append(" -d ").append(quoted(brief(option.description()))).append('\n');
        }
        command.subcommands().forEach((name, each) -> {
            List<String> below = new ArrayList<>(path);
            below.add(name);
            fish(each.getCommandSpec(), below, text);
        });
    }

    /** The first clause of a description. */
    private static String brief(String... description) {
        String whole = String.join(" ", description).replaceAll("\\$\\{[^}]*}", "").replace("%%", "%").replaceAll(" ?\\(\\)", "");
        String clause = whole.replace("%n", "").split("[.:;] |, such as|\\. *$", 2)[0];
        return clause.length() <= WIDE ? clause : clause.substring(0, clause.lastIndexOf(' ', WIDE)) + " …";
    }

    private static String quoted(String text) {
        return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'";
    }
}

package wbv.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.regex.Pattern;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import wbv.result.ResultsJson;

/** How a command answers: on standard output in words or as JSON; what it says beside that goes to standard error. */
final class Answer {

    private static final Pattern SEVERE = Pattern.compile("(?m)^(\\s*)(WARNING|ERROR):");
    private static final Pattern MILD = Pattern.compile("(?m)^(\\s*)(NOTE|QUESTION):");

    @Option(names = "--json", description = "print the results as JSON instead of a summary")
    private boolean json;

    @Option(names = "--quiet", description = "show no progress and list no files: the answer alone")
    private boolean quiet;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    /** Results for machines, made only if they are asked for. */
    interface Json {
        String text() throws IOException;
    }

    /** Files that were written, where they are all that there is to say. */
    record Written(List<String> wrote) {
        Written(String... files) {
            this(List.of(files));
        }
    }

    boolean isJson() {
        return json;
    }

    ProgressBar progress() {
        return quiet ? ProgressBar.hidden() : ProgressBar.onTerminal();
    }

    /**
     * Prints what was found.
     *
     * @param wrote the files that there are now, as the last lines
     * @param machines the same as JSON
     */
    void print(String summary, String wrote, Json machines) throws IOException {
        PrintWriter out = spec.commandLine().getOut();
        out.print(json ? machines.text() : coloured(summary + (quiet ? "" : wrote), Ansi.AUTO.enabled()));
        out.flush();
    }

    /** Prints which files were written, where nothing was found. */
    void print(String wrote, Written files) throws IOException {
        print("", wrote, () -> ResultsJson.render(files));
    }

    /** A line beside the answer, for people. */
    void remark(String line) {
        if (!quiet) {
            spec.commandLine().getErr().println(coloured(line, Ansi.AUTO.enabled()));
        }
    }

    /** Words that ask for attention in colour: on a terminal whose user has not set NO_COLOR. */
    static String coloured(String text, boolean colour) {
        return colour ? MILD.matcher(SEVERE.matcher(text).replaceAll("$1\u001b[1;33m$2\u001b[0m:")).replaceAll("$1\u001b[1;36m$2\u001b[0m:")
                : text;
    }
}

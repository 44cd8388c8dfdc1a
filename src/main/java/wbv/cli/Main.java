package wbv.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;
import wbv.recording.DataFault;
import wbv.recording.OneLine;
import wbv.recording.Unfinished;
import wbv.task.AdmittedClasses;

/** The command {@code wbv}: runs one of its {@link Commands}, and turns what went wrong into one line and an exit code. */
@Command(name = "wbv", versionProvider = Version.class, mixinStandardHelpOptions = true, synopsisSubcommandLabel = "COMMAND",
        description = "Vibration of seated people from inertial sensors: streams, body parameters, reports.",
        footer = {"", "Example:", "  wbv analyze data/arff/ride-subject1.arff --out out", "",
            "Exit codes: 0 done, 1 the data or the model is at fault, 2 wrong usage, 3 wbv is at fault."})
public final class Main implements Runnable {

    static final int DATA_AT_FAULT = 1;
    static final int WBV_AT_FAULT = 3;

    @Spec
    private CommandSpec spec;

    @Override
    public void run() {
        throw new ParameterException(spec.commandLine(), "say what to do: a COMMAND is missing");
    }

    public static void main(String[] arguments) {
        AdmittedClasses.enforce();
        System.exit(execute(arguments));
    }

    /** Runs one command line and returns its exit code; prints to standard output and standard error. */
    static int execute(String... arguments) {
        PrintWriter out = new PrintWriter(System.out, true, StandardCharsets.UTF_8);
        PrintWriter err = new PrintWriter(System.err, true, StandardCharsets.UTF_8);
        int code = run(out, err, arguments);
        // A PrintStream keeps to itself that its disk is full or its reader gone.
        if (code == CommandLine.ExitCode.OK && (out.checkError() || System.out.checkError())) {
            err.println("wbv: standard output: cannot be written; is its disk full, or its reader gone?");
            return DATA_AT_FAULT;
        }
        return code;
    }

    /**
     * Runs one command line inside another program, such as Python, which goes on afterwards.
     *
     * @param out what the command prints; {@code wbv task} and {@code wbv live} print to standard output all the same
     * @param err what is wrong, in one line
     * @return the exit code: 0 done, 1 the data or the model is at fault, 2 wrong usage, 3 wbv is at fault
     */
    public static int run(PrintWriter out, PrintWriter err, String... arguments) {
        CommandLine line = Commands.of(arguments)
                .setOut(out)
                .setErr(err)
                .setParameterExceptionHandler(Main::wrongUsage)
                .setExecutionExceptionHandler(Main::report);
        try {
            return line.execute(arguments);
        } catch (OutOfMemoryError full) {
            long had = Runtime.getRuntime().maxMemory() >> 20;
            line.getErr().println("wbv: " + had + " MiB of memory are too little for this; give Java more, as in WBV_JAVA_OPTS=-Xmx"
                    + Math.max(1, (2 * had + 1023) >> 10) + "g");
            return WBV_AT_FAULT;
        }
    }

    private static int wrongUsage(ParameterException fault, String[] arguments) {
        CommandLine command = fault.getCommandLine();
        command.getErr().println("wbv: " + OneLine.of(fault.getMessage()));
        if (!CommandLine.UnmatchedArgumentException.printSuggestions(fault, command.getErr())) {
            command.getErr().println("Try '" + command.getCommandSpec().qualifiedName() + " --help'.");
        }
        return CommandLine.ExitCode.USAGE;
    }

    private static int report(Exception thrown, CommandLine command, ParseResult whole) {
        ParseResult asked = command.getParseResult(); // of the subcommand
        Exception fault = thrown instanceof UncheckedIOException file ? file.getCause() : thrown;
        if (fault instanceof DataFault data) {
            command.getErr().println("wbv: " + subject(asked).map(data::of).orElse(data).getMessage());
            return DATA_AT_FAULT;
        }
        if (fault instanceof FileSystemException file) {
            command.getErr().println("wbv: " + OneLine.of(inWords(file, asked)));
            return DATA_AT_FAULT;
        }
        if (fault.getClass() == IOException.class) { // the system's own words, as where a disk is full or taken away; no parser's fault
            boolean folder = "Is a directory".equals(fault.getMessage()); // said by a read alone
            command.getErr().println("wbv: " + OneLine.of(folder ? "a folder is named where a file is needed"
                    : out(asked).orElse("results") + ": " + fault.getMessage()));
            return DATA_AT_FAULT;
        }
        command.getErr().println("wbv: this is a fault of wbv, please report it with the lines below (version " + Version.text() + ")");
        fault.printStackTrace(command.getErr());
        return WBV_AT_FAULT;
    }

    /** What the command was about: the recordings that it was given, or else the models. */
    private static Optional<String> subject(ParseResult given) {
        for (String label : List.of("RECORDING", "MODEL", "FILE")) {
            List<String> names = new ArrayList<>();
            for (ArgSpec each : given.matchedArgs()) {
                if (each.paramLabel().equals(label) && !(each instanceof OptionSpec option && option.longestName().equals("--out"))) {
                    names.addAll(each.originalStringValues());
                }
            }
            if (!names.isEmpty()) {
                return Optional.of(together(names.stream().distinct().toList()));
            }
        }
        return Optional.empty();
    }

    private static String together(List<String> names) {
        String first = names.get(0).equals("-") ? "standard input" : names.get(0);
        return names.size() == 1 ? first
                : names.size() == 2 ? first + " and " + names.get(1) : first + " and " + (names.size() - 1) + " more";
    }

    private static String inWords(FileSystemException fault, ParseResult asked) {
        String file = named(fault.getFile(), asked);
        if (fault instanceof NoSuchFileException) {
            return file + ": there is no such file or folder";
        }
        if (fault instanceof AccessDeniedException) {
            return file + ": permission denied";
        }
        if (fault instanceof FileAlreadyExistsException) {
            return file + ": is a file; results need a folder";
        }
        return file + ": " + (fault.getReason() == null ? "cannot be read or written" : fault.getReason());
    }

    /** Where results were to go, as it was asked. */
    private static Optional<String> out(ParseResult asked) {
        return asked.hasMatchedOption("--out") ? asked.matchedOption("--out").originalStringValues().stream().findFirst()
                : Optional.empty();
    }

    /** A file of results by the name that it was to have. */
    private static String named(String file, ParseResult asked) {
        if (file == null || !Unfinished.isIn(Path.of(file))) {
            return file;
        }
        Path out = Path.of(out(asked).orElse("out"));
        Path name = Path.of(file).getFileName();
        return Unfinished.isIn(name) ? out.toString() : out.resolve(name).toString();
    }
}

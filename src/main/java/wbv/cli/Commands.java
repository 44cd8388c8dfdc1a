package wbv.cli;

import java.util.List;
import java.util.Optional;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;

/**
 * The commands of {@code wbv}, in the order in which help lists them. To find out by reflection what all of them take is most of a start:
 * the one that is asked for is enough.
 */
final class Commands {

    private static final List<Class<?>> EACH = List.of(Analyze.class, Exposure.class, Frf.class, Track.class, Live.class, Fleet.class,
            Identify.class, Poles.class, States.class, Diagnose.class, Prove.class, SuspensionSeat.class, Convert.class, MapColumns.class,
            Simulate.class, Export.class, Net.class, Task.class, Completion.class, CommandLine.HelpCommand.class);
    /** Those that ask what the others take. */
    private static final List<Class<?>> ABOUT_ALL = List.of(Completion.class, CommandLine.HelpCommand.class);

    private Commands() {}

    /** {@code wbv} with all of its commands. */
    static CommandLine all() {
        CommandLine wbv = new CommandLine(new Main());
        EACH.forEach(each -> wbv.addSubcommand(new CommandLine(each)));
        return wbv;
    }

    /** {@code wbv} with those commands that a command line needs. */
    static CommandLine of(String... arguments) {
        Optional<Class<?>> asked = EACH.stream().filter(each -> arguments.length > 0 && described(each).name().equals(arguments[0]))
                .filter(each -> !ABOUT_ALL.contains(each)).findFirst();
        if (asked.isPresent()) {
            return new CommandLine(new Main()).addSubcommand(new CommandLine(asked.get()));
        }
        boolean aboutNone = arguments.length == 0 || arguments.length == 1 && arguments[0].startsWith("-");
        return aboutNone ? listed() : all();
    }

    /** {@code wbv} with what its own help says of its commands. */
    private static CommandLine listed() {
        CommandLine wbv = new CommandLine(new Main());
        for (Class<?> each : EACH) {
            CommandSpec listed = CommandSpec.create().name(described(each).name());
            listed.usageMessage().header(described(each).header()).description(described(each).description());
            wbv.addSubcommand(listed);
        }
        return wbv;
    }

    private static Command described(Class<?> command) {
        return command.getAnnotation(Command.class);
    }
}

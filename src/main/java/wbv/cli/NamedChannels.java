package wbv.cli;

import java.util.List;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import wbv.recording.Channel;

/** Channels that a command line names; a name that is none is wrong usage. */
final class NamedChannels {

    private NamedChannels() { }

    static Channel of(CommandSpec spec, String name) {
        try {
            return Channel.parse(name);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage());
        }
    }

    static List<Channel> of(CommandSpec spec, List<String> names) {
        return names.stream().map(name -> of(spec, name)).toList();
    }
}

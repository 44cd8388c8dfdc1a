package wbv.cli;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import wbv.recording.Channel;

/** Options that name places. */
final class Places {

    private Places() { }

    /** @throws ParameterException if an option's value can be no place */
    static void require(CommandSpec spec, String option, String place) {
        if (!Channel.isLocation(place)) {
            throw new ParameterException(spec.commandLine(), option + " names a place, such as head, a word of a-z, 0-9 and _: '" + place + "'");
        }
    }
}

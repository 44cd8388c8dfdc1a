package wbv.cli;

import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import wbv.recording.Channel;

/** What the words of a command line may be; anything else is wrong usage. */
final class Usage {

    private Usage() {}

    static Channel channel(CommandSpec spec, String name) {
        try {
            return Channel.parse(name);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage());
        }
    }

    static List<Channel> channels(CommandSpec spec, List<String> names) {
        return names.stream().map(name -> channel(spec, name)).toList();
    }

    static String place(CommandSpec spec, String option, String name) {
        if (!Channel.isLocation(name)) {
            throw new ParameterException(spec.commandLine(),
                    option + " names a place, such as head, a word of a-z, 0-9 and _: '" + name + "'");
        }
        return name;
    }

    static double within(CommandSpec spec, String option, double value, double least, double most) {
        return within(spec, option, value, least, most, "");
    }

    /** @param unit as it is said after the bounds: a blank and the unit */
    static double within(CommandSpec spec, String option, double value, double least, double most, String unit) {
        if (!(value >= least && value <= most)) {
            throw new ParameterException(spec.commandLine(),
                    String.format(Locale.ROOT, "%s must be %s to %s%s: %s", option, plain(least), plain(most), unit, plain(value)));
        }
        return value;
    }

    private static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15 ? Long.toString((long) value) : Double.toString(value);
    }
}

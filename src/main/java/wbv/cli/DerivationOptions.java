package wbv.cli;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.sensing.Derivations;

/** How a command is told to derive channels from those of a recording. */
final class DerivationOptions {

    @Option(names = "--still", paramLabel = "FROM:TO",
            description = "seconds of the recording in which everyone holds still: turns sensors into the axes of the body")
    private Optional<String> still = Optional.empty();

    @Option(names = "--free", paramLabel = "PLACE", split = ",",
            description = "adds PLACE.acc: acceleration without gravity, in the axes of the place, from accg and quat or gyr")
    private List<String> free = new ArrayList<>();

    @Option(names = "--lever", paramLabel = "PLACE:X:Y:Z=NAME",
            description = "adds the acceleration of the point NAME, so many metres from PLACE on the same segment")
    private Map<String, String> levers = new LinkedHashMap<>();

    @Option(names = "--joint", paramLabel = "LOWER:UPPER=NAME",
            description = "adds NAME.ang: how UPPER is bent against LOWER (y forward, x to the right, z turned to the left)")
    private Map<String, String> joints = new LinkedHashMap<>();

    @Option(names = "--settling", paramLabel = "S", defaultValue = "10",
            description = "time constant with which gravity holds the tilt where there is no quaternion (${DEFAULT-VALUE})")
    private double settling;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    /** What is to be derived; may be nothing. */
    Derivations wanted() {
        try {
            List<Derivations.Lever> points = new ArrayList<>();
            levers.forEach((key, name) -> {
                String[] words = split("--lever", key, name, 4, "PLACE:X:Y:Z=NAME, such as seat:0.1:0:0.3=hip");
                points.add(new Derivations.Lever(words[0], Arrays.stream(words).skip(1).map(DerivationOptions::number).toList(),
                        name));
            });
            List<Derivations.Joint> pairs = new ArrayList<>();
            joints.forEach((key, name) -> {
                String[] words = split("--joint", key, name, 2, "LOWER:UPPER=NAME, such as sternum:head=neck");
                pairs.add(new Derivations.Joint(words[0], words[1], name));
            });
            Optional<Derivations.Still> pose = still.map(text -> {
                String[] words = split("--still", text, "", 2, "FROM:TO in s, such as 0:5");
                return new Derivations.Still(number(words[0]), number(words[1]));
            });
            return new Derivations(pose, free.stream().distinct().toList(), points, pairs, settling);
        } catch (IllegalArgumentException wrong) {
            throw new ParameterException(spec.commandLine(), wrong.getMessage());
        }
    }

    private static String[] split(String option, String text, String name, int count, String form) {
        String[] words = text.split(":", -1);
        if (words.length != count) {
            throw new IllegalArgumentException(option + " " + text + (name.isEmpty() ? "" : "=" + name) + " is not " + form);
        }
        return words;
    }

    private static double number(String text) {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException no) {
            throw new IllegalArgumentException("'" + text + "' is no number");
        }
    }
}

package wbv.fmi;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;

/**
 * Which variable of a unit is which channel.
 *
 * @param inputs  that take a recorded channel
 * @param held    inputs that find none, and keep the value that they start with
 * @param places  of these, forces: one that was left out may act there
 * @param outputs that give a channel
 * @param notes   what was assumed, in words
 */
record Wiring(Map<Variable, Channel> inputs, List<Variable> held, List<Variable> places, Map<Variable, Channel> outputs,
        List<String> notes) {

    private static final String FORCE = "force.";

    /**
     * Finds channels for variables: named by the user, or as {@code platform.acc.z} or {@code platform_acc_z}, alone or behind the names of
     * components.
     *
     * @param inputs  channels by name of a variable, as the user said
     * @param outputs likewise
     * @throws DataFault if the user named a variable that is none, no input finds a channel, no output is one that was recorded, or units
     *                   disagree
     */
    static Wiring of(Description unit, Recording recording, Map<String, Channel> inputs, Map<String, Channel> outputs, String name) {
        List<Variable> entries = unit.reals(Variable.Role.INPUT);
        List<Variable> exits = new ArrayList<>(unit.reals(Variable.Role.OUTPUT));
        unit.variables().stream().filter(each -> each.real() && each.role() == Variable.Role.OTHER && outputs.containsKey(each.name()))
                .forEach(exits::add);
        known(inputs, entries, "--map-input", "input", name);
        known(outputs, exits, "--map-output", "output", name);
        List<String> notes = new ArrayList<>();
        Map<Variable, Channel> wired = new LinkedHashMap<>();
        List<Variable> held = new ArrayList<>();
        for (Variable entry : entries) {
            Optional<
                    Channel> channel = Optional.ofNullable(inputs.get(entry.name())).or(() -> channel(entry.name()).filter(recording::has));
            channel.filter(each -> !recording.has(each)).ifPresent(missing -> {
                throw new DataFault("the recording lacks " + missing + ", which --map-input gives to " + entry.name() + "; it has "
                        + recording.channels());
            });
            channel.ifPresentOrElse(each -> wired.put(entry, each), () -> held.add(entry));
        }
        if (wired.isEmpty()) {
            throw DataFault.in(name,
                    "none of its inputs " + names(entries) + " is named as a channel that was recorded, " + recording.channels()
                            + "; say which is which with --map-input VARIABLE=CHANNEL");
        }
        Map<Variable, Channel> given = new LinkedHashMap<>();
        List<Variable> left = new ArrayList<>();
        for (Variable exit : exits) {
            Optional.ofNullable(outputs.get(exit.name())).or(() -> channel(exit.name())).ifPresentOrElse(each -> given.put(exit, each),
                    () -> left.add(exit));
        }
        if (given.isEmpty()) {
            throw DataFault.in(name, exits.isEmpty() ? "has no output that is a number of 64 bits" : "none of its outputs " + names(exits)
                    + " is named as a channel, such as head.acc.z or head_acc_z; say which is which with --map-output VARIABLE=CHANNEL");
        }
        once(given, name);
        wired.forEach((entry, channel) -> fits(entry, channel, name));
        given.forEach((exit, channel) -> fits(exit, channel, name));
        notes.add(
                "inputs " + wired.entrySet().stream().map(each -> pair(each.getKey(), each.getValue())).collect(Collectors.joining(", ")));
        List<Variable> places = held.stream().filter(each -> each.name().startsWith(FORCE) || each.unit().isForce()).toList();
        held.forEach(each -> notes.add("no channel for the input " + each.name() + ", held at " + each.start().orElse(0)
                + (each.unit().name().isEmpty() ? "" : " " + each.unit().name())
                + (places.contains(each) ? "; a place where a force may act" : "")));
        if (!left.isEmpty()) {
            notes.add("outputs that are named as no channel are left out: " + names(left));
        }
        return new Wiring(wired, List.copyOf(held), places, given, List.copyOf(notes));
    }

    private static String pair(Variable variable, Channel channel) {
        return variable.name().equals(channel.toString()) ? variable.name() : variable.name() + " = " + channel;
    }

    private static void known(Map<String, Channel> mapped, List<Variable> variables, String option, String kind, String name) {
        Set<String> names = variables.stream().map(Variable::name).collect(Collectors.toCollection(LinkedHashSet::new));
        for (String each : mapped.keySet()) {
            if (!names.contains(each)) {
                throw DataFault.in(name,
                        option + " " + each + "=" + mapped.get(each) + ": it has no " + kind + " " + each + "; there are " + names);
            }
        }
    }

    private static void once(Map<Variable, Channel> given, String name) {
        Set<Channel> seen = new HashSet<>();
        given.forEach((exit, channel) -> {
            if (!seen.add(channel)) {
                throw DataFault.in(name, "two of its outputs are " + channel + ": "
                        + names(given.entrySet().stream().filter(each -> each.getValue().equals(channel)).map(Map.Entry::getKey).toList()));
            }
        });
    }

    private static void fits(Variable variable, Channel channel, String name) {
        if (!variable.unit().fits(channel.quantity())) {
            throw DataFault.in(name, variable.name() + " is declared in " + variable.unit().name() + ", and " + channel + " is in "
                    + channel.quantity().unit());
        }
    }

    private static List<String> names(List<Variable> variables) {
        return variables.stream().map(Variable::name).toList();
    }

    /** The channel that a name says, if it says one. */
    static Optional<Channel> channel(String name) {
        String[] words = name.split("\\.");
        String last = words[words.length - 1];
        if (words.length >= 3) {
            Optional<Channel> dotted = parsed(words[words.length - 3] + "." + words[words.length - 2] + "." + last);
            if (dotted.isPresent()) {
                return dotted;
            }
        }
        int axis = last.lastIndexOf('_');
        int quantity = last.lastIndexOf('_', axis - 1);
        return quantity <= 0 ? Optional.empty()
                : parsed(last.substring(0, quantity) + "." + last.substring(quantity + 1, axis) + "." + last.substring(axis + 1));
    }

    private static Optional<Channel> parsed(String name) {
        try {
            return Optional.of(Channel.parse(name));
        } catch (IllegalArgumentException other) {
            return Optional.empty();
        }
    }
}

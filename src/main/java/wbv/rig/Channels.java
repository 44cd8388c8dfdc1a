package wbv.rig;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/** The channels of a recording as a rig's spec writes them. */
final class Channels {

    private Channels() {}

    /** What is recorded when nothing is said: the vertical of a linear sitter, everything of a person. */
    static List<Channel> usual(Sitter sitter, boolean gravity) {
        if (sitter instanceof Sitter.Person) {
            return all(sitter, gravity);
        }
        Quantity quantity = gravity ? Quantity.SPECIFIC_FORCE : Quantity.ACCELERATION;
        return sitter.places().stream().filter(place -> !place.equals("seat"))
                .map(place -> new Channel(place, quantity, 'z')).toList();
    }

    /** Three accelerations and three angular rates of every place. */
    static List<Channel> all(Sitter sitter, boolean gravity) {
        List<Channel> channels = new ArrayList<>();
        sitter.places().forEach(place -> channels.addAll(of(place, gravity)));
        return channels;
    }

    /** Reads {@code all}, or places and channels separated by commas. */
    static List<Channel> parse(String text, Sitter sitter, boolean gravity) {
        List<Channel> channels = new ArrayList<>();
        for (String word : text.split(",", -1)) {
            if (word.equals("all")) {
                channels.addAll(all(sitter, gravity));
            } else if (sitter.places().contains(word)) {
                channels.addAll(of(word, gravity));
            } else {
                channels.add(Channel.parse(word));
            }
        }
        return channels;
    }

    static String format(Sitter sitter, List<Channel> channels) {
        List<Channel> all = all(sitter, false);
        if (channels.size() >= all.size() && channels.subList(0, all.size()).equals(all)) {
            return Stream.concat(Stream.of("all"), channels.stream().skip(all.size()).map(Channel::toString))
                    .collect(Collectors.joining(","));
        }
        return channels.stream().map(Channel::toString).collect(Collectors.joining(","));
    }

    private static List<Channel> of(String place, boolean gravity) {
        List<Channel> channels = new ArrayList<>();
        for (Quantity quantity : List.of(gravity ? Quantity.SPECIFIC_FORCE : Quantity.ACCELERATION, Quantity.ANGULAR_RATE)) {
            for (char axis : "xyz".toCharArray()) {
                channels.add(new Channel(place, quantity, axis));
            }
        }
        return channels;
    }
}

package wbv.recording.format;

import java.util.Collection;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.signals.Label;

/** What was measured, as the columns of a foreign table tell it, and which command suits it. */
enum Specimen {
    /** Someone who sits, or whatever else is shaken. */
    SITTER("seat"),
    /** Something that is pushed or driven on a bench: a force, a displacement or a velocity was measured, and no place of a sitter. */
    BENCH("mass");

    private static final Set<
            String> SEATED = Set.of("seat", "seatpad", "cushion", "backrest", "head", "sternum", "chest", "pelvis", "lumbar",
                    "spine", "shoulder", "neck", "torso");
    private static final Set<Quantity> PUSHED = EnumSet.of(Quantity.FORCE, Quantity.POSITION, Quantity.VELOCITY);

    private final String place;

    Specimen(String place) {
        this.place = place;
    }

    /** Whose columns these are. */
    static Specimen of(Collection<Label> columns) {
        boolean seated = columns.stream().flatMap(label -> label.place().stream()).flatMap(place -> List.of(place.split("_")).stream())
                .anyMatch(SEATED::contains);
        boolean pushed = columns.stream().flatMap(label -> label.quantity().stream()).anyMatch(PUSHED::contains);
        return pushed && !seated ? BENCH : SITTER;
    }

    /** Where a sensor sat that nobody names. */
    String place() {
        return place;
    }

    /** The command that answers most of these channels, with what it needs beside the recording. */
    String command(Set<Channel> channels) {
        boolean shaken = channels.stream()
                .anyMatch(channel -> channel.quantity() == Quantity.ACCELERATION || channel.quantity() == Quantity.SPECIFIC_FORCE);
        boolean one = channels.stream().map(Channel::location).distinct().count() == 1;
        return this == BENCH ? "diagnose --model model.json" : one && shaken ? "exposure" : "analyze";
    }
}

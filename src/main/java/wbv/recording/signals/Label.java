package wbv.recording.signals;

import java.util.Optional;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Unit;

/**
 * What a file says of one of its signals.
 *
 * @param name     what a column map calls it; no two signals of a file have the same
 * @param place    the sensor or node that it was measured at, in the file's own words
 * @param quantity what was measured, as far as it is one of ours
 * @param axis     along or about which axis
 * @param unit     as {@link Unit} writes it
 * @param sign     -1 where the sensor points against the axis, else 1
 */
public record Label(String name, Optional<String> place, Optional<Quantity> quantity, Optional<Character> axis, Optional<String> unit,
        int sign) {

    public Label {
        if (Math.abs(sign) != 1) {
            throw new IllegalArgumentException("sign must be 1 or -1: " + sign);
        }
    }

    /** A signal of which its name is all that is known: a channel in SI if it is named as one, {@code head.acc.z} or {@code head_acc_z}. */
    public static Label of(String name) {
        Optional<Channel> channel = channel(name);
        return new Label(name, channel.map(Channel::location), channel.map(Channel::quantity), channel.map(Channel::axis),
                channel.map(known -> known.quantity().unit()), 1);
    }

    /** The same with a unit that is stated beside it. */
    Label in(String stated) {
        return new Label(name, place, quantity, axis, Optional.of(stated), sign);
    }

    /** The channel that a name says, with dots or underscores between its words; of {@code ride.head_acc_z} the last word. */
    static Optional<Channel> channel(String name) {
        String word = name
                .substring(Math.max(name.lastIndexOf('/'), name.matches(".*\\.[^.]*_[^.]*_[^.]*") ? name.lastIndexOf('.') : -1) + 1);
        int axis = Math.max(word.lastIndexOf('_'), word.lastIndexOf('.'));
        int quantity = Math.max(word.lastIndexOf('_', axis - 1), word.lastIndexOf('.', axis - 1));
        if (quantity <= 0) {
            return Optional.empty();
        }
        try {
            return Optional.of(
                    Channel.parse(word.substring(0, quantity) + "." + word.substring(quantity + 1, axis) + "." + word.substring(axis + 1)));
        } catch (IllegalArgumentException other) {
            return Optional.empty();
        }
    }
}

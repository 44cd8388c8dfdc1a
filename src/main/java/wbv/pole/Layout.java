package wbv.pole;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/**
 * Which channels excite, which stays measured, and which will be absent.
 *
 * @param inputs   motion of the base; the first along the axis of all others
 * @param measured acceleration of the place whose sensor stays
 * @param absent   accelerations of the places whose sensors go, at least one
 */
public record Layout(List<Channel> inputs, Channel measured, List<Channel> absent) implements Serializable {

    public Layout {
        inputs = List.copyOf(inputs);
        absent = List.copyOf(absent);
        if (inputs.isEmpty() || absent.isEmpty()) {
            throw new IllegalArgumentException("at least one channel must excite and at least one be absent: " + inputs
                    + ", " + absent);
        }
        if (absent.contains(measured) || inputs.contains(measured)) {
            throw new IllegalArgumentException("the measured channel can be neither input nor absent: " + measured);
        }
    }

    /**
     * The layout of places along one axis, of what a recording has: the base's acceleration along it, and where they were
     * recorded, what else moves the same plane, across and about (a sitter leans and nods, so fore-and-aft motion and pitch shake
     * the head up and down).
     *
     * @throws DataFault if the base, the measured place or an absent one is not in the recording
     */
    public static Layout along(char axis, String base, String measured, List<String> absent, Collection<Channel> channels) {
        List<Channel> inputs = new ArrayList<>(List.of(require(new Channel(base, Quantity.ACCELERATION, axis), channels)));
        Channel across = new Channel(base, Quantity.ACCELERATION, axis == 'x' ? 'z' : axis == 'y' ? 'z' : 'x');
        Channel about = new Channel(base, Quantity.ANGULAR_RATE, axis == 'y' ? 'x' : 'y');
        for (Channel other : List.of(across, about)) {
            if (channels.contains(other)) {
                inputs.add(other);
            }
        }
        return new Layout(inputs, require(new Channel(measured, Quantity.ACCELERATION, axis), channels),
                absent.stream().map(place -> require(new Channel(place, Quantity.ACCELERATION, axis), channels)).toList());
    }

    private static Channel require(Channel channel, Collection<Channel> channels) {
        if (!channels.contains(channel)) {
            throw new DataFault("no channel " + channel + ", which pole clusters need; the recording has " + channels);
        }
        return channel;
    }

    /** The base's motion along the axis. */
    public Channel base() {
        return inputs.get(0);
    }

    /** Of each input, whether it is an angular rate. */
    boolean[] rates() {
        boolean[] rates = new boolean[inputs.size()];
        for (int i = 0; i < rates.length; i++) {
            rates[i] = inputs.get(i).quantity() == Quantity.ANGULAR_RATE;
        }
        return rates;
    }

    /**
     * Faults a recording that lacks what stays measured.
     *
     * @param who the recording's name, for the message
     */
    public void requireMeasured(String who, Recording recording) {
        for (Channel input : inputs) {
            require(who, recording, input);
        }
        require(who, recording, measured);
    }

    /**
     * Faults a recording that lacks any channel.
     *
     * @param who the recording's name, for the message
     */
    public void requireAll(String who, Recording recording) {
        requireMeasured(who, recording);
        absent.forEach(channel -> require(who, recording, channel));
    }

    private static void require(String who, Recording recording, Channel channel) {
        if (!recording.has(channel)) {
            throw DataFault.in(who, "has no channel " + channel + ", which the polygons rest on; it has " + recording.channels());
        }
    }
}

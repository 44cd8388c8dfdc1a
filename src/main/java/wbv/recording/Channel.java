package wbv.recording;

import java.io.Serializable;
import java.util.regex.Pattern;

/**
 * One measured axis at one place, written {@code location.quantity.axis}: {@code head.acc.z}.
 *
 * @param location a free word in lower case; {@code platform seat pelvis sternum left_shoulder right_shoulder head} are usual
 * @param quantity what is measured, and so the unit
 * @param axis     x forward, y left, z up (the basicentric axes of ISO 2631-1); w is a quaternion's real part
 */
public record Channel(String location, Quantity quantity, char axis) implements Serializable {

    /** Letters of the longest location; a longer word is no name but a slip, or damage. */
    public static final int LONGEST = 64;
    private static final Pattern LOCATION = Pattern.compile("[a-z][a-z0-9_]*");

    public Channel {
        if (!isLocation(location)) {
            throw new IllegalArgumentException(
                    "a location is a word of at most 64 letters a-z, 0-9 and _, beginning with a letter: '" + location + "'");
        }
        if (quantity.axes().indexOf(axis) < 0) {
            throw new IllegalArgumentException(
                    "the axis of " + quantity.symbol() + " is one of " + quantity.axes() + ": '" + axis + "'");
        }
    }

    /** True if a text may be a channel's location. */
    public static boolean isLocation(String text) {
        return text.length() <= LONGEST && LOCATION.matcher(text).matches();
    }

    /**
     * The channel that a name says.
     *
     * @throws IllegalArgumentException if the name is not {@code location.quantity.axis}
     */
    public static Channel parse(String name) {
        String[] words = name.split("\\.", -1);
        if (words.length != 3 || words[2].length() != 1) {
            throw new IllegalArgumentException(
                    "a channel is named location.quantity.axis, as head.acc.z: '" + name + "'");
        }
        Quantity quantity = Quantity.ofSymbol(words[1]).orElseThrow(() -> new IllegalArgumentException(
                "'" + words[1] + "' in '" + name + "' is none of the quantities " + symbols()));
        return new Channel(words[0], quantity, words[2].charAt(0));
    }

    /** The same place and quantity along another axis. */
    public Channel along(char other) {
        return new Channel(location, quantity, other);
    }

    /** The name {@code location.quantity.axis}; {@link #parse} reads it back. */
    @Override
    public String toString() {
        return location + '.' + quantity.symbol() + '.' + axis;
    }

    private static String symbols() {
        StringBuilder text = new StringBuilder();
        for (Quantity quantity : Quantity.values()) {
            text.append(text.isEmpty() ? "" : " ").append(quantity.symbol());
        }
        return text.toString();
    }
}

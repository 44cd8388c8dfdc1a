package wbv.body.number;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/** What a term of a learned law is multiplied by beside the motion of its own link: a number for every moment. */
public sealed interface Modulator {

    /** Always 1. */
    Modulator NONE = new None();

    /** Unit of its value; empty for none. */
    String unit();

    /** The other link by whose motion it goes, if it does. */
    default Optional<OtherLink> otherLink() {
        return this instanceof OtherLink other ? Optional.of(other) : Optional.empty();
    }

    /** Nothing. */
    record None() implements Modulator {
        @Override
        public String unit() {
            return "";
        }

        @Override
        public String toString() {
            return "1";
        }
    }

    /** Another channel of the recording. */
    record Measured(Channel channel) implements Modulator {
        @Override
        public String unit() {
            return "(" + channel.quantity().unit() + ")";
        }

        @Override
        public String toString() {
            return "value of " + channel;
        }
    }

    /**
     * Where a channel stands in a range, -1 at its low end and 1 at its high end, and no farther beyond: as it was recorded, nothing
     * removed, straight between its samples.
     *
     * @param low end of the range, in the channel's unit
     * @param high likewise, above it
     */
    record Level(Channel channel, double low, double high) implements Modulator {
        public Level {
            Check.above("upper end of the range of " + channel, channel.quantity().unit(), high, low);
        }

        /**
         * The channel's value there, in the channel's unit.
         *
         * @param u place in the range [1], from -1 to 1
         */
        public double value(double u) {
            return ((1 - u) * low + (1 + u) * high) / 2;
        }

        /**
         * The same as people read it, in {@link #shownUnit}.
         *
         * @param u place in the range [1], from -1 to 1
         */
        public double shown(double u) {
            return shownTimes() * value(u);
        }

        /** From the channel's unit to the one that people read: positions are told in mm [1]. */
        public double shownTimes() {
            return channel.quantity() == Quantity.POSITION ? 1e3 : 1;
        }

        /** Unit that people read. */
        public String shownUnit() {
            return channel.quantity() == Quantity.POSITION ? "mm" : channel.quantity().unit();
        }

        /**
         * Where a value of the channel lies in the range [1]: -1 at or below its lower end, 1 at or above its upper.
         *
         * @param value in the channel's unit
         */
        public double of(double value) {
            return Math.max(-1, Math.min(1, (2 * value - low - high) / (high - low)));
        }

        /** Throws an {@link IllegalArgumentException} unless it is a level. */
        public static void require(Modulator modulator) {
            if (!(modulator instanceof Level)) {
                throw new IllegalArgumentException("'" + modulator + "' is no 'level of' a channel");
            }
        }

        @Override
        public String unit() {
            return "";
        }

        @Override
        public String toString() {
            return "level of " + channel + " from " + low + " to " + high;
        }
    }

    /**
     * How far something has turned.
     *
     * @param rate measured angular rate
     */
    record Angle(Channel rate) implements Modulator {
        public Angle {
            require(rate, Quantity.ANGULAR_RATE, "angular rate");
        }

        @Override
        public String unit() {
            return "rad";
        }

        @Override
        public String toString() {
            return "angle of " + rate;
        }
    }

    /**
     * How far one place has moved against another.
     *
     * @param upper acceleration of the one
     * @param lower of the other, along the same axis
     */
    record Lean(Channel upper, Channel lower) implements Modulator {
        public Lean {
            require(upper, Quantity.ACCELERATION, "acceleration");
            require(lower, Quantity.ACCELERATION, "acceleration");
            if (upper.axis() != lower.axis()) {
                throw new IllegalArgumentException(upper + " and " + lower + " are not along one axis");
            }
        }

        @Override
        public String unit() {
            return "m";
        }

        @Override
        public String toString() {
            return "lean of " + upper + " from " + lower;
        }
    }

    private static void require(Channel channel, Quantity quantity, String word) {
        if (channel.quantity() != quantity) {
            throw new IllegalArgumentException(channel + " is no " + word);
        }
    }

    /**
     * How hard the base was shaken of late: root mean square acceleration that is forgotten exponentially.
     *
     * @param seconds time constant, &gt; 0
     */
    record Ride(double seconds) implements Modulator {
        public Ride {
            Check.positive("memory of the ride", "s", seconds);
        }

        @Override
        public String unit() {
            return "(m/s²)";
        }

        @Override
        public String toString() {
            return "ride over " + seconds + " s";
        }
    }

    /** What is taken of another link. */
    enum Of { LOAD, DEFLECTION, SPEED }

    /**
     * Another link's motion, or the force that it carries beside its static load, all positive in extension.
     *
     * @param link its index
     */
    record OtherLink(Of of, int link) implements Modulator {
        public OtherLink {
            if (link < 0) {
                throw new IllegalArgumentException("links count from 1");
            }
        }

        @Override
        public String unit() {
            return of == Of.LOAD ? "N" : of == Of.SPEED ? "(m/s)" : "m";
        }

        /** Links count from 1, in the model's order. */
        @Override
        public String toString() {
            return of.name().toLowerCase(Locale.ROOT) + " of link " + (link + 1);
        }
    }

    /** A part of another modulator. */
    enum Part { MAGNITUDE, POSITIVE, NEGATIVE }

    /** The magnitude, the positive or the negative part, both as positive numbers, of a modulator that has both signs. */
    record PartOf(Part part, Modulator whole) implements Modulator {
        public PartOf {
            if (whole instanceof None || whole instanceof PartOf || whole instanceof Ride) {
                throw new IllegalArgumentException("'" + whole + "' has no two signs to take a part of");
            }
        }

        @Override
        public String unit() {
            return whole.unit();
        }

        /**
         * The part, &gt;= 0, of a value of the whole, in its unit.
         *
         * @param value in the unit of the whole
         */
        public double of(double value) {
            return part == Part.MAGNITUDE ? Math.abs(value) : Math.max(0, part == Part.POSITIVE ? value : -value);
        }

        @Override
        public Optional<OtherLink> otherLink() {
            return whole.otherLink();
        }

        @Override
        public String toString() {
            return part.name().toLowerCase(Locale.ROOT) + (part == Part.MAGNITUDE ? " of the " : " part of the ") + whole;
        }
    }

    /**
     * Reads what {@code toString} writes.
     *
     * @throws IllegalArgumentException if it is none: the message says what is known
     */
    static Modulator parse(String text) {
        if (text.equals("1")) {
            return NONE;
        }
        Matcher channel = Pattern.compile("(value|angle) of (\\S+)").matcher(text);
        if (channel.matches()) {
            Channel named = Channel.parse(channel.group(2));
            return channel.group(1).equals("value") ? new Measured(named) : new Angle(named);
        }
        Matcher lean = Pattern.compile("lean of (\\S+) from (\\S+)").matcher(text);
        if (lean.matches()) {
            return new Lean(Channel.parse(lean.group(1)), Channel.parse(lean.group(2)));
        }
        Matcher level = Pattern.compile("level of (\\S+) from (\\S+) to (\\S+)").matcher(text);
        if (level.matches()) {
            return new Level(Channel.parse(level.group(1)), number(text, level.group(2)), number(text, level.group(3)));
        }
        Matcher part = Pattern.compile("(magnitude|positive part|negative part) of the (.+)").matcher(text);
        if (part.matches()) {
            return new PartOf(Part.valueOf(part.group(1).replace(" part", "").toUpperCase(Locale.ROOT)), parse(part.group(2)));
        }
        Matcher link = Pattern.compile("(load|deflection|speed) of link (\\d{1,6})").matcher(text);
        if (link.matches()) {
            return new OtherLink(Of.valueOf(link.group(1).toUpperCase(Locale.ROOT)), Integer.parseInt(link.group(2)) - 1);
        }
        Matcher ride = Pattern.compile("ride over (\\S+) s").matcher(text);
        if (ride.matches()) {
            return new Ride(number(text, ride.group(1)));
        }
        throw new IllegalArgumentException("'" + text
                + "' modulates nothing: known are 1, 'value of' or 'angle of' a channel, 'level of' one 'from 0 to 5', 'lean of' one "
                + "acceleration 'from' another, 'ride over 4 s', 'load', 'deflection' or 'speed of link 2', and 'magnitude', 'positive "
                + "part' or 'negative part of the' same");
    }

    private static double number(String text, String word) {
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("'" + word + "' in '" + text + "' is no number");
        }
    }
}

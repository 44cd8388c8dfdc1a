package wbv.body;

import java.util.Locale;
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

    /** What is taken of a channel. */
    enum Reading { VALUE, DISPLACEMENT, ANGLE }

    /** Another channel of the recording. @param reading itself, or the displacement of an acceleration, or the angle of a rate */
    record Measured(Reading reading, Channel channel) implements Modulator {
        public Measured {
            Quantity wanted = reading == Reading.ANGLE ? Quantity.ANGULAR_RATE : Quantity.ACCELERATION;
            if (reading != Reading.VALUE && channel.quantity() != wanted) {
                throw new IllegalArgumentException(channel + " has no " + reading.name().toLowerCase(Locale.ROOT));
            }
        }

        @Override
        public String unit() {
            return reading == Reading.VALUE ? "(" + channel.quantity().unit() + ")" : reading == Reading.ANGLE ? "rad" : "m";
        }

        @Override
        public String toString() {
            return reading.name().toLowerCase(Locale.ROOT) + " of " + channel;
        }
    }

    /** How hard the base was shaken of late: root mean square acceleration that is forgotten exponentially. @param seconds time constant, &gt; 0 */
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

    /** The force that another link carries beside its static load. @param link its index */
    record Load(int link) implements Modulator {
        public Load {
            if (link < 0) {
                throw new IllegalArgumentException("links count from 1");
            }
        }

        @Override
        public String unit() {
            return "N";
        }

        /** Links count from 1, in the model's order. */
        @Override
        public String toString() {
            return "load of link " + (link + 1);
        }
    }

    /** Reads what {@code toString} writes. @throws IllegalArgumentException if it is none: the message says what is known */
    static Modulator parse(String text) {
        if (text.equals("1")) {
            return NONE;
        }
        Matcher channel = Pattern.compile("(value|displacement|angle) of (\\S+)").matcher(text);
        if (channel.matches()) {
            return new Measured(Reading.valueOf(channel.group(1).toUpperCase(Locale.ROOT)), Channel.parse(channel.group(2)));
        }
        Matcher link = Pattern.compile("load of link (\\d{1,6})").matcher(text);
        if (link.matches()) {
            return new Load(Integer.parseInt(link.group(1)) - 1);
        }
        Matcher ride = Pattern.compile("ride over (\\S+) s").matcher(text);
        if (ride.matches()) {
            return new Ride(number(text, ride.group(1)));
        }
        throw new IllegalArgumentException("'" + text + "' modulates nothing: known are 1, 'value of', 'displacement of' or 'angle of' a channel, "
                + "'ride over 4 s' and 'load of link 2'");
    }

    private static double number(String text, String word) {
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("'" + word + "' in '" + text + "' is no number");
        }
    }
}

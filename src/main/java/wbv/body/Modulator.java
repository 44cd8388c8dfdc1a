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

    /** Whether it goes by the clock alone. */
    default boolean byTheClock() {
        return false;
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

    /** Courses in time. */
    enum Course { TIME, STEP, SETTLING, SINE, COSINE }

    /**
     * By the clock.
     *
     * @param number time of a step [s], time constant of what settles [s], frequency of a wave [Hz]; nothing for time itself, which counts in s
     */
    record Clock(Course course, double number) implements Modulator {
        public Clock {
            Check.finite("number of a course in time", "1", number);
            if (course == Course.SETTLING) {
                Check.positive("settling time", "s", number);
            }
        }

        @Override
        public String unit() {
            return course == Course.TIME ? "s" : "";
        }

        @Override
        public boolean byTheClock() {
            return true;
        }

        double at(double time) {
            return switch (course) {
                case TIME -> time;
                case STEP -> time >= number ? 1 : 0;
                case SETTLING -> -Math.expm1(-time / number);
                case SINE -> Math.sin(2 * Math.PI * number * time);
                case COSINE -> Math.cos(2 * Math.PI * number * time);
            };
        }

        @Override
        public String toString() {
            return switch (course) {
                case TIME -> "time";
                case STEP -> "step at " + number + " s";
                case SETTLING -> "settling over " + number + " s";
                case SINE -> "sine at " + number + " Hz";
                case COSINE -> "cosine at " + number + " Hz";
            };
        }
    }

    /** Reads what {@code toString} writes. @throws IllegalArgumentException if it is none: the message says what is known */
    static Modulator parse(String text) {
        if (text.equals("1")) {
            return NONE;
        }
        if (text.equals("time")) {
            return new Clock(Course.TIME, 0);
        }
        Matcher channel = Pattern.compile("(value|displacement|angle) of (\\S+)").matcher(text);
        if (channel.matches()) {
            return new Measured(Reading.valueOf(channel.group(1).toUpperCase(Locale.ROOT)), Channel.parse(channel.group(2)));
        }
        Matcher link = Pattern.compile("load of link (\\d{1,6})").matcher(text);
        if (link.matches()) {
            return new Load(Integer.parseInt(link.group(1)) - 1);
        }
        Matcher number = Pattern.compile("(ride over|step at|settling over|sine at|cosine at) (\\S+) (s|Hz)").matcher(text);
        if (number.matches() && number.group(3).equals("Hz") == number.group(1).contains("sine")) {
            double value = number(text, number.group(2));
            String word = number.group(1).substring(0, number.group(1).indexOf(' '));
            return word.equals("ride") ? new Ride(value) : new Clock(Course.valueOf(word.toUpperCase(Locale.ROOT)), value);
        }
        throw new IllegalArgumentException("'" + text + "' modulates nothing: known are 1, 'value of', 'displacement of' or 'angle of' a channel, "
                + "'ride over 4 s', 'load of link 2', 'time', 'step at 30 s', 'settling over 20 s', 'sine at 0.25 Hz' and 'cosine at 0.25 Hz'");
    }

    private static double number(String text, String word) {
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("'" + word + "' in '" + text + "' is no number");
        }
    }
}

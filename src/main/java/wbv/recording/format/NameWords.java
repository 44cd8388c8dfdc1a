package wbv.recording.format;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Unit;
import wbv.recording.signals.Label;
import wbv.recording.signals.UnitWords;

/**
 * What the words of a column's name say: {@code Acceleration x (m/s^2)}, {@code ax}, {@code seat_gyroZ_dps}.
 *
 * @param label     with what the words say
 * @param time      whether a word is one for time
 * @param magnitude whether it is the length of a vector, which is no channel
 * @param linear    whether gravity is said to be taken out
 * @param number    of a column that is one of several without names of their own, from 1; 0 if it is not
 */
record NameWords(Label label, boolean time, boolean magnitude, boolean linear, int number) {

    private static final Pattern BRACKETS = Pattern.compile("^(.*?)\\s*[\\[({]([^\\[\\](){}]*)[\\])}]\\s*$");
    private static final Pattern TAIL = Pattern.compile("^(.*?)[_ ]"
            + "(m_?s_?2|m_per_s2|mps2|mm_s2|cm_s2|g|mg|dps|deg_?s|deg_per_s|rad_?s|rad_per_s|rpm|m_s|mm_s|cm_s|km_?h|mm|cm|um|m|rad|mrad"
            + "|deg|n|kn|kgf|lbf|ms|us|ns|s|sec|v|mv|degc)$",
            Pattern.CASE_INSENSITIVE);
    private static final Pattern NUMBERED = Pattern.compile("^(.*?)(?:[(\\[]:,(\\d+)[)\\]]|[(\\[](\\d+),:[)\\]])$|^(\\d{1,3})$");
    private static final Pattern COMPACT = Pattern
            .compile("^(a|acc|accel|linacc|g|gyr|gyro|w|rot|m|mag|q|quat|f|force|v|vel|d|pos)([xyzw])$");
    private static final Map<String,
            String> TAILS = Map.ofEntries(Map.entry("ms2", "m/s2"), Map.entry("mpers2", "m/s2"), Map.entry("mps2", "m/s2"),
                    Map.entry("mms2", "mm/s2"), Map.entry("cms2", "cm/s2"),
                    Map.entry("mms", "mm/s"), Map.entry("cms", "cm/s"), Map.entry("kmh", "km/h"), Map.entry("degs", "deg/s"),
                    Map.entry("degpers", "deg/s"), Map.entry("rads", "rad/s"),
                    Map.entry("radpers", "rad/s"),
                    Map.entry("n", "N"), Map.entry("kn", "kN"), Map.entry("sec", "s"), Map.entry("v", "V"), Map.entry("mv", "mV"),
                    Map.entry("degc", "°C"));
    private static final Map<String, Quantity> QUANTITIES = Map.ofEntries(
            Map.entry("a", Quantity.ACCELERATION), Map.entry("acc", Quantity.ACCELERATION), Map.entry("accel", Quantity.ACCELERATION),
            Map.entry("linacc", Quantity.ACCELERATION), Map.entry("acceleration", Quantity.ACCELERATION),
            Map.entry("accelerometer", Quantity.ACCELERATION), Map.entry("accg", Quantity.SPECIFIC_FORCE),
            Map.entry("g", Quantity.ANGULAR_RATE), Map.entry("w", Quantity.ANGULAR_RATE), Map.entry("rot", Quantity.ANGULAR_RATE),
            Map.entry("gyr", Quantity.ANGULAR_RATE),
            Map.entry("gyro", Quantity.ANGULAR_RATE), Map.entry("gyroscope", Quantity.ANGULAR_RATE),
            Map.entry("omega", Quantity.ANGULAR_RATE),
            Map.entry("angular", Quantity.ANGULAR_RATE), Map.entry("rotation", Quantity.ANGULAR_RATE),
            Map.entry("f", Quantity.FORCE), Map.entry("force", Quantity.FORCE), Map.entry("load", Quantity.FORCE),
            Map.entry("v", Quantity.VELOCITY), Map.entry("vel", Quantity.VELOCITY), Map.entry("velocity", Quantity.VELOCITY),
            Map.entry("speed", Quantity.VELOCITY),
            Map.entry("d", Quantity.POSITION), Map.entry("pos", Quantity.POSITION), Map.entry("position", Quantity.POSITION),
            Map.entry("disp", Quantity.POSITION),
            Map.entry("displacement", Quantity.POSITION),
            Map.entry("m", Quantity.MAGNETIC_FIELD), Map.entry("mag", Quantity.MAGNETIC_FIELD),
            Map.entry("magnetometer", Quantity.MAGNETIC_FIELD),
            Map.entry("q", Quantity.QUATERNION), Map.entry("quat", Quantity.QUATERNION), Map.entry("quaternion", Quantity.QUATERNION),
            Map.entry("temp", Quantity.TEMPERATURE), Map.entry("temperature", Quantity.TEMPERATURE),
            Map.entry("voltage", Quantity.VOLTAGE));
    private static final Map<String,
            Character> AXES = Map.of("x", 'x', "y", 'y', "z", 'z', "longitudinal", 'x', "lateral", 'y', "vertical", 'z');
    private static final Set<
            String> TIMES = Set.of("t", "time", "timestamp", "zeit", "millis", "micros", "seconds", "elapsed", "uptime", "sampletime");
    private static final Set<String> MAGNITUDES = Set.of("abs", "absolute", "magnitude", "norm", "total", "resultant", "svm");
    private static final Set<String> LINEAR = Set.of("lin", "linear", "linacc", "free", "user");
    private static final Set<
            String> EMPTY_WORDS = Set.of("sensor", "raw", "value", "signal", "channel", "data", "axis", "rate", "velocity", "measured",
                    "pad", "without", "with", "of",
                    "the", "in", "per", "and");
    /** A word of one letter says a quantity only where an axis stands beside it. */
    private static final int LETTER = 1;

    /**
     * Reads a name.
     *
     * @param given what is known of the column beside its name, which goes before
     * @param beside a unit that stands in a row of its own
     */
    static NameWords of(Label given, Optional<String> beside) {
        String rest = given.name();
        int number = 0;
        Matcher numbered = NUMBERED.matcher(rest);
        if (numbered.matches()) {
            String digits = numbered.group(2) != null ? numbered.group(2)
                    : numbered.group(3) != null ? numbered.group(3) : numbered.group(4);
            number = Integer.parseInt(digits) + (rest.contains("[") ? 1 : 0);
            rest = numbered.group(1) == null ? "" : numbered.group(1);
        }
        Optional<String> unit = given.unit().or(() -> beside.flatMap(UnitWords::of));
        Matcher brackets = BRACKETS.matcher(rest);
        if (brackets.matches() && !brackets.group(1).isBlank()) {
            Optional<String> stated = UnitWords.of(brackets.group(2));
            unit = unit.or(() -> stated);
            rest = brackets.group(1) + (stated.isPresent() ? "" : " " + brackets.group(2));
        }
        Matcher tail = TAIL.matcher(rest);
        if (unit.isEmpty() && tail.matches()) {
            String letters = tail.group(2).toLowerCase(Locale.ROOT).replace("_", "");
            unit = UnitWords.of(TAILS.getOrDefault(letters, tail.group(2).equalsIgnoreCase("m_s") ? "m/s" : letters));
            rest = tail.group(1);
        }
        return words(given, unit, rest, number);
    }

    private static NameWords words(Label given, Optional<String> unit, String rest, int number) {
        Optional<Quantity> quantity = given.quantity();
        Optional<Character> axis = given.axis();
        boolean time = false;
        boolean magnitude = false;
        boolean linear = false;
        List<String> letters = new ArrayList<>();
        List<String> places = new ArrayList<>();
        for (String word : rest.replaceAll("([a-z0-9])([A-Z])", "$1 $2").toLowerCase(Locale.ROOT).split("[^a-z0-9]+")) {
            Matcher compact = COMPACT.matcher(word);
            time |= TIMES.contains(word);
            magnitude |= MAGNITUDES.contains(word);
            linear |= LINEAR.contains(word);
            if (compact.matches()) {
                quantity = quantity.or(() -> Optional.of(QUANTITIES.get(compact.group(1))));
                axis = axis.or(() -> Optional.of(compact.group(2).charAt(0)));
                linear |= compact.group(1).equals("linacc");
            } else if (AXES.containsKey(word)) {
                axis = axis.or(() -> Optional.of(AXES.get(word)));
            } else if (word.length() == LETTER && QUANTITIES.containsKey(word)) {
                letters.add(word);
            } else if (QUANTITIES.containsKey(word)) {
                quantity = quantity.or(() -> Optional.of(QUANTITIES.get(word)));
            } else if (mayBePlace(word)) {
                places.add(word);
            }
        }
        if (quantity.isEmpty() && axis.isPresent() && !letters.isEmpty()) {
            quantity = Optional.of(QUANTITIES.get(letters.get(0)));
        }
        Optional<String> dimension = unit.flatMap(Unit::of).map(Unit::dimension);
        if (quantity.isEmpty() && !time) {
            quantity = dimension.flatMap(known -> Arrays.stream(Quantity.values()).filter(each -> each.unit().equals(known)).findFirst());
        }
        String place = given.place().map(Context::word).orElse(places.isEmpty() ? "" : Context.word(String.join("_", places)));
        Label label = new Label(given.name(), Optional.of(place).filter(Channel::isLocation), quantity, axis, unit, given.sign());
        return new NameWords(label, time, magnitude, linear, number);
    }

    private static boolean mayBePlace(String word) {
        boolean known = TIMES.contains(word) || MAGNITUDES.contains(word) || LINEAR.contains(word) || EMPTY_WORDS.contains(word);
        return !word.isEmpty() && !known && !word.matches("\\d+");
    }
}

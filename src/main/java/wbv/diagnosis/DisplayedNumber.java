package wbv.diagnosis;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import wbv.body.number.Units;

/**
 * How a number whose key names its unit, such as {@code knee_m}, is told to people.
 *
 * @param label  what it is, without its unit
 * @param factor from the key's unit to the one shown
 * @param unit   shown; empty if it has none
 */
public record DisplayedNumber(String label, double factor, String unit) {

    /** Digits before the point of the greatest number that is told in full; of the least, how many zeros behind it, negative. */
    private static final int MOST_DIGITS = 6;
    private static final int LEAST_DIGITS = -3;

    /** Endings of keys, longer before shorter that they end with. */
    private static final Map<String, DisplayedNumber> UNITS = units();

    /** Times that are fractions of a second. */
    private static final Set<String> SHORT = Set.of("delay_s", "wander_s", "cosine_s", "sine_s", "relaxation_s", "twitch_s");

    /** What a key alone would tell wrongly: a ratio of 0.86 is no spring that is softer in compression, but one 86 % stiffer. */
    private static final Map<String, DisplayedNumber> WHOLE = Map.of("compression_ratio",
            new DisplayedNumber("stiffness added in compression", 100, "%"));

    private static final Map<String,
            String> LABELS = Map.ofEntries(Map.entry("k3", "cubic stiffness"), Map.entry("k2", "quadratic stiffness"),
                    Map.entry("c2", "quadratic damping"), Map.entry("cosine", "cosine part"), Map.entry("sine", "sine part"),
                    Map.entry("towards x", "tilt towards x"), Map.entry("towards y", "tilt towards y"), Map.entry("linear", "linear drift"),
                    Map.entry("quadratic", "quadratic drift"),
                    Map.entry("cubic", "stiffening"), Map.entry("stop", "stiffness of the stop"),
                    Map.entry("column", "column of air"), Map.entry("reflex_N_per_m", "reflex to stretch"),
                    Map.entry("reflex_Ns_per_m", "reflex to its speed"), Map.entry("kept share", "share of the stiffness kept"));

    /**
     * Reads a key, such as {@code knee_m} or {@code lever_arm_m on seat.gyr.y}. One without a unit that is known is shown as it
     * is.
     */
    public static DisplayedNumber of(String key) {
        int words = key.indexOf(' ');
        if (words > 0) {
            DisplayedNumber first = of(key.substring(0, words));
            return new DisplayedNumber(first.label() + key.substring(words), first.factor(), first.unit());
        }
        if (WHOLE.containsKey(key)) {
            return WHOLE.get(key);
        }
        if (SHORT.contains(key)) {
            return new DisplayedNumber(label(key.substring(0, key.length() - 2)), 1e3, "ms");
        }
        int bracket = key.indexOf("_[");
        if (bracket > 0 && key.endsWith("]")) {
            return new DisplayedNumber(label(key.substring(0, bracket)), 1, key.substring(bracket + 2, key.length() - 1));
        }
        for (Map.Entry<String, DisplayedNumber> ending : UNITS.entrySet()) {
            if (key.endsWith(ending.getKey()) && key.length() > ending.getKey().length()) {
                DisplayedNumber unit = ending.getValue();
                int name = unit.unit().equals("%") ? key.length() : key.length() - ending.getKey().length();
                String label = LABELS.containsKey(key) ? LABELS.get(key) : label(key.substring(0, name));
                return new DisplayedNumber(label, unit.factor(), unit.unit());
            }
        }
        return new DisplayedNumber(label(key), 1, "");
    }

    /**
     * A number alone, with its unit.
     *
     * @param value in the key's unit
     */
    String text(double value) {
        return significant(factor * value, 4) + tail();
    }

    /**
     * A number with its unit and where it lies: {@code 33.6 N, 29.6 to 37.6}; no more digits than are meant. Where only one side is known,
     * that side: {@code not identifiable, at most 0.06 mm/s}; of a bound below 0, whose size says the contrary, {@code below −0.05}.
     *
     * @param value in the key's unit
     * @param interval likewise
     */
    String text(double value, Interval interval) {
        double low = factor * interval.low();
        double high = factor * interval.high();
        if (!interval.isClosed()) {
            boolean neither = Double.isInfinite(low) && Double.isInfinite(high);
            return "not identifiable"
                    + (neither ? "" : (Double.isInfinite(low) ? (high < 0 ? ", below " : ", at most ") + significant(high, 2)
                            : (low < 0 ? ", above " : ", at least ") + significant(low, 2)) + tail());
        }
        if (!(high > low)) {
            return text(value);
        }
        // Two digits of half the width, and five of the value at most: nobody needs more.
        int power = power(factor * value);
        int decimals = Math.max(2 - magnitude((high - low) / 2) + power, 0);
        if (decimals > Math.max(5 - magnitude(factor * value) + power, 0)) {
            return significant(factor * value, 5) + tail();
        }
        return plain(factor * value, power, decimals) + tail() + ", " + plain(low, power, decimals) + " to " + plain(high, power, decimals);
    }

    private String tail() {
        return unit.isEmpty() || unit.equals("°") ? unit : " " + unit;
    }

    /** Digits before the point; zero or less for numbers below 1. */
    private static int magnitude(double value) {
        return value == 0 ? 1 : (int) Math.floor(Math.log10(Math.abs(value))) + 1;
    }

    /** Power of ten by which a number is told; 0 while nobody has to count its zeros. */
    private static int power(double value) {
        int magnitude = magnitude(value);
        return magnitude > MOST_DIGITS || magnitude < LEAST_DIGITS ? magnitude - 1 : 0;
    }

    private static String significant(double value, int digits) {
        int power = power(value);
        return plain(value, power, Math.max(0, digits - magnitude(value) + power));
    }

    private static String plain(double value, int power, int decimals) {
        return BigDecimal.valueOf(value).scaleByPowerOfTen(-power).setScale(decimals, RoundingMode.HALF_EVEN).toPlainString()
                .replace('-', '−') + (value == 0 ? "" : Units.timesTen(power));
    }

    private static String label(String name) {
        String words = name.replace('_', ' ');
        return LABELS.getOrDefault(words, words);
    }

    private static Map<String, DisplayedNumber> units() {
        Map<String, DisplayedNumber> out = new LinkedHashMap<>();
        put(out, "_N_per_m1_5", 1e-6, "MN/m^1.5");
        put(out, "_Nm_per_rad1_5", 1, "N·m/rad^1.5");
        put(out, "_N_per_m3", 1, "N/m³");
        put(out, "_N_per_m2", 1, "N/m²");
        put(out, "_Ns2_per_m2", 1, "N·s²/m²");
        put(out, "_per_m2", 1e-4, "1/cm²");
        put(out, "_Ns_per_m", 1, "N·s/m");
        put(out, "_N_per_m", 1e-3, "kN/m");
        put(out, "_Nm_per_rad3", 1, "N·m/rad³");
        put(out, "_Nm_per_rad2", 1, "N·m/rad²");
        put(out, "_Nms2_per_rad2", 1, "N·m·s²/rad²");
        put(out, "_per_rad2", 1, "1/rad²");
        put(out, "_rad_per_s", 180 / Math.PI, "°/s");
        put(out, "_Nm", 1, "N·m");
        put(out, "_Nms_per_rad", 1, "N·m·s/rad");
        put(out, "_Nm_per_rad", 1, "N·m/rad");
        put(out, "_kgm2", 1, "kg·m²");
        put(out, "_m_per_s", 1e3, "mm/s");
        put(out, "_s_per_s", 1e3, "ms/s");
        put(out, "_per_100s2", 1, "1/(100 s)²");
        put(out, "_per_100s", 1, "1/(100 s)");
        put(out, "_rad", 180 / Math.PI, "°");
        put(out, "_hz", 1, "Hz");
        put(out, "_kg", 1, "kg");
        put(out, "_s", 1, "s");
        put(out, "_N", 1, "N");
        put(out, "_m", 1e3, "mm");
        put(out, "_change", 100, "%");
        return out;
    }

    private static void put(Map<String, DisplayedNumber> units, String ending, double factor, String unit) {
        units.put(ending, new DisplayedNumber("", factor, unit));
    }
}

package wbv.diagnosis;

import java.util.List;
import java.util.Locale;

/** A number with its unit as people write it: {@code stop stiffness 918 ± 110 kN/m}. The unit stands at the end of its JSON name. */
final class Measure {

    /** JSON ending, unit, and what a value is divided by to be read easily. Longer endings first. */
    private record Unit(String ending, String symbol, double size) { }

    private static final List<Unit> UNITS = List.of(
            new Unit("_N_per_m1_5", "MN/m^1.5", 1e6), new Unit("_N_per_m3", "N/mm³", 1e9), new Unit("_N_per_m2", "N/mm²", 1e6),
            new Unit("_Ns2_per_m2", "N s²/m²", 1), new Unit("_Ns_per_m", "N s/m", 1), new Unit("_N_per_m", "kN/m", 1e3),
            new Unit("_m_per_s", "mm/s", 1e-3), new Unit("_s_per_s", "ms/s", 1e-3), new Unit("_per_100s2", "/(100 s)²", 1),
            new Unit("_per_100s", "/(100 s)", 1), new Unit("_kg", "kg", 1), new Unit("_hz", "Hz", 1), new Unit("_rad", "°", Math.PI / 180),
            new Unit("_N", "N", 1), new Unit("_m", "mm", 1e-3));

    private Measure() { }

    /** @param deviation standard deviation, infinite where the recording does not tell, NaN where none is known */
    static String of(String key, double value, double deviation) {
        String name = key;
        String place = "";
        int on = key.indexOf(" on ");
        if (on > 0) {
            name = key.substring(0, on);
            place = key.substring(on);
        }
        Unit unit = unit(name);
        String words = name.substring(0, name.length() - unit.ending().length()).replace('_', ' ') + place;
        String number = digits(value / unit.size());
        String spread = Double.isInfinite(deviation) ? " (not identifiable)" : Double.isNaN(deviation) ? "" : " ± " + digits(2 * deviation / unit.size(), 2);
        return words + " " + number + spread + (unit.symbol().isEmpty() ? "" : " " + unit.symbol());
    }

    private static Unit unit(String name) {
        if (name.equals("time_s") || name.equals("relaxation_s") || name.equals("delay_s")) {
            return name.equals("time_s") ? new Unit("_s", "s", 1) : new Unit("_s", "ms", 1e-3);
        }
        return UNITS.stream().filter(unit -> name.endsWith(unit.ending())).findFirst().orElse(new Unit("", "", 1));
    }

    private static String digits(double value) {
        return digits(value, 3);
    }

    private static String digits(double value, int digits) {
        if (value == 0) {
            return "0";
        }
        int decimals = Math.max(0, digits - 1 - (int) Math.floor(Math.log10(Math.abs(value))));
        return Math.abs(value) >= 1e6 || Math.abs(value) < 1e-5 ? String.format(Locale.ROOT, "%." + (digits - 1) + "e", value)
                : String.format(Locale.ROOT, "%." + decimals + "f", value);
    }
}

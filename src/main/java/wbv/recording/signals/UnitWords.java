package wbv.recording.signals;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import wbv.recording.Unit;

/** Units as people and programs write them: {@code m/sec^2}, {@code [G]}, {@code (deg/sec)}. */
public final class UnitWords {

    private UnitWords() {}

    /** The symbol that {@link Unit} knows for what is written, if it is one. */
    public static Optional<String> of(String written) {
        String bare = written.strip().replaceAll("^[\\[({]\\s*|\\s*[\\])}]$", "").replace("**", "").replace("·", "");
        String plain = bare.replace("second", "s").replace("sec", "s").replace("degrees", "deg").replace("degree", "deg").replace(" ", "");
        String lower = plain.toLowerCase(Locale.ROOT);
        String named = switch (lower) {
            case "gn", "grav", "g_n" -> "g";
            case "newton", "newtons" -> "N";
            case "volt", "volts" -> "V";
            case "metre", "meter", "metres", "meters" -> "m";
            case "s-1", "1/s" -> "";
            case "m/s/s", "ms-2", "ms^-2", "m.s-2", "mps2" -> "m/s2";
            case "°c", "degc", "c" -> "°C";
            default -> plain;
        };
        for (String each : List.of(bare, plain, named, lower)) {
            if (Unit.of(each).isPresent()) {
                return Optional.of(each.equals("°C") ? "°C" : each);
            }
        }
        return Optional.empty();
    }
}

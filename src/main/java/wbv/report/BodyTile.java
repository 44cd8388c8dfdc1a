package wbv.report;

import java.util.ArrayList;
import java.util.List;
import wbv.identify.EquivalentBody;

/** What is known of the body on one path as tile, table cells and a remark: the words about a {@link PathBody}. */
final class BodyTile {

    private final PathBody path;
    private final List<EquivalentBody.Mode> modes;

    private BodyTile(PathBody path) {
        this.path = path;
        modes = path.stands() ? path.body().orElseThrow().modes().stream().filter(mode -> mode.oscillates() && mode.determined()).toList()
                : List.of();
    }

    static BodyTile of(PathBody path) {
        return new BodyTile(path);
    }

    /** Whether numbers are given. */
    boolean found() {
        return path.stands();
    }

    /** Why they are not; empty if they are. */
    String reason() {
        return path.doubt();
    }

    /** Modes whose numbers are given, the slower first. */
    List<EquivalentBody.Mode> modes() {
        return modes;
    }

    /** Whether the whole body is one mode. */
    boolean single() {
        return found() && path.body().orElseThrow().modes().size() == 1;
    }

    /** Share of the output's variance that the body explains, with other motions of the base where they help [1]; NaN if none is known. */
    double explained() {
        return path.body().map(body -> Math.max(0, path.others().isEmpty() ? body.explained() : body.withOthers())).orElse(Double.NaN);
    }

    String frequencies() {
        return joined(modes.stream().map(mode -> measured(mode.frequency(), 2 * mode.frequencyDeviation())).toList());
    }

    String dampings() {
        return joined(modes.stream().map(mode -> measured(mode.damping(), 2 * mode.dampingDeviation())).toList());
    }

    private static String joined(List<String> numbers) {
        return numbers.isEmpty() ? "–" : String.join("; ", numbers);
    }

    /** What it explains, or why there is no number, in a few words. */
    String remark() {
        return found() ? path.others().isEmpty() ? "" : path.explained() : path.doubt();
    }

    /** What it explains, as words; empty if there is no body. */
    String explains() {
        return path.explained();
    }

    /** @param way from where to where */
    Tiles.Tile tile(String way) {
        List<String> lines = new ArrayList<>();
        Gauge gauge = Double.isNaN(explained()) ? Gauge.NONE : new Gauge(0, 100, List.of(new Gauge.Range(0, 100 * explained(),
                found() ? "share" : "weak", path.explained())), List.of(), List.of());
        if (!found()) {
            lines.add("No natural frequency is given: " + path.doubt() + ".");
        } else {
            EquivalentBody.Mode first = modes.get(0);
            lines.add("± " + Digits.rounded(2 * first.frequencyDeviation(), decimals(2 * first.frequencyDeviation())) + " Hz; damping ratio "
                    + measured(first.damping(), 2 * first.dampingDeviation()) + ".");
            modes.stream().skip(1).forEach(mode -> lines.add("Second mode " + measured(mode.frequency(), 2 * mode.frequencyDeviation())
                    + " Hz, damping ratio " + measured(mode.damping(), 2 * mode.dampingDeviation()) + "."));
        }
        if (!path.explained().isEmpty()) {
            lines.add(capital(path.explained()) + " of the motion, " + way + ".");
        }
        return found() ? new Tiles.Tile("Body", Digits.rounded(modes.get(0).frequency(), decimals(2 * modes.get(0).frequencyDeviation())), "Hz",
                gauge, lines, Tiles.Tone.PLAIN) : new Tiles.Tile("Body", "no number", "", gauge, lines, Tiles.Tone.PLAIN);
    }

    /** With a large first letter, unless the first word is a channel's name. */
    static String capital(String words) {
        return words.isEmpty() || words.split(" ", 2)[0].contains(".") ? words : Character.toUpperCase(words.charAt(0)) + words.substring(1);
    }

    private static int decimals(double deviation) {
        return deviation > 0 ? Digits.decimals(deviation, 2) : 2;
    }

    /** A number with what it may be off, as far as two digits of that reach. */
    private static String measured(double value, double deviation) {
        int decimals = decimals(deviation);
        return Digits.rounded(value, decimals) + " ± " + Digits.rounded(deviation, decimals);
    }
}

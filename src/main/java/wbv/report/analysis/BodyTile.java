package wbv.report.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import wbv.identify.EquivalentBody;
import wbv.recording.Channel;
import wbv.report.page.Gauge;
import wbv.report.page.Tiles;
import wbv.result.Digits;
import wbv.study.PathBody;

/** What is known of the body on one path as tile, table cells and a remark: the words about a {@link PathBody}. */
final class BodyTile {

    private final PathBody path;
    private final List<EquivalentBody.Mode> modes;

    private BodyTile(PathBody path) {
        this.path = path;
        modes = path.modes();
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

    /** Share of the output's variance that the body explains by itself [1]; NaN if none is known. */
    double explained() {
        return path.body().map(body -> Math.max(0, body.explained())).orElse(Double.NaN);
    }

    String frequencies() {
        return joined(modes.stream().map(BodyTile::frequency).toList());
    }

    String dampings() {
        return joined(modes.stream().map(BodyTile::damping).toList());
    }

    private static String joined(List<String> numbers) {
        return numbers.isEmpty() ? "–" : String.join("; ", numbers);
    }

    /** Why there is no number, or what else moves the output, in a few words. */
    String remark() {
        return found() ? together() : path.doubt();
    }

    /** What the body explains together with other motions of the base; empty if none help. */
    private String together() {
        return !path.othersAdd() ? "" : percent(path.body().orElseThrow().withOthers()) + " with "
                + path.others().stream().map(Channel::toString).collect(Collectors.joining(", "));
    }

    /**
     * What it explains, as a sentence; empty if there is no body.
     *
     * @param way from where to where; may be empty
     */
    String explains(String way) {
        return path.body().isEmpty() ? "" : "Explains " + percent(explained()) + " of the motion" + way
                + (together().isEmpty() ? "" : "; " + together()) + ".";
    }

    /** @param way from where to where */
    Tiles.Tile tile(String way) {
        List<String> lines = new ArrayList<>();
        Gauge gauge = Double.isNaN(explained()) ? Gauge.NONE : new Gauge(0, 100, List.of(new Gauge.Range(0, 100 * explained(),
                found() ? "share" : "weak", percent(explained()) + " explained")), List.of(), List.of());
        if (!found()) {
            lines.add("No natural frequency is given: " + path.doubt() + ".");
        } else {
            EquivalentBody.Mode first = modes.get(0);
            lines.add(frequency(first).substring(frequency(first).indexOf('±')) + "\u00a0Hz; damping ratio " + damping(first) + ".");
            modes.stream().skip(1).forEach(mode -> lines.add("Second mode " + frequency(mode) + "\u00a0Hz, damping ratio " + damping(mode)
                    + "."));
        }
        if (path.body().isPresent()) {
            lines.add(explains(", " + way));
        }
        return found()
                ? new Tiles.Tile("Equivalent body", Digits.rounded(modes.get(0).frequency(), 2), "Hz", gauge, lines, Tiles.Tone.PLAIN)
                : new Tiles.Tile("Equivalent body", "no number", "", gauge, lines, Tiles.Tone.PLAIN);
    }

    private static String frequency(EquivalentBody.Mode mode) {
        return PathBody.within(mode.frequency(), 2 * mode.frequencyDeviation(), 2);
    }

    private static String damping(EquivalentBody.Mode mode) {
        return PathBody.within(mode.damping(), 2 * mode.dampingDeviation(), 3);
    }

    /** Never rounded up to all. */
    static String percent(double share) {
        return PathBody.percent(share).replace(' ', '\u00a0');
    }

    /** With a large first letter, unless the first word is a channel's name. */
    static String capital(String words) {
        return words.isEmpty() || words.split(" ", 2)[0].contains(".") ? words
                : Character.toUpperCase(words.charAt(0)) + words.substring(1);
    }
}

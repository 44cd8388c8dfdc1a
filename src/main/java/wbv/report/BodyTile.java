package wbv.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import wbv.recording.Summary;

/**
 * What is known of the body on one path, as page and terminal say it: the one seam between the estimate and the words about it.
 *
 * @param modes     one, or two, the slower first; none if no number is given
 * @param explained share of the output's variance that the body explains, 0 to 1; NaN if that is not known
 * @param reason    why there is no number, or what weakens it; empty if nothing
 */
record BodyTile(List<Mode> modes, double explained, String reason) {

    /** Share of the output's motion below which a body says nothing of it: chance is as good. */
    private static final double LEAST_EXPLAINED = 0.5;

    /**
     * A mode.
     *
     * @param frequency natural frequency [Hz] @param frequencyDeviation twice its standard deviation
     * @param damping   damping ratio @param dampingDeviation twice its standard deviation
     */
    record Mode(double frequency, double frequencyDeviation, double damping, double dampingDeviation) {

        /** The mode in words, two digits of every deviation. */
        String words() {
            return "natural frequency " + frequencyWords() + " Hz, damping ratio " + dampingWords();
        }

        String frequencyWords() {
            return measured(frequency, frequencyDeviation);
        }

        String dampingWords() {
            return measured(damping, dampingDeviation);
        }
    }

    BodyTile {
        modes = List.copyOf(modes);
    }

    /** What a followed output tells. @param output what was seen of it as a signal */
    static BodyTile of(Response response, Summary output) {
        double noise = response.estimator().track().outputNoise() / output.rms();
        double explained = Double.isFinite(noise) ? Math.max(0, 1 - noise * noise) : Double.NaN;
        if (response.known().isEmpty()) {
            return new BodyTile(List.of(), Double.NaN, response.lost());
        }
        Response.Estimate body = response.known().get();
        if (explained < LEAST_EXPLAINED) {
            return new BodyTile(List.of(), explained, "one mode explains " + Digits.significant(100 * explained, 2)
                    + " % of its motion only");
        }
        if (body.damping() >= 1) {
            return new BodyTile(List.of(), explained, "it does not swing: damping ratio "
                    + Digits.significant(body.damping(), 3));
        }
        return new BodyTile(List.of(new Mode(body.frequency(), 2 * body.frequencyDeviation(), body.damping(),
                2 * body.dampingDeviation())), explained, response.lost());
    }

    boolean found() {
        return !modes.isEmpty();
    }

    /** One line for the terminal. */
    String line() {
        return found() ? modes.stream().map(Mode::words).collect(Collectors.joining("; ")) + share() + weakened()
                : "no natural frequency: " + reason;
    }

    private String share() {
        return Double.isNaN(explained) ? "" : String.format(Locale.ROOT, ", explains %.0f %%", 100 * explained);
    }

    private String weakened() {
        return reason.isEmpty() ? "" : " (" + reason + ")";
    }

    /** @param path from where to where */
    Tiles.Tile tile(String path) {
        List<String> lines = new ArrayList<>();
        Gauge gauge = Gauge.NONE;
        if (!Double.isNaN(explained)) {
            lines.add(String.format(Locale.ROOT, "Explains %.0f %% of the motion, %s.", 100 * explained, path));
            gauge = new Gauge(0, 100, List.of(new Gauge.Range(0, 100 * explained, found() ? "share" : "weak",
                    String.format(Locale.ROOT, "%.0f %% explained", 100 * explained))), List.of(), List.of());
        }
        if (!found()) {
            lines.add(0, "No number is given: " + reason + ".");
            return new Tiles.Tile("Body", "not found", "", gauge, lines, Tiles.Tone.WARNING);
        }
        Mode first = modes.get(0);
        int decimals = decimals(first.frequencyDeviation());
        lines.add(0, "± " + Digits.rounded(first.frequencyDeviation(), decimals) + " Hz; damping ratio "
                + measured(first.damping(), first.dampingDeviation()) + ".");
        modes.stream().skip(1).forEach(mode -> lines.add(1, "Second mode: " + mode.words() + "."));
        if (!reason.isEmpty()) {
            lines.add(capital(reason) + ".");
        }
        return new Tiles.Tile("Body", Digits.rounded(first.frequency(), decimals), "Hz", gauge, lines, Tiles.Tone.PLAIN);
    }

    /** With a large first letter, unless the first word is a channel's name. */
    static String capital(String words) {
        return words.isEmpty() || words.split(" ", 2)[0].contains(".") ? words : Character.toUpperCase(words.charAt(0)) + words.substring(1);
    }

    private static int decimals(double deviation) {
        return deviation > 0 ? Digits.decimals(deviation, 2) : 2;
    }

    private static String measured(double value, double deviation) {
        int decimals = decimals(deviation);
        return Digits.rounded(value, decimals) + " ± " + Digits.rounded(deviation, decimals);
    }
}

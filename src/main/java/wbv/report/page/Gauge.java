package wbv.report.page;

import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import wbv.result.Digits;

/**
 * A small scale with values on it, drawn without a script.
 *
 * @param from   lower end, in the unit of what it shows
 * @param to upper end, in the unit of what it shows
 * @param ranges what lies behind, such as a published range; drawn in their order
 * @param marks  values to compare with, each under its label
 * @param points the values themselves
 */
public record Gauge(double from, double to, List<Range> ranges, List<Mark> marks, List<Point> points) {

    /** No scale. */
    public static final Gauge NONE = new Gauge(0, 1, List.of(), List.of(), List.of());

    private static final double WIDTH = 200;
    private static final double LINE = 15;
    private static final double LETTER = 5.6;

    /**
     * A part of the scale.
     *
     * @param from in the scale's unit
     * @param to likewise
     * @param kind names its colour: a class of the page's style sheet
     * @param words for who cannot see it
     */
    public record Range(double from, double to, String kind, String words) {}

    /**
     * A line across the scale.
     *
     * @param at in the scale's unit
     * @param label may be empty
     */
    public record Mark(double at, String label) {}

    /**
     * A value with where it may lie.
     *
     * @param at in the scale's unit
     * @param low
     * @param high in that unit; at itself where that is not known
     */
    public record Point(double at, double low, double high) {}

    public Gauge {
        if (!(from < to)) {
            throw new IllegalArgumentException("a scale must rise: " + from + " to " + to);
        }
        ranges = List.copyOf(ranges);
        marks = List.copyOf(marks);
        points = List.copyOf(points);
    }

    /** Whether there is nothing on it, so that nothing is drawn. */
    public boolean empty() {
        return ranges.isEmpty() && marks.isEmpty() && points.isEmpty();
    }

    private double x(double value) {
        return WIDTH * (Math.max(from, Math.min(to, value)) - from) / (to - from);
    }

    /** @param escape makes text safe in markup */
    String svg(UnaryOperator<String> escape) {
        StringBuilder svg = new StringBuilder(String.format(Locale.ROOT, "<svg class=\"gauge\" viewBox=\"-4 0 208 %d\" role=\"img\""
                + " aria-label=\"%s\">\n", marks.isEmpty() ? 24 : 34, escape.apply(words())));
        svg.append("<rect class=\"scale\" x=\"0\" y=\"10\" width=\"200\" height=\"10\" rx=\"2\"/>\n");
        for (Range range : ranges) {
            svg.append(String.format(Locale.ROOT, "<rect class=\"%s\" x=\"%.1f\" y=\"10\" width=\"%.1f\" height=\"10\"><title>%s"
                    + "</title></rect>\n", range.kind(), x(range.from()), Math.max(0.4, x(range.to()) - x(range.from())),
                    escape.apply(range.words())));
        }
        double edge = -4;
        for (Mark mark : marks) {
            double half = LETTER * mark.label().length() / 2;
            double at = Math.max(edge + half, Math.min(WIDTH + 4 - half, x(mark.at())));
            svg.append(String.format(Locale.ROOT, "<path class=\"mark\" d=\"M%.1f 7V22\"/>\n", x(mark.at())));
            if (!mark.label().isEmpty()) {
                svg.append(String.format(Locale.ROOT, "<text x=\"%.1f\" y=\"33\">%s</text>\n", at, escape.apply(mark.label())));
                edge = at + half + LETTER;
            }
        }
        for (Point point : points) {
            if (point.high() > point.low()) {
                svg.append(String.format(Locale.ROOT, "<path class=\"whisker\" d=\"M%.1f %3$.0fH%2$.1f\"/>\n", x(point.low()),
                        x(point.high()), LINE));
            }
            svg.append(String.format(Locale.ROOT, "<circle class=\"point\" cx=\"%.1f\" cy=\"%.0f\" r=\"5\"/>\n", x(point.at()), LINE));
        }
        return svg.append("</svg>\n").toString();
    }

    private String words() {
        StringBuilder words = new StringBuilder();
        points.forEach(point -> words.append("at ").append(Digits.significant(point.at(), 3)).append("; "));
        ranges.stream().filter(range -> !range.words().isEmpty()).forEach(range -> words.append(range.words()).append("; "));
        marks.forEach(mark -> words.append(mark.label()).append(" at ").append(Digits.significant(mark.at(), 3)).append("; "));
        return "Scale from " + Digits.significant(from, 3) + " to " + Digits.significant(to, 3)
                + (words.length() == 0 ? "" : ": " + words.substring(0, words.length() - 2));
    }
}

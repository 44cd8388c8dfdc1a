package wbv.report.page;

import java.util.List;

/**
 * One quantity over another that need not rise: clouds of points, loops, curves and areas, such as a force over a deflection,
 * poles in the plane, or a frequency observed over a probability said.
 *
 * @param series drawn in order within a style: areas first, then clouds, curves, and points on top
 */
public record XyChart(String title, ChartAxis x, ChartAxis y, List<XySeries> series, String group, String note) implements Chart {

    public XyChart {
        series = List.copyOf(series);
    }

    public XyChart(String title, ChartAxis x, ChartAxis y, List<XySeries> series) {
        this(title, x, y, series, "", "");
    }

    /** The same chart in a group that shares x. */
    public XyChart grouped(String name) {
        return new XyChart(title, x, y, series, name, note);
    }

    /** The same chart with a note. */
    public XyChart noted(String words) {
        return new XyChart(title, x, y, series, group, words);
    }
}

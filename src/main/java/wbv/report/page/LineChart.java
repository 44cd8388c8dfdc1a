package wbv.report.page;

import java.util.ArrayList;
import java.util.List;

/**
 * Curves over a common x.
 *
 * @param markers moments or frequencies to point out
 * @param shades  ranges of x that are to be read with care
 */
public record LineChart(String title, ChartAxis x, ChartAxis y, List<Series> series, List<Marker> markers, List<Shade> shades,
        String group, String note) implements Chart {

    /**
     * A vertical line.
     *
     * @param x in the unit of the x axis
     * @param label may be empty
     */
    public record Marker(double x, String label) {}

    /**
     * A shaded range.
     *
     * @param from in the unit of the x axis
     * @param to likewise
     * @param reason why, such as {@code not excited}
     * @param pattern how it is hatched, 0 to 2
     */
    public record Shade(double from, double to, String reason, int pattern) {

        /**
         * Hatched in the first way.
         *
         * @param from in the unit of the x axis
         * @param to likewise
         */
        public Shade(double from, double to, String reason) {
            this(from, to, reason, 0);
        }
    }

    public LineChart {
        series = List.copyOf(series);
        markers = List.copyOf(markers);
        shades = List.copyOf(shades);
    }

    /** Curves and nothing else, in no group. */
    public LineChart(String title, ChartAxis x, ChartAxis y, List<Series> series) {
        this(title, x, y, series, List.of(), List.of(), "", "");
    }

    /** The same chart with markers. */
    public LineChart marked(List<Marker> others) {
        return new LineChart(title, x, y, series, others, shades, group, note);
    }

    /** The same chart with shaded ranges. */
    public LineChart shaded(List<Shade> others) {
        return new LineChart(title, x, y, series, markers, others, group, note);
    }

    /**
     * The same chart shaded wherever {@code usable} is false, from halfway to the next usable x.
     *
     * @param at the x of each, as many, in its unit. Neither array is modified.
     */
    public LineChart shadedUnless(boolean[] usable, double[] at, String reason) {
        List<Shade> found = new ArrayList<>();
        for (int i = 0; i < usable.length; i++) {
            if (!usable[i]) {
                int from = i;
                while (i + 1 < usable.length && !usable[i + 1]) {
                    i++;
                }
                found.add(new Shade(from == 0 ? at[0] : (at[from - 1] + at[from]) / 2,
                        i + 1 == usable.length ? at[i] : (at[i] + at[i + 1]) / 2, reason));
            }
        }
        return shaded(found);
    }

    /** The same chart in a group that shares x. */
    public LineChart grouped(String name) {
        return new LineChart(title, x, y, series, markers, shades, name, note);
    }

    /** The same chart with a note. */
    public LineChart noted(String words) {
        return new LineChart(title, x, y, series, markers, shades, group, words);
    }
}

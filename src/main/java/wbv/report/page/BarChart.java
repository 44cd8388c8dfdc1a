package wbv.report.page;

import java.util.List;

/**
 * Values side by side: a group of bars for each of several things.
 *
 * @param axis    of the values; its low end is where the bars stand
 * @param groups  names of the things, one at least
 * @param bars    one for each group, in the order in which they stand
 * @param markers values to point out, such as limits
 */
public record BarChart(String title, ChartAxis axis, List<String> groups, List<Bars> bars, List<LineChart.Marker> markers, String note)
        implements Chart {

    /** Without markers. */
    public BarChart(String title, ChartAxis axis, List<String> groups, List<Bars> bars, String note) {
        this(title, axis, groups, bars, List.of(), note);
    }

    /**
     * Bars of one colour.
     *
     * @param values by group, in the axis' unit, NaN leaves one out. Not copied
     * @param low    ends of the whiskers by group, in the axis' unit, NaN leaves one out; empty where there are none. Not copied
     *               @param high likewise
     * @param colour place in the page's palette, 0 to 7
     */
    public record Bars(String name, double[] values, double[] low, double[] high, int colour) {

        /**
         * Without whiskers.
         *
         * @param values by group, in the axis' unit. Not copied, not modified
         */
        public Bars(String name, double[] values, int colour) {
            this(name, values, new double[0], new double[0], colour);
        }
    }

    public BarChart {
        groups = List.copyOf(groups);
        bars = List.copyOf(bars);
        markers = List.copyOf(markers);
        if (groups.isEmpty()) {
            throw new IllegalArgumentException("a bar chart needs at least one group");
        }
        for (Bars each : bars) {
            if (each.values().length != groups.size()) {
                throw new IllegalArgumentException(each.name() + " needs " + groups.size() + " values: " + each.values().length);
            }
            if (each.low().length != each.high().length || each.low().length != 0 && each.low().length != groups.size()) {
                throw new IllegalArgumentException(each.name() + " needs " + groups.size() + " whiskers or none: "
                        + each.low().length
                        + " low and " + each.high().length + " high ends");
            }
        }
    }

    /** The axis of the values: bars lie, so that names of any length have room. */
    @Override
    public ChartAxis x() {
        return axis;
    }

    @Override
    public ChartAxis y() {
        return ChartAxis.linear("", "");
    }

    @Override
    public String group() {
        return "";
    }
}

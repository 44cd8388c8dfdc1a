package wbv.report.page;

import java.util.List;

/**
 * An axis of a chart.
 *
 * @param label what is drawn along it
 * @param unit  of its numbers; empty if they have none
 * @param scale linear or logarithmic
 * @param low   lower end, in its unit, NaN to take it from the data
 * @param high  upper end, in its unit, NaN to take it from the data
 * @param names what to write at 1, 2 and so on in place of numbers; empty for numbers
 */
public record ChartAxis(String label, String unit, Scale scale, double low, double high, List<String> names) {

    /** How numbers become lengths. */
    public enum Scale { LINEAR, LOG }

    public ChartAxis {
        names = List.copyOf(names);
        if (low >= high || Double.isInfinite(low) || Double.isInfinite(high)) {
            throw new IllegalArgumentException("ends of an axis must rise and be finite: " + low + " to " + high);
        }
        if (scale == Scale.LOG && low <= 0) {
            throw new IllegalArgumentException("a logarithmic axis must begin above 0: " + low);
        }
    }

    /** Both ends are taken from the data. */
    public static ChartAxis linear(String label, String unit) {
        return new ChartAxis(label, unit, Scale.LINEAR, Double.NaN, Double.NaN, List.of());
    }

    /** Values at or below zero are not drawn. */
    public static ChartAxis log(String label, String unit) {
        return new ChartAxis(label, unit, Scale.LOG, Double.NaN, Double.NaN, List.of());
    }

    /**
     * The same axis with fixed ends; NaN leaves one to the data.
     *
     * @param from in the axis' unit
     * @param to likewise
     */
    public ChartAxis within(double from, double to) {
        return new ChartAxis(label, unit, scale, from, to, names);
    }

    /** Rows with names, the first at 1, with half a row of room at both ends. */
    public static ChartAxis named(List<String> names) {
        return new ChartAxis("", "", Scale.LINEAR, 0.5, names.size() + 0.5, names);
    }
}

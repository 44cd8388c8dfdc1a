package wbv.report;

/**
 * An axis of a chart.
 *
 * @param label what is drawn along it
 * @param unit  of its numbers; empty if they have none
 * @param scale linear or logarithmic
 * @param low   lower end, NaN to take it from the data
 * @param high  upper end, NaN to take it from the data
 */
public record Axis(String label, String unit, Scale scale, double low, double high) {

    /** How numbers become lengths. */
    public enum Scale { LINEAR, LOG }

    public Axis {
        if (low >= high || Double.isInfinite(low) || Double.isInfinite(high)) {
            throw new IllegalArgumentException("ends of an axis must rise and be finite: " + low + " to " + high);
        }
        if (scale == Scale.LOG && low <= 0) {
            throw new IllegalArgumentException("a logarithmic axis must begin above 0: " + low);
        }
    }

    public static Axis linear(String label, String unit) {
        return new Axis(label, unit, Scale.LINEAR, Double.NaN, Double.NaN);
    }

    /** Values at or below zero are not drawn. */
    public static Axis log(String label, String unit) {
        return new Axis(label, unit, Scale.LOG, Double.NaN, Double.NaN);
    }

    /** The same axis with fixed ends; NaN leaves one to the data. */
    public Axis within(double from, double to) {
        return new Axis(label, unit, scale, from, to);
    }
}

package wbv.report.page;

import java.util.Arrays;

/**
 * A value over two axes in colour, such as a spectrogram. Arrays are not copied.
 *
 * @param columns centres of the columns by column, in the unit of x, rising evenly, at least one
 * @param rows    centres of the rows by row, in the unit of y, rising evenly, at least two
 * @param values  by column, then by row, in the unit of the colour; NaN is a hole
 * @param colour  what the colour says; ends left open are set to leave out the faintest and the few strongest values
 */
public record Heatmap(String title, ChartAxis x, ChartAxis y, ChartAxis colour, double[] columns, double[] rows, double[][] values,
        String group, String note) implements Chart {

    public Heatmap {
        if (columns.length < 1 || rows.length < 2 || values.length != columns.length) {
            throw new IllegalArgumentException("a heat map needs values for at least 1 column and 2 rows: " + values.length
                    + " of " + columns.length + " columns, " + rows.length + " rows");
        }
        for (double[] column : values) {
            if (column.length != rows.length) {
                throw new IllegalArgumentException("a column needs " + rows.length + " values: " + column.length);
            }
        }
        colour = colour.within(Double.isNaN(colour.low()) ? automatic(values)[0] : colour.low(),
                Double.isNaN(colour.high()) ? automatic(values)[1] : colour.high());
    }

    /**
     * In no group, without a note. Arrays are not copied, not modified.
     *
     * @param columns by column, in the unit of x
     * @param rows by row, in the unit of y
     * @param values by column and row, in the unit of the colour
     */
    public Heatmap(String title, ChartAxis x, ChartAxis y, ChartAxis colour, double[] columns, double[] rows, double[][] values) {
        this(title, x, y, colour, columns, rows, values, "", "");
    }

    /** The same chart in a group that shares x. */
    public Heatmap grouped(String name) {
        return new Heatmap(title, x, y, colour, columns, rows, values, name, note);
    }

    /** The same chart with a note. */
    public Heatmap noted(String words) {
        return new Heatmap(title, x, y, colour, columns, rows, values, group, words);
    }

    /** From the 10th percentile to the 99.9th of the finite values. */
    private static double[] automatic(double[][] values) {
        double[] sorted = Arrays.stream(values).flatMapToDouble(Arrays::stream).filter(Double::isFinite).sorted().toArray();
        if (sorted.length == 0) {
            return new double[] {0, 1};
        }
        double low = sorted[(int) (0.1 * (sorted.length - 1))];
        double high = sorted[(int) (0.999 * (sorted.length - 1))];
        return new double[] {low, high > low ? high : low + 1};
    }
}

package wbv.proof;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;

/** Numbers as cells of a Markdown table. */
final class MarkdownCells {

    private MarkdownCells() {}

    static String row(String... cells) {
        return "| " + String.join(" | ", cells) + " |\n";
    }

    /** A heading, the names of the columns, and the line below them. */
    static String head(String heading, String... columns) {
        return "## " + heading + "\n\n" + row(columns) + "|" + "---|".repeat(columns.length) + "\n";
    }

    /** Three significant digits. */
    static String number(double x) {
        return String.format(Locale.ROOT, Math.abs(x) >= 1000 ? "%.0f" : "%.3g", x);
    }

    /** To four significant digits. */
    static double rounded(double x) {
        return x == 0 || !Double.isFinite(x) ? x : new BigDecimal(x).round(new MathContext(4)).doubleValue();
    }

    /** The shortest of two decimals. */
    static String plain(double x) {
        return new BigDecimal(String.format(Locale.ROOT, "%.2f", x)).stripTrailingZeros().toPlainString();
    }

    /**
     * A time for a person.
     *
     * @param seconds of it
     */
    static String time(double seconds) {
        return seconds < 100 ? Math.round(seconds) + " s" : seconds < 6000 ? Math.round(seconds / 60) + " min"
                : String.format(Locale.ROOT, "%.1f h", seconds / 3600);
    }

    /** How many pass, and what part that is; empty of none. */
    static <T> String rate(List<T> of, Predicate<T> test) {
        long good = of.stream().filter(test).count();
        return of.isEmpty() ? "" : String.format(Locale.ROOT, "%d (%.0f %%)", good, 100.0 * good / of.size());
    }

    /** The median of what is finite; empty of nothing. */
    static String median(List<Marking> of, ToDoubleFunction<Marking> value) {
        double[] x = of.stream().mapToDouble(value).filter(Double::isFinite).toArray();
        return x.length == 0 ? "" : number(quantile(x, 0.5));
    }

    /** The value below which a share of them lies; NaN of nothing. */
    static double quantile(double[] x, double share) {
        double[] sorted = x.clone();
        Arrays.sort(sorted);
        return sorted.length == 0 ? Double.NaN : sorted[(int) Math.min(sorted.length - 1, share * sorted.length)];
    }
}

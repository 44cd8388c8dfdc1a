package wbv.report.page;

import java.util.List;
import wbv.result.Digits;

/** The numbers that matter most, in a row. */
public record Figures(List<Figure> figures) implements Block {

    public Figures {
        figures = List.copyOf(figures);
    }

    /** Numbers from left to right. */
    public Figures(Figure... figures) {
        this(List.of(figures));
    }

    /**
     * One number.
     *
     * @param label       what it is
     * @param value       ready to be shown
     * @param unit        may be empty
     * @param uncertainty such as {@code ± 0.04}; may be empty
     */
    public record Figure(String label, String value, String unit, String uncertainty) {

        /**
         * A number without uncertainty, shown with four significant digits.
         *
         * @param value in the unit that is named
         */
        public static Figure of(String label, double value, String unit) {
            return new Figure(label, Digits.significant(value, 4), unit, "");
        }

        /**
         * A number with its standard deviation: two digits of ±2σ are shown, and the value as far as they reach.
         *
         * @param value in the unit that is named
         * @param deviation standard deviation σ in that unit, &gt;= 0, or NaN if not known
         */
        public static Figure measured(String label, double value, double deviation, String unit) {
            if (!(2 * deviation > 0) || Double.isInfinite(deviation)) {
                return of(label, value, unit);
            }
            int decimals = Digits.decimals(2 * deviation, 2);
            return new Figure(label, Digits.rounded(value, decimals), unit, "± " + Digits.rounded(2 * deviation, decimals));
        }
    }
}

package wbv.result;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Numbers as text for people: a true minus sign, no more digits than are meant, a dash where there is no number. */
public final class Digits {

    private static final String SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";

    private Digits() {}

    /**
     * At most so many significant digits of a number of any unit, without zeros at the end; with a power of ten below 0.0001 and from 10
     * million on.
     */
    public static String significant(double value, int digits) {
        if (!Double.isFinite(value)) {
            return "–";
        }
        if (value == 0) {
            return "0";
        }
        BigDecimal rounded = BigDecimal.valueOf(value).round(new MathContext(digits, RoundingMode.HALF_EVEN))
                .stripTrailingZeros();
        int exponent = rounded.precision() - rounded.scale() - 1;
        if (exponent < -4 || exponent > 6) {
            return signed(rounded.movePointLeft(exponent).toPlainString()) + " · 10" + superscript(exponent);
        }
        return signed(rounded.scale() < 0 ? rounded.setScale(0).toPlainString() : rounded.toPlainString());
    }

    /** A whole number in small raised digits. */
    private static String superscript(int number) {
        StringBuilder raised = new StringBuilder();
        for (char digit : Integer.toString(number).toCharArray()) {
            raised.append(digit == '-' ? '⁻' : SUPERSCRIPT.charAt(digit - '0'));
        }
        return raised.toString();
    }

    /** So many decimals of a number of any unit; negative ones round to tens, hundreds, …. */
    public static String rounded(double value, int decimals) {
        if (!Double.isFinite(value)) {
            return "–";
        }
        BigDecimal rounded = BigDecimal.valueOf(value).setScale(decimals, RoundingMode.HALF_EVEN);
        return signed(decimals < 0 ? rounded.setScale(0).toPlainString() : rounded.toPlainString());
    }

    /** So many decimals of a number of any unit, away from zero, so that what is not nothing does not look like it. */
    public static String roundedUp(double value, int decimals) {
        return Double.isFinite(value)
                ? signed(BigDecimal.valueOf(value).setScale(decimals, RoundingMode.UP).toPlainString()) : "–";
    }

    /** Decimals that show so many significant digits of a positive number of any unit. */
    public static int decimals(double value, int digits) {
        BigDecimal rounded = BigDecimal.valueOf(value).round(new MathContext(digits, RoundingMode.HALF_EVEN));
        return digits - (rounded.precision() - rounded.scale());
    }

    private static String signed(String number) {
        return number.startsWith("-") ? '−' + number.substring(1) : number;
    }
}

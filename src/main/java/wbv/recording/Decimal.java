package wbv.recording;

import java.nio.charset.StandardCharsets;

/**
 * Decimal numbers from bytes to the nearest double, exactly as {@link Double#parseDouble} rounds.
 *
 * <p>A number whose digits fit in 53 bits and whose power of ten is at most 22 takes one exact multiplication or division
 * (Clinger, How to read floating point numbers accurately, 1990); up to 18 digits and moderate powers take {@link PowersOfTen};
 * the rest goes to the JDK.
 */
public final class Decimal {

    private static final double[] TEN = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
        1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    private static final long EXACT = 1L << 53;
    private static final int MOST_DIGITS = 18;
    private static final int EXPONENT_LIMIT = 100_000;

    private Decimal() {}

    /**
     * The number that the bytes {@code from} to {@code to} (exclusive) spell, in whatever unit. They are not modified.
     *
     * @param point the decimal mark besides {@code .}, such as a comma; {@code '.'} for none
     * @throws NumberFormatException if they spell none, or one beyond the range of a double
     */
    public static double parse(byte[] text, int from, int to, char point) {
        int i = from;
        boolean negative = i < to && text[i] == '-';
        if (negative || i < to && text[i] == '+') {
            i++;
        }
        long mantissa = 0;
        int digits = 0;
        int scale = 0;
        int seen = 0;
        boolean fraction = false;
        boolean exact = true;
        for (; i < to; i++) {
            int c = text[i];
            int digit = c - '0';
            if (digit >= 0 && digit <= 9) {
                seen++;
                if (digits < MOST_DIGITS) {
                    mantissa = mantissa * 10 + digit;
                    digits += mantissa != 0 ? 1 : 0;
                    scale -= fraction ? 1 : 0;
                } else {
                    exact = false;
                }
            } else if ((c == '.' || c == point) && !fraction) {
                fraction = true;
            } else {
                break;
            }
        }
        if (seen == 0) {
            return word(text, from, to);
        }
        if (i < to) {
            scale += exponent(text, i, to);
        }
        if (exact && mantissa <= EXACT && scale >= -22 && scale <= 22) {
            double value = scale < 0 ? mantissa / TEN[-scale] : mantissa * TEN[scale];
            return negative ? -value : value;
        }
        double value = exact && mantissa != 0 ? PowersOfTen.times(mantissa, scale) : Double.NaN;
        if (!Double.isNaN(value)) {
            return negative ? -value : value;
        }
        return slowly(text, from, to, point);
    }

    private static int exponent(byte[] text, int from, int to) {
        int i = from;
        if (text[i] != 'e' && text[i] != 'E') {
            throw new NumberFormatException();
        }
        i++;
        boolean negative = i < to && text[i] == '-';
        if (negative || i < to && text[i] == '+') {
            i++;
        }
        if (i == to) {
            throw new NumberFormatException();
        }
        int value = 0;
        for (; i < to; i++) {
            int digit = text[i] - '0';
            if (digit < 0 || digit > 9) {
                throw new NumberFormatException();
            }
            value = Math.min(value * 10 + digit, EXPONENT_LIMIT);
        }
        return negative ? -value : value;
    }

    private static double slowly(byte[] text, int from, int to, char point) {
        double value = Double.parseDouble(new String(text, from, to - from, StandardCharsets.US_ASCII).replace(point, '.'));
        if (Double.isInfinite(value)) {
            throw new NumberFormatException();
        }
        return value;
    }

    private static double word(byte[] text, int from, int to) {
        if (to - from == 3 && (text[from] | 32) == 'n' && (text[from + 1] | 32) == 'a' && (text[from + 2] | 32) == 'n') {
            return Double.NaN;
        }
        throw new NumberFormatException();
    }
}

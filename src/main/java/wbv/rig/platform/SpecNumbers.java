package wbv.rig.platform;

import java.math.BigDecimal;

/** Numbers as a rig's spec writes and reads them: shortest plain decimals, {@code 120} and {@code 0.35}. */
public final class SpecNumbers {

    private SpecNumbers() {}

    /** The shortest decimal that reads back as the same double, without exponent or trailing zeros. */
    public static String plain(double value) {
        return value == 0 ? "0" : new BigDecimal(Double.toString(value)).stripTrailingZeros().toPlainString();
    }

    /**
     * A number as it stands in a spec, in the unit of the quantity.
     *
     * @param what the quantity, for the message
     * @throws IllegalArgumentException if the word is not a finite number
     */
    public static double parse(String what, String word) {
        try {
            double value = Double.parseDouble(word);
            if (Double.isInfinite(value) || Double.isNaN(value)) {
                throw new IllegalArgumentException(what + " must be finite: '" + word + "'");
            }
            return value;
        } catch (NumberFormatException notANumber) {
            throw new IllegalArgumentException(what + " must be a number: '" + word + "'", notANumber);
        }
    }

    /** A whole number within bounds. */
    public static int parseIndex(String what, String word, int first, int last) {
        double value = parse(what, word);
        if (!(value >= first && value <= last && value == Math.rint(value))) {
            throw new IllegalArgumentException(what + " must be " + first + " to " + last + ": '" + word + "'");
        }
        return (int) value;
    }
}

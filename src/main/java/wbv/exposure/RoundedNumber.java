package wbv.exposure;

import java.math.BigDecimal;
import java.math.MathContext;

/** Numbers in sentences: so many significant digits, no zeros at the end. */
final class RoundedNumber {

    private RoundedNumber() {}

    static String text(double value, int digits) {
        return Double.isFinite(value)
                ? BigDecimal.valueOf(value).round(new MathContext(digits)).stripTrailingZeros().toPlainString() : "?";
    }
}

package wbv.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Held to {@link Double#parseDouble}, bit by bit. */
class DecimalTest {

    private static double parse(String text) {
        byte[] bytes = (";" + text + ";").getBytes(StandardCharsets.UTF_8);
        return Decimal.parse(bytes, 1, bytes.length - 1, '.');
    }

    private static void same(String text) {
        assertEquals(Double.doubleToRawLongBits(Double.parseDouble(text)), Double.doubleToRawLongBits(parse(text)), text);
    }

    @Test
    void everyDoubleReadsAsTheJdkReadsIt() {
        Random random = new Random(1);
        for (int i = 0; i < 200_000; i++) {
            double value = Double.longBitsToDouble(random.nextLong());
            if (Double.isFinite(value)) {
                same(Double.toString(value));
                same(String.valueOf((float) random.nextGaussian()));
                same(Double.toString(random.nextGaussian()));
            }
        }
    }

    @Test
    void everyWayOfWritingADecimalReadsAsTheJdkReadsIt() {
        Random random = new Random(2);
        String[] formats = {"%.3f", "%.6f", "%.17e", "%.20f", "%+.9e", "%.0f", "%.25e"};
        for (int i = 0; i < 40_000; i++) {
            double value = random.nextGaussian() * Math.pow(10, random.nextInt(60) - 30);
            same(String.format(Locale.ROOT, formats[i % formats.length], value));
        }
    }

    @Test
    void numbersHalfwayBetweenTwoDoublesReadAsTheJdkReadsThem() {
        Random random = new Random(3);
        for (int i = 0; i < 200_000; i++) {
            double value = Math.scalb(1 + random.nextDouble(), random.nextInt(110) - 40);
            BigDecimal halfway = new BigDecimal(value).add(new BigDecimal(Math.ulp(value)).divide(BigDecimal.valueOf(2)));
            same(halfway.round(new MathContext(18)).toString());
            same(halfway.round(new MathContext(17, RoundingMode.DOWN)).toString());
            same(random.nextLong(1_000_000_000_000_000_000L) + "e" + (random.nextInt(140) - 70));
            same(random.nextLong(1L << 55) + "." + random.nextInt(100));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "-0", "+0.0", "-0.0e5", "4.9E-324", "2.2250738585072014E-308", "2.2250738585072011e-308",
        "1.7976931348623157E308", "9007199254740993", "9007199254740992", "0.1", ".5", "5.", "1e22", "1e23", "123456789012345678",
        "1234567890123456789012345678901234567890", "0.000000000000000000000000000000000000000000000000000123", "1e-400", "0e999",
        "8.5E22", "3.141592653589793238462643383279502884197", "00000000000000000000000000012.5"})
    void borderCasesReadAsTheJdkReadsThem(String text) {
        same(text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-", "+", ".", "e5", "1e", "1e+", "1.2.3", "0x1p3", "1d", "12f", "Infinity", "inf", "1e999", "1 2", "--1",
        "1e5.5", "abc", "١"})
    void whatIsNoFiniteNumberIsRefused(String text) {
        assertThrows(NumberFormatException.class, () -> parse(text));
    }

    @Test
    void nanInAnyCaseIsNaN() {
        assertTrue(Double.isNaN(parse("NaN")) && Double.isNaN(parse("nan")) && Double.isNaN(parse("NAN")));
    }

    @Test
    void aDecimalCommaIsReadWhereItIsTheMark() {
        byte[] bytes = "-12,5e1".getBytes(StandardCharsets.US_ASCII);
        assertEquals(-125.0, Decimal.parse(bytes, 0, bytes.length, ','));
        byte[] many = "-0,12345678901234567890".getBytes(StandardCharsets.US_ASCII);
        assertEquals(-0.12345678901234567890, Decimal.parse(many, 0, many.length, ','));
    }
}

package wbv.recording;

import java.math.BigInteger;

/**
 * Whole numbers times powers of ten to the nearest double, in 128 bit arithmetic (Eisel and Lemire: Lemire, Number parsing at a
 * gigabyte per second, 2021; that 128 bits always suffice: Mushtak and Lemire, Fast number parsing without fallback, 2023).
 */
final class PowersOfTen {

    private static final int MOST = 64;
    private static final long[] HIGH = new long[2 * MOST + 1];
    private static final long[] LOW = new long[2 * MOST + 1];
    private static final long HIDDEN = 1L << 52;

    static {
        for (int power = -MOST; power <= MOST; power++) {
            BigInteger bits = significant(power);
            HIGH[power + MOST] = bits.shiftRight(64).longValue();
            LOW[power + MOST] = bits.longValue();
        }
    }

    private PowersOfTen() {}

    /** The leading 128 bits of 5^power, rounded down, but up where power is negative. */
    private static BigInteger significant(int power) {
        BigInteger five = BigInteger.valueOf(5).pow(Math.abs(power));
        if (power >= 0) {
            return five.shiftLeft(128).shiftRight(five.bitLength());
        }
        int size = five.subtract(BigInteger.ONE).bitLength();
        int bits = power >= -27 ? size + 127 : 2 * size + 128;
        BigInteger inverse = BigInteger.ONE.shiftLeft(bits).divide(five).add(BigInteger.ONE);
        return inverse.shiftRight(Math.max(0, inverse.bitLength() - 128));
    }

    /**
     * {@code mantissa * 10^power}, rounded to the nearest double, ties to even.
     *
     * @param mantissa &gt; 0
     * @return NaN where the power is beyond the table, so that another way must be taken
     */
    static double times(long mantissa, int power) {
        if (power < -MOST || power > MOST) {
            return Double.NaN;
        }
        int zeros = Long.numberOfLeadingZeros(mantissa);
        long w = mantissa << zeros;
        long five = HIGH[power + MOST];
        long high = multiplyHigh(w, five);
        long low = w * five;
        if ((high & 0x1FF) == 0x1FF) {
            long carry = multiplyHigh(w, LOW[power + MOST]);
            low += carry;
            if (Long.compareUnsigned(carry, low) > 0) {
                high++;
            }
        }
        int upper = (int) (high >>> 63);
        int shift = upper + 9;
        long bits = high >>> shift;
        int exponent = (217_706 * power >> 16) + 63 + upper - zeros + 1023;
        boolean tie = low >= 0 && low <= 1 && power >= -4 && power <= 23 && (bits & 3) == 1 && bits << shift == high;
        bits = tie ? bits & ~1L : bits;
        bits = bits + (bits & 1) >>> 1;
        if (bits >= 2 * HIDDEN) {
            bits = HIDDEN;
            exponent++;
        }
        return Double.longBitsToDouble((long) exponent << 52 | bits & ~HIDDEN);
    }

    /** The upper half of a product of two unsigned numbers. */
    private static long multiplyHigh(long a, long b) {
        return Math.multiplyHigh(a, b) + (a >> 63 & b) + (b >> 63 & a);
    }
}

package wbv.body.number;

/** One message form for what a record refuses: quantity, rule, unit, value. */
public final class Check {

    private Check() {}

    /**
     * Refuses NaN and infinity.
     *
     * @param value of any unit
     */
    public static void finite(String quantity, String unit, double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(quantity + " must be a number [" + unit + "]: " + value);
        }
    }

    /**
     * Refuses what is not above 0, NaN and infinity.
     *
     * @param value of any unit
     */
    public static void positive(String quantity, String unit, double value) {
        if (!(value > 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(quantity + " must be > 0 " + unit + ": " + value);
        }
    }

    /**
     * Refuses what is below 0, NaN and infinity.
     *
     * @param value of any unit
     */
    public static void notNegative(String quantity, String unit, double value) {
        if (!(value >= 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(quantity + " must be >= 0 " + unit + ": " + value);
        }
    }

    /**
     * Refuses what is not above a bound, NaN and infinity.
     *
     * @param value of any unit
     * @param bound in the same unit
     */
    public static void above(String quantity, String unit, double value, double bound) {
        if (!(value > bound) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(quantity + " must be > " + bound + " " + unit + ": " + value);
        }
    }

    /**
     * Refuses what is outside low to high, both allowed, and NaN.
     *
     * @param value of any unit
     * @param low in the same unit
     * @param high likewise
     */
    public static void within(String quantity, String unit, double value, double low, double high) {
        if (!(value >= low && value <= high)) {
            throw new IllegalArgumentException(quantity + " must be " + low + " to " + high + " " + unit + ": " + value);
        }
    }
}

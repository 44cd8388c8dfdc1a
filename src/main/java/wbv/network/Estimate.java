package wbv.network;

/**
 * What is thought of a body. Arrays are not copied: treat them as read-only.
 *
 * @param value     damping ratio and natural pulsation [rad/s] of each mode, slowest first, two numbers for each; NaN where there is none
 * @param deviation standard deviation of each, as long, in its unit; NaN from methods that state none
 */
public record Estimate(double[] value, double[] deviation) {

    public Estimate {
        if (value.length != deviation.length) {
            throw new IllegalArgumentException("an estimate needs a deviation for every value: " + value.length + ", "
                    + deviation.length);
        }
    }

    /** Half the width of an interval of 90 % over the standard deviation, of a normal distribution. */
    public static final double NINETY = 1.6448536269514722;
}

package wbv.diagnosis.mechanism;

import java.util.function.ToDoubleFunction;

/**
 * A number as a reader expects it, made of those that a fit finds.
 *
 * @param key       with its unit
 * @param of        which numbers of the hypothesis
 * @param weights   one for each of them: powers of theirs in a product, factors in a sum
 * @param kind      how it is made
 * @param value     of a product, from the values of those numbers
 */
public record Told(String key, int[] of, double[] weights, Kind kind, ToDoubleFunction<double[]> value) {

    /** How a number is made. */
    public enum Kind { SUM, PRODUCT, AMPLITUDE }

    /** As it is found. */
    public static Told plain(String key, int of) {
        return new Told(key, new int[] {of}, new double[] {1}, Kind.SUM, x -> x[0]);
    }

    /** One times a factor [1]. */
    public static Told scaled(String key, int of, double factor) {
        return new Told(key, new int[] {of}, new double[] {factor}, Kind.SUM, x -> factor * x[0]);
    }

    /** The root of the sum of two squares. */
    public static Told amplitude(String key, int one, int other) {
        return new Told(key, new int[] {one, other}, new double[] {1, 1}, Kind.AMPLITUDE, x -> Math.hypot(x[0], x[1]));
    }

    /**
     * A product of powers. Arrays are not copied, not modified.
     *
     * @param powers exponents, one for each number
     * @param value the product itself, with the factor that it has
     */
    public static Told product(String key, int[] of, double[] powers, ToDoubleFunction<double[]> value) {
        return new Told(key, of, powers, Kind.PRODUCT, value);
    }
}

package wbv.diagnosis.mechanism;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleFunction;

/**
 * A place to start from.
 *
 * @param values  by number, in its unit
 * @param sizes   by number, in its unit: of an amplitude, how far from {@link Hypothesis.Number#nothing} it is looked at to first order
 * @param columns groups of numbers that scale together with the strength of the effect, to first order; none where the effect has
 *                no linear amplitude
 */
public record Start(double[] values, double[] sizes, List<int[]> columns) {

    /** Amplitudes that are nothing at 0, by number, in its unit. Not copied, not modified. */
    public Start(double[] values, List<int[]> columns) {
        this(values, values, columns);
    }

    /**
     * The same. Not copied, not modified.
     *
     * @param values by number, in its unit
     */
    public static Start of(double[] values, int[]... columns) {
        return new Start(values, List.of(columns));
    }

    /**
     * No amplitude.
     *
     * @param values one a number, in its unit
     */
    public static Start fixed(double... values) {
        return of(values);
    }

    /**
     * A single number, an amplitude.
     *
     * @param value in the number's unit
     */
    public static Start scaled(double value) {
        return of(new double[] {value}, new int[] {0});
    }

    /**
     * A start for each value.
     *
     * @param at as many as there shall be starts, in the unit of the number. Not modified.
     */
    public static List<Start> grid(double[] at, DoubleFunction<Start> make) {
        return Arrays.stream(at).mapToObj(make).toList();
    }
}

package wbv.body;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * A linear combination of few of many coordinates: Σ by_i q_(at_i).
 *
 * @param at indices of coordinates, each once, &gt;= 0. Not copied
 * @param by factor by which each is taken, as long as {@code at}: 1, -1, or a lever arm [m] of an angle. Not copied
 */
public record Row(int[] at, double[] by) {

    public Row {
        if (at.length != by.length || Arrays.stream(at).distinct().count() < at.length || Arrays.stream(at).anyMatch(i -> i < 0)) {
            throw new IllegalArgumentException(
                    "a combination needs each coordinate once, with one factor: " + Arrays.toString(at) + ", " + Arrays.toString(by));
        }
    }

    /** One coordinate; none of them for -1, which stands for the base. */
    public static Row of(int coordinate) {
        return coordinate < 0 ? new Row(new int[0], new double[0]) : new Row(new int[] {coordinate}, new double[] {1});
    }

    /**
     * The upper end less the lower end.
     *
     * @param from -1 for the base
     */
    public static Row between(int from, int to) {
        return from < 0 ? of(to) : new Row(new int[] {to, from}, new double[] {1, -1});
    }

    /** The same with one coordinate more, or with that much more of one that it has. */
    public Row plus(int coordinate, double factor) {
        int has = IntStream.range(0, at.length).filter(i -> at[i] == coordinate).findFirst().orElse(at.length);
        int[] more = Arrays.copyOf(at, Math.max(at.length, has + 1));
        double[] factors = Arrays.copyOf(by, more.length);
        more[has] = coordinate;
        factors[has] += factor;
        return new Row(more, factors);
    }

    /** What a coordinate is taken by; 0 for one that plays no part. */
    public double factor(int coordinate) {
        for (int i = 0; i < at.length; i++) {
            if (at[i] == coordinate) {
                return by[i];
            }
        }
        return 0;
    }

    /**
     * The combination of values that stand one after the other, from an offset on, in their unit.
     *
     * @param values in their own unit, by coordinate from the offset on. Not modified.
     */
    public double of(double[] values, int offset) {
        double sum = 0;
        for (int i = 0; i < at.length; i++) {
            sum += by[i] * values[offset + at[i]];
        }
        return sum;
    }

    /**
     * The combination of spectra or series, in their unit, as long as each. A new array.
     *
     * @param values by coordinate, in their own unit. Not modified.
     * @param length of each
     */
    public double[] of(double[][] values, int length) {
        double[] out = new double[length];
        for (int i = 0; i < at.length; i++) {
            Spectra.add(out, values[at[i]], by[i]);
        }
        return out;
    }
}

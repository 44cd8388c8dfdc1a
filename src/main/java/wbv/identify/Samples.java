package wbv.identify;

import java.io.Serializable;

/**
 * What a model is identified from: inputs and an output at a uniform rate, none missing. Arrays are not copied: read-only.
 *
 * @param rate samples per second [Hz], &gt; 0
 * @param u    by input and sample, each in its own unit, at least one
 * @param y    output, in its own unit, as long as each input
 */
public record Samples(double rate, double[][] u, double[] y) implements Serializable {

    public Samples {
        if (!(rate > 0) || Double.isInfinite(rate)) {
            throw new IllegalArgumentException("sampling rate must be > 0 Hz: " + rate);
        }
        if (u.length == 0 || y.length == 0) {
            throw new IllegalArgumentException("an identification needs an input and samples: " + u.length
                    + " inputs, " + y.length
                    + " samples");
        }
        for (double[] input : u) {
            if (input.length != y.length) {
                throw new IllegalArgumentException("an input must have as many samples as the output, " + y.length
                        + ": " + input.length);
            }
            requireFinite(input, "input");
        }
        requireFinite(y, "output");
    }

    /**
     * One input. Neither array is copied or modified.
     *
     * @param rate [Hz]
     * @param u by sample, in its own unit
     * @param y as long, in its own unit
     */
    public static Samples of(double rate, double[] u, double[] y) {
        return new Samples(rate, new double[][] {u}, y);
    }

    /** Samples in each input and the output. */
    public int length() {
        return y.length;
    }

    /** Number of inputs. */
    public int inputs() {
        return u.length;
    }

    private static void requireFinite(double[] values, String what) {
        for (int i = 0; i < values.length; i++) {
            if (!Double.isFinite(values[i])) {
                throw new IllegalArgumentException(what + " must be finite, but sample " + i + " is " + values[i]
                        + "; bridge or cut what is missing");
            }
        }
    }
}

package wbv.rig.concealed;

import java.util.function.Consumer;
import java.util.function.DoubleUnaryOperator;

/** What one sensor does wrong. Channels are acceleration x, y, z and rate x, y, z. */
interface Fault {

    /**
     * While it senses.
     *
     * @param six channels by sample at {@link UniformSeries#RATE}. Modified.
     */
    default void whileSensing(double[][] six) {}

    /**
     * As it sends.
     *
     * @param six channels by row. Modified.
     */
    default void whileSending(double[][] six) {}

    int Z = 2;

    /**
     * It rides on a soft strap: second-order resonance by the bilinear transform.
     *
     * @param frequency [Hz]
     * @param zeta damping ratio
     */
    static Fault strap(double frequency, double zeta) {
        return sensing(six -> {
            double w = Math.tan(Math.PI * frequency / UniformSeries.RATE);
            double a0 = 1 + 2 * zeta * w + w * w;
            double b0 = (w * w + 2 * zeta * w) / a0;
            double b1 = 2 * w * w / a0;
            double b2 = (w * w - 2 * zeta * w) / a0;
            double a1 = (2 * w * w - 2) / a0;
            double a2 = (1 - 2 * zeta * w + w * w) / a0;
            double[] in = six[Z].clone();
            for (int i = 2; i < in.length; i++) {
                six[Z][i] = b0 * in[i] + b1 * in[i - 1] + b2 * in[i - 2] - a1 * six[Z][i - 1] - a2 * six[Z][i - 2];
            }
        });
    }

    /**
     * It is turned about y, all its axes with it.
     *
     * @param angle [rad]
     */
    static Fault turned(double angle) {
        return sensing(six -> {
            double cos = Math.cos(angle);
            double sin = Math.sin(angle);
            for (int q = 0; q < 6; q += 3) {
                for (int i = 0; i < six[q].length; i++) {
                    double x = six[q][i];
                    six[q][i] = cos * x - sin * six[q + 2][i];
                    six[q + 2][i] = cos * six[q + 2][i] + sin * x;
                }
            }
        });
    }

    /**
     * All it sends is late, from one delay to another over the recording.
     *
     * @param start
     * @param end [s]
     */
    static Fault late(double start, double end) {
        return sensing(six -> {
            for (int q = 0; q < 6; q++) {
                double[] in = six[q].clone();
                for (int i = 0; i < in.length; i++) {
                    six[q][i] = UniformSeries.at(in, i - UniformSeries.RATE * (start + (end - start) * i / in.length));
                }
            }
        });
    }

    static Fault bias(double value) {
        return each(x -> x + value);
    }

    static Fault gain(double factor) {
        return each(x -> x * factor);
    }

    static Fault clipping(double low, double high) {
        return each(x -> Math.max(low, Math.min(high, x)));
    }

    /**
     * Runs of rows in which the last value is sent again.
     *
     * @param starts first rows
     * @param lengths rows
     */
    static Fault dropouts(int[] starts, int[] lengths) {
        return new Fault() {
            @Override
            public void whileSending(double[][] six) {
                for (double[] channel : six) {
                    for (int i = 0; i < starts.length; i++) {
                        for (int j = starts[i]; j < Math.min(channel.length, starts[i] + lengths[i]); j++) {
                            channel[j] = channel[starts[i] - 1];
                        }
                    }
                }
            }
        };
    }

    private static Fault each(DoubleUnaryOperator change) {
        return sensing(six -> {
            for (int i = 0; i < six[Z].length; i++) {
                six[Z][i] = change.applyAsDouble(six[Z][i]);
            }
        });
    }

    private static Fault sensing(Consumer<double[][]> change) {
        return new Fault() {
            @Override
            public void whileSensing(double[][] six) {
                change.accept(six);
            }
        };
    }
}

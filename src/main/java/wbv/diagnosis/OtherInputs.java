package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import wbv.body.Excitation;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/**
 * What the base's other channels add to an output: each through a finite impulse response, all fitted together by least squares (Wiener 1949,
 * Levinson 1947), from a little before to a second after, in steps of about a 60th of a second, which is as fine as what moves a sitter.
 */
final class OtherInputs {

    private static final double STEP = 1.0 / 60;
    private static final int BEFORE = 3;
    private static final int AFTER = 60;
    /** Part of each channel's power that is added to it, so that what none of them tells stays small. */
    private static final double RIDGE = 1e-3;
    private static final Set<Quantity> MOTION = Set.of(Quantity.ACCELERATION, Quantity.ANGULAR_RATE);

    private final List<Channel> channels;
    private final double[][] series;
    private final int stride;
    private final double[][] normal;

    /** @param input the channel that is no other */
    OtherInputs(Recording recording, Channel input) {
        channels = recording.channels().stream().filter(channel -> channel.location().equals(input.location())
                && MOTION.contains(channel.quantity()) && !channel.equals(input)).filter(channel -> moves(recording.values(channel))).toList();
        stride = Math.max(1, (int) Math.round(recording.clock().rate() * STEP));
        List<double[]> all = new ArrayList<>();
        for (Channel channel : channels) {
            double[] x = Excitation.bridged(recording.values(channel));
            double mean = Arrays.stream(x).average().orElse(0);
            all.add(Arrays.stream(x).map(value -> value - mean).toArray());
        }
        series = all.toArray(double[][]::new);
        normal = normal();
    }

    /** Channels that add something. */
    List<Channel> channels() {
        return channels;
    }

    private static boolean moves(double[] x) {
        return Arrays.stream(x).filter(value -> !Double.isNaN(value)).distinct().limit(2).count() == 2;
    }

    private int taps() {
        return BEFORE + 1 + AFTER;
    }

    private int lag(int tap) {
        return (tap - BEFORE) * stride;
    }

    /** Sums of products of all delayed channels, which depend on the difference of the delays alone but for the ends. */
    private double[][] normal() {
        int taps = taps();
        double[][] out = new double[series.length * taps][series.length * taps];
        for (int a = 0; a < series.length; a++) {
            for (int b = 0; b < series.length; b++) {
                double[] product = new double[2 * taps - 1];
                for (int d = 0; d < product.length; d++) {
                    product[d] = product(series[a], series[b], (d - taps + 1) * stride);
                }
                for (int i = 0; i < taps; i++) {
                    for (int j = 0; j < taps; j++) {
                        out[a * taps + i][b * taps + j] = product[j - i + taps - 1];
                    }
                }
            }
            for (int i = 0; i < taps; i++) {
                out[a * taps + i][a * taps + i] *= 1 + RIDGE;
            }
        }
        return out;
    }

    /** Σ a(t) b(t - lag). */
    private static double product(double[] a, double[] b, int lag) {
        double sum = 0;
        for (int t = Math.max(0, lag); t < Math.min(a.length, b.length + lag); t++) {
            sum += a[t] * b[t - lag];
        }
        return sum;
    }

    /** What they make of a series, as long as the recording; zeros where there are none. @param y Not modified. */
    double[] partOf(double[] y) {
        double[] out = new double[y.length];
        int taps = taps();
        double[] right = new double[series.length * taps];
        for (int a = 0; a < series.length; a++) {
            for (int i = 0; i < taps; i++) {
                right[a * taps + i] = product(y, series[a], lag(i));
            }
        }
        double[] h = Fitter.solve(normal, right, new boolean[right.length], 0);
        for (int a = 0; a < series.length; a++) {
            for (int i = 0; i < taps; i++) {
                int lag = lag(i);
                double own = h[a * taps + i];
                for (int t = Math.max(0, lag); t < Math.min(out.length, out.length + lag); t++) {
                    out[t] += own * series[a][t - lag];
                }
            }
        }
        return out;
    }
}

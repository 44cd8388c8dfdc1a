package wbv.diagnosis.surrogate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.measured.Measured;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/**
 * What the base's other channels add to an output beside the input: all of them, the input too, through finite impulse responses that are
 * fitted together by least squares (Wiener 1949, Levinson 1947), from a little before to a second after, in steps of about a 60th of a
 * second, which is as fine as what moves a sitter. The input has to be among them: on any ride it goes partly with the others, which would
 * be taken for what it does.
 */
final class OtherInputs {

    private static final double STEP = 1.0 / 60;
    private static final int BEFORE = 3;
    private static final int AFTER = 60;
    /**
     * Part of each channel's power that is added to it, so that what none of them tells stays small: a simulation's rounding, not a
     * sensor's noise.
     */
    private static final double RIDGE = 1e-5;
    private static final Set<Quantity> MOTION = Set.of(Quantity.ACCELERATION, Quantity.ANGULAR_RATE);

    private final List<Channel> others;
    /** The input first, then the others. */
    private final double[][] series;
    private final int stride;
    private final double[][] normal;

    /** @param input the channel that is no other */
    OtherInputs(Recording recording, Channel input) {
        others = recording.channels().stream().filter(channel -> channel.location().equals(input.location())
                && MOTION.contains(channel.quantity()) && !channel.equals(input)).filter(channel -> moves(recording.values(channel)))
                .toList();
        stride = Math.max(1, (int) Math.round(recording.clock().rate() * STEP));
        List<double[]> all = new ArrayList<>();
        for (Channel channel : Stream.concat(Stream.of(input), others.stream()).toList()) {
            all.add(LostSamples.centred(recording.values(channel)));
        }
        series = all.toArray(double[][]::new);
        normal = normal();
    }

    /** Channels that add something. */
    List<Channel> channels() {
        return others;
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

    /** Sums of products of all delayed channels: where both are a step later, one product more has left the record, or come into it. */
    private double[][] normal() {
        int taps = taps();
        double[][] out = new double[series.length * taps][series.length * taps];
        for (int a = 0; a < series.length; a++) {
            for (int b = 0; b < series.length; b++) {
                for (int i = 0; i < taps; i++) {
                    for (int j = 0; j < taps; j++) {
                        out[a * taps + i][b * taps + j] = i == 0 || j == 0 ? product(series[a], lag(i), series[b], lag(j))
                                : out[a * taps + i - 1][b * taps + j - 1] + atEnds(series[a], lag(i - 1), series[b], lag(j - 1));
                    }
                }
            }
            for (int i = 0; i < taps; i++) {
                out[a * taps + i][a * taps + i] *= 1 + RIDGE;
            }
        }
        return out;
    }

    /** What {@link #product} gains where both delays grow by a step. */
    private double atEnds(double[] a, int delayA, double[] b, int delayB) {
        double sum = 0;
        for (int s = 1; s <= stride; s++) {
            sum += at(a, -s - delayA) * at(b, -s - delayB) - at(a, a.length - s - delayA) * at(b, b.length - s - delayB);
        }
        return sum;
    }

    private static double at(double[] x, int i) {
        return i < 0 || i >= x.length ? 0 : x[i];
    }

    /** Σ a(t - delayA) b(t - delayB) over the record. */
    private static double product(double[] a, int delayA, double[] b, int delayB) {
        double sum = 0;
        for (int t = Math.max(0, Math.max(delayA, delayB)); t < Math.min(a.length, a.length + Math.min(delayA, delayB)); t++) {
            sum += a[t - delayA] * b[t - delayB];
        }
        return sum;
    }

    /**
     * What the others add to a series, as long as the recording; zeros where there are none.
     *
     * @param y Not modified.
     */
    double[] partOf(double[] y) {
        double[] out = new double[y.length];
        if (others.isEmpty()) {
            return out;
        }
        int taps = taps();
        double[] right = new double[series.length * taps];
        for (int a = 0; a < series.length; a++) {
            for (int i = 0; i < taps; i++) {
                right[a * taps + i] = product(y, 0, series[a], lag(i));
            }
        }
        double[] h = DampedEquations.solve(normal, right);
        for (int a = 1; a < series.length; a++) {
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

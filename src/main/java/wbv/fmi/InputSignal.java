package wbv.fmi;

import java.util.stream.IntStream;
import wbv.signal.LostSamples;

/**
 * A recorded channel at any moment: between samples band-limited, by a sinc in Kaiser's window (pass band to 0.44 of the rate, 90 dB:
 * Kaiser 1974) to eight points a sample, and between these by a cubic. Before and after, it goes on as its point mirror image.
 */
final class InputSignal {

    /** Points a sample: a cubic between them is off by less than 2e-5 of what has a fifth of the rate. */
    private static final int FINER = 8;
    private static final int HALF = 24;
    private static final double KAISER = 8.96;

    private final double[] fine;
    private final double rate;

    /**
     * @param samples with gaps, which are bridged. Not modified.
     * @param rate [Hz]
     * @param centred whether the mean is taken away
     */
    InputSignal(double[] samples, double rate, boolean centred) {
        double[] whole = LostSamples.filled(samples);
        double mean = centred ? IntStream.range(0, whole.length).mapToDouble(i -> whole[i]).average().orElse(0) : 0;
        this.rate = rate * FINER;
        double[][] weights = weights();
        int last = whole.length - 1;
        fine = new double[last * FINER + 1];
        for (int i = 0; i < fine.length; i++) {
            int at = i / FINER;
            double[] own = weights[i % FINER];
            double sum = 0;
            for (int k = 0; k < own.length; k++) {
                sum += own[k] * extended(whole, at + k - HALF + 1);
            }
            fine[i] = sum - mean;
        }
    }

    private static double extended(double[] x, int i) {
        int last = x.length - 1;
        if (i < 0) {
            return 2 * x[0] - x[Math.min(last, -i)];
        }
        return i <= last ? x[i] : 2 * x[last] - x[Math.max(0, 2 * last - i)];
    }

    /** By place between two samples, the weights of the samples around, which add up to 1. */
    private static double[][] weights() {
        double[][] out = new double[FINER][2 * HALF];
        for (int f = 0; f < FINER; f++) {
            double sum = 0;
            for (int k = 0; k < 2 * HALF; k++) {
                double x = (double) f / FINER - (k - HALF + 1);
                double sinc = x == 0 ? 1 : Math.sin(Math.PI * x) / (Math.PI * x);
                double inside = Math.max(0, 1 - x / HALF * (x / HALF));
                out[f][k] = sinc * bessel(KAISER * Math.sqrt(inside));
                sum += out[f][k];
            }
            for (int k = 0; k < 2 * HALF; k++) {
                out[f][k] /= sum;
            }
        }
        return out;
    }

    /** Modified Bessel function of the first kind and order 0, up to a factor that the weights' sum takes away. */
    private static double bessel(double x) {
        double term = 1;
        double sum = 1;
        for (int k = 1; term > 1e-17 * sum; k++) {
            term *= x / (2 * k) * (x / (2 * k));
            sum += term;
        }
        return sum;
    }

    /**
     * Its value.
     *
     * @param time since the first sample [s]; beyond the ends the nearest value
     */
    double at(double time) {
        double place = time * rate;
        if (place <= 0 || fine.length < 4) {
            return fine[Math.max(0, Math.min(fine.length - 1, (int) Math.rint(place)))];
        }
        if (place >= fine.length - 1) {
            return fine[fine.length - 1];
        }
        int i = Math.max(1, Math.min(fine.length - 3, (int) place));
        double x = place - i;
        return cubic(fine[i - 1], fine[i], fine[i + 1], fine[i + 2], x);
    }

    /** Lagrange's cubic through values at -1, 0, 1 and 2. */
    static double cubic(double a, double b, double c, double d, double x) {
        return -a * x * (x - 1) * (x - 2) / 6 + b * (x + 1) * (x - 1) * (x - 2) / 2 - c * (x + 1) * x * (x - 2) / 2
                + d * (x + 1) * x * (x - 1) / 6;
    }

    /** The constant over a step that does what the signal does: raised by what a hold takes away, (x / sin x) to second order. */
    double held(double time, double step) {
        double middle = at(time + step / 2);
        return middle - (at(time + 1.5 * step) - 2 * middle + at(time - step / 2)) / 24;
    }

    /** The corner, at a time, of the broken line that does what the signal does: (x / sin x)² to second order. */
    double corner(double time, double step) {
        double own = at(time);
        return own - (at(time + step) - 2 * own + at(time - step)) / 12;
    }
}

package wbv.rig.concealed;

import java.util.Arrays;
import org.apache.commons.math3.random.RandomGenerator;

/** Values over a uniform clock at {@value #RATE} Hz, as arrays. */
final class UniformSeries {

    /** Samples per second of all that moves [Hz]. */
    static final double RATE = 960;

    private UniformSeries() {}

    static double rms(double[] x) {
        double sum = 0;
        for (double value : x) {
            sum += value * value;
        }
        return Math.sqrt(sum / x.length);
    }

    static double mean(double[] x) {
        return Arrays.stream(x).average().orElse(0);
    }

    /** The value below which a share of them lies. */
    static double quantile(double[] x, double share) {
        double[] sorted = x.clone();
        Arrays.sort(sorted);
        return sorted[(int) Math.min(sorted.length - 1, share * sorted.length)];
    }

    static double[] scaled(double[] x, double factor) {
        double[] out = new double[x.length];
        for (int i = 0; i < x.length; i++) {
            out[i] = factor * x[i];
        }
        return out;
    }

    static double[] less(double[] a, double[] b) {
        double[] out = new double[a.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = a[i] - b[i];
        }
        return out;
    }

    /** Rate of change by central differences. */
    static double[] rate(double[] x) {
        double[] out = new double[x.length];
        for (int i = 1; i < x.length - 1; i++) {
            out[i] = (x[i + 1] - x[i - 1]) * RATE / 2;
        }
        return out;
    }

    /** The value at a sample that need not be whole, by a cubic; held at the ends. */
    static double at(double[] x, double sample) {
        double inside = Math.max(0, Math.min(x.length - 1, sample));
        int s = (int) inside;
        return ChainPlant.cubic(x, s, inside - s);
    }

    /**
     * Many sines of random phase with a spectrum.
     *
     * @param length samples
     * @param low
     * @param high edges of the band [Hz]
     * @param slope amplitude goes as f to this power
     * @param rms of the whole
     */
    static double[] lines(int length, double low, double high, double slope, double rms, RandomGenerator random) {
        double[] out = new double[length];
        double spacing = Math.max(0.03, RATE / length);
        for (double f = low; f < high; f += spacing * (0.8 + 0.4 * random.nextDouble())) {
            double phase = 2 * Math.PI * random.nextDouble();
            double turn = 2 * Math.PI * f / RATE;
            double re = StrictMath.cos(phase) * StrictMath.pow(f, slope);
            double im = StrictMath.sin(phase) * StrictMath.pow(f, slope);
            double cos = StrictMath.cos(turn);
            double sin = StrictMath.sin(turn);
            for (int i = 0; i < length; i++) {
                out[i] += im;
                double next = re * cos - im * sin;
                im = re * sin + im * cos;
                re = next;
            }
        }
        return scaled(out, rms / rms(out));
    }

    /** Swells and fades over so many seconds at both ends, in place. */
    static void fade(double[] x, double seconds) {
        int n = Math.min(x.length / 2, (int) Math.round(seconds * RATE));
        for (int i = 0; i < n; i++) {
            double gain = 0.5 - 0.5 * StrictMath.cos(Math.PI * i / n);
            x[i] *= gain;
            x[x.length - 1 - i] *= gain;
        }
    }
}

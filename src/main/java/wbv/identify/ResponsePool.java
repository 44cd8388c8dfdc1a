package wbv.identify;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.ejml.data.Complex_F64;
import wbv.signal.Fft;
import wbv.signal.Window;

/**
 * Gathers stretches of many recordings, each with its own pulsation, and fits one {@link ScaledResponse} to all: spectral lines
 * of Hann-windowed segments, by Sanathanan's and Koerner's iteration (1963), each segment weighing as its output's power is one.
 *
 * <p>A seated body goes along with what moves it slowly: the static gain of the first input is 1, that of other accelerations 0.
 * Without this, lines near rest, where there is little motion, invent slow poles.
 */
public final class ResponsePool {

    /** Longest segment [s]; the power of two below it that a stretch holds is taken. */
    private static final double LONGEST = 20;
    private static final int ITERATIONS = 15;
    /** Least decay of a fitted pole, in units of ω: a slower one is noise at rest. */
    private static final double LEAST_DECAY = 0.001;

    private final boolean[] rates;
    private final double low;
    private final double high;
    private final List<double[]> lines = new ArrayList<>();

    /** @param rates whether each input is an angular rate @param low lowest frequency used [Hz] @param high highest [Hz] */
    public ResponsePool(boolean[] rates, double low, double high) {
        if (!(low > 0 && high > low)) {
            throw new IllegalArgumentException("the band must be > 0 Hz and rise: " + low + " to " + high);
        }
        this.rates = rates.clone();
        this.low = low;
        this.high = high;
    }

    /** Spectral lines gathered. */
    public int lines() {
        return lines.size();
    }

    /**
     * Adds all segments of a stretch without missing samples, overlapping by half.
     *
     * @param omega pulsation of the body in it [rad/s], &gt; 0
     */
    public void add(Samples samples, double omega) {
        int segment = Integer.highestOneBit((int) Math.min(samples.length(), LONGEST * samples.rate()));
        if (segment < 8) {
            return;
        }
        Fft fft = new Fft(segment);
        Window window = Window.hann(segment);
        for (int from = 0; from + segment <= samples.length(); from += segment / 2) {
            addSegment(samples, from, omega, fft, window);
        }
    }

    private void addSegment(Samples samples, int from, double omega, Fft fft, Window window) {
        double[] y = spectrum(samples.y(), from, fft, window);
        double[][] u = new double[rates.length][];
        for (int i = 0; i < u.length; i++) {
            u[i] = spectrum(samples.u()[i], from, fft, window);
        }
        List<double[]> segment = new ArrayList<>();
        double power = 0;
        for (int k = 1; k < fft.length() / 2; k++) {
            double f = k * samples.rate() / fft.length();
            if (f < low || f > high) {
                continue;
            }
            double[] line = new double[3 + 2 * rates.length];
            line[0] = 2 * Math.PI * f / omega;
            line[1] = y[2 * k];
            line[2] = y[2 * k + 1];
            for (int i = 0; i < rates.length; i++) {
                double re = u[i][2 * k];
                double im = u[i][2 * k + 1];
                double w = 2 * Math.PI * f;
                line[3 + 2 * i] = rates[i] ? -w * im : re;
                line[4 + 2 * i] = rates[i] ? w * re : im;
            }
            power += line[1] * line[1] + line[2] * line[2];
            segment.add(line);
        }
        if (power > 0) {
            double scale = 1 / Math.sqrt(power);
            for (double[] line : segment) {
                for (int j = 1; j < line.length; j++) {
                    line[j] *= scale;
                }
                lines.add(line);
            }
        }
    }

    private static double[] spectrum(double[] values, int from, Fft fft, Window window) {
        double[] segment = Arrays.copyOfRange(values, from, from + fft.length());
        double mean = Arrays.stream(segment).average().orElse(0);
        for (int i = 0; i < segment.length; i++) {
            segment[i] -= mean;
        }
        window.apply(segment);
        fft.forward(segment);
        return segment;
    }

    /**
     * Fits.
     *
     * @param order of A, &gt;= 1
     * @throws IllegalArgumentException if there are too few lines
     */
    public ScaledResponse fit(int order) {
        int unknowns = order * (1 + rates.length);
        if (lines.size() < 2 * unknowns) {
            throw new IllegalArgumentException("a response of order " + order + " needs at least " + 2 * unknowns
                    + " spectral lines: "
                    + lines.size());
        }
        double[] theta = new double[unknowns];
        double[] re = new double[unknowns];
        double[] im = new double[unknowns];
        double[] power = new double[2 * (order + 1)];
        LeastSquares normal = new LeastSquares(unknowns);
        for (int iteration = 0; iteration < ITERATIONS; iteration++) {
            normal.clear();
            for (double[] line : lines) {
                powers(line[0], power);
                double weight = iteration == 0 ? 1 : 1 / denominator(theta, order, power);
                row(line, order, power, weight, re, im);
                double topRe = power[2 * order];
                double topIm = power[2 * order + 1];
                normal.add(re, weight * (line[1] * topRe - line[2] * topIm));
                normal.add(im, weight * (line[1] * topIm + line[2] * topRe));
            }
            theta = normal.solve(0);
        }
        return response(stable(Arrays.copyOf(theta, order)), theta, order);
    }

    private ScaledResponse response(double[] a, double[] theta, int order) {
        double[][] b = new double[rates.length][];
        for (int i = 0; i < rates.length; i++) {
            int first = rates[i] ? 0 : 1;
            b[i] = new double[order + first];
            System.arraycopy(theta, order * (1 + i), b[i], first, order);
            if (i == 0 && !rates[i]) {
                b[i][0] = a[0];
            }
        }
        return new ScaledResponse(a, b, rates.clone());
    }

    /** (jx)^k as pairs. */
    private static void powers(double x, double[] into) {
        into[0] = 1;
        into[1] = 0;
        for (int k = 2; k < into.length; k += 2) {
            into[k] = -x * into[k - 1];
            into[k + 1] = x * into[k - 2];
        }
    }

    private static double denominator(double[] theta, int order, double[] power) {
        double re = power[2 * order];
        double im = power[2 * order + 1];
        for (int k = 0; k < order; k++) {
            re += theta[k] * power[2 * k];
            im += theta[k] * power[2 * k + 1];
        }
        return Math.hypot(re, im);
    }

    /** Regressors of a line: a_k; then of each acceleration the powers 1 to n, of each rate 0 to n - 1. */
    private void row(double[] line, int order, double[] power, double weight, double[] re, double[] im) {
        for (int k = 0; k < order; k++) {
            // The first input shares a_0, which makes its static gain 1.
            boolean shared = k == 0 && !rates[0];
            times(shared ? line[3] - line[1] : -line[1], shared ? line[4] - line[2] : -line[2], power, k, weight, re, im, k);
        }
        for (int i = 0; i < rates.length; i++) {
            int first = rates[i] ? 0 : 1;
            for (int k = 0; k < order; k++) {
                times(line[3 + 2 * i], line[4 + 2 * i], power, k + first, weight, re, im, order * (1 + i) + k);
            }
        }
    }

    private static void times(double a, double b, double[] power, int k, double weight, double[] re, double[] im, int at) {
        re[at] = weight * (a * power[2 * k] - b * power[2 * k + 1]);
        im[at] = weight * (a * power[2 * k + 1] + b * power[2 * k]);
    }

    /** Poles right of the least decay are moved left of it. @param a ascending */
    private static double[] stable(double[] a) {
        int n = a.length;
        double[] descending = new double[n];
        for (int k = 0; k < n; k++) {
            descending[n - 1 - k] = a[k];
        }
        Complex_F64[] roots = Polynomial.roots(descending);
        double[] re = new double[n + 1];
        double[] im = new double[n + 1];
        re[0] = 1;
        for (int i = 0; i < n; i++) {
            double r = roots[i].real <= -LEAST_DECAY ? roots[i].real : -Math.max(LEAST_DECAY, Math.abs(roots[i].real));
            for (int k = i + 1; k > 0; k--) {
                double nextRe = re[k] - (r * re[k - 1] - roots[i].imaginary * im[k - 1]);
                double nextIm = im[k] - (r * im[k - 1] + roots[i].imaginary * re[k - 1]);
                re[k] = nextRe;
                im[k] = nextIm;
            }
        }
        double[] ascending = new double[n];
        for (int k = 0; k < n; k++) {
            ascending[k] = re[n - k];
        }
        return ascending;
    }
}

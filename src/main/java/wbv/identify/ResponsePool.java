package wbv.identify;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.ejml.data.Complex_F64;
import wbv.signal.Fft;
import wbv.signal.Taper;

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
    /** How far a body's pulsation is sought from what its pole tells (ln), and in what steps. */
    private static final double REACH = 0.25;
    private static final double STEP = 0.02;
    private static final int ROUNDS = 4;
    private static final double SETTLED = 0.003;
    /** Spread of pulsations (ln) below which they do not show an exponent. */
    private static final double LEAST_SPREAD = 0.03;
    private static final double LEAST_EXPONENT = 0.5;
    private static final double MOST_EXPONENT = 1.5;

    private final List<Stretch> stretches = new ArrayList<>();

    /**
     * Spectral lines of one body: frequency [rad/s], output, then every input, all complex.
     *
     * @param omega measured [rad/s]
     */
    private record Stretch(double omega, List<double[]> lines) {}

    /**
     * A pool of no stretch yet.
     *
     * @param rates whether each input is an angular rate. Not modified.
     * @param low lowest frequency used [Hz]
     * @param high highest [Hz]
     */
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
        return stretches.stream().mapToInt(stretch -> stretch.lines().size()).sum();
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
        Taper window = Taper.hann(segment);
        Stretch stretch = new Stretch(omega, new ArrayList<>());
        for (int from = 0; from + segment <= samples.length(); from += segment / 2) {
            addSegment(samples, from, stretch, fft, window);
        }
        stretches.add(stretch);
    }

    private void addSegment(Samples samples, int from, Stretch stretch, Fft fft, Taper window) {
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
            line[0] = 2 * Math.PI * f;
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
                stretch.lines().add(line);
            }
        }
    }

    private static double[] spectrum(double[] values, int from, Fft fft, Taper window) {
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
        return fit(order, stretches.stream().mapToDouble(Stretch::omega).toArray());
    }

    /**
     * Fits, and learns with what power the pulsation of the body follows the one that was given with each stretch.
     *
     * @param order of A, &gt;= 1
     * @throws IllegalArgumentException if there are too few lines
     */
    public TunedResponse fitTuned(int order) {
        double[] log = stretches.stream().mapToDouble(stretch -> Math.log(stretch.omega())).toArray();
        double centre = Arrays.stream(log).average().orElse(0);
        double spread = Math.sqrt(Arrays.stream(log).map(value -> (value - centre) * (value - centre)).average().orElse(0));
        double exponent = 1;
        ScaledResponse response = fit(order);
        for (int round = 0; round < ROUNDS && spread > LEAST_SPREAD; round++) {
            SimpleRegression line = new SimpleRegression();
            for (int i = 0; i < log.length; i++) {
                double told = centre + exponent * (log[i] - centre);
                line.addData(log[i], told + faster(stretches.get(i), response, told));
            }
            double before = exponent;
            exponent = Math.max(LEAST_EXPONENT, Math.min(MOST_EXPONENT, line.getSlope()));
            double power = exponent;
            response = fit(order, Arrays.stream(log).map(value -> Math.exp(centre + power * (value - centre))).toArray());
            if (Math.abs(exponent - before) < SETTLED) {
                break;
            }
        }
        return new TunedResponse(response, Math.exp(centre), exponent);
    }

    /** How much faster (ln) than this pulsation (ln) a stretch goes, by the response that fits it best. */
    private double faster(Stretch stretch, ScaledResponse response, double log) {
        int steps = (int) Math.round(REACH / STEP);
        double[] misfit = new double[2 * steps + 1];
        int best = 0;
        for (int i = 0; i < misfit.length; i++) {
            misfit[i] = misfit(stretch, response, Math.exp(log + (i - steps) * STEP));
            best = misfit[i] < misfit[best] ? i : best;
        }
        if (best == 0 || best == misfit.length - 1) {
            return (best - steps) * STEP;
        }
        double bend = misfit[best - 1] - 2 * misfit[best] + misfit[best + 1];
        return (best - steps + (bend > 0 ? (misfit[best - 1] - misfit[best + 1]) / (2 * bend) : 0)) * STEP;
    }

    /** Σ |Y - Σ B_i U_i / A|² over the lines. */
    private double misfit(Stretch stretch, ScaledResponse response, double omega) {
        double sum = 0;
        double[] a = response.a();
        int n = a.length;
        double[] power = new double[2 * (n + 1)];
        for (double[] line : stretch.lines()) {
            powers(line[0] / omega, power);
            double downRe = power[2 * n];
            double downIm = power[2 * n + 1];
            for (int k = 0; k < n; k++) {
                downRe += a[k] * power[2 * k];
                downIm += a[k] * power[2 * k + 1];
            }
            double upRe = 0;
            double upIm = 0;
            for (int i = 0; i < rates.length; i++) {
                double bRe = 0;
                double bIm = 0;
                for (int k = 0; k < response.b()[i].length; k++) {
                    bRe += response.b()[i][k] * power[2 * k];
                    bIm += response.b()[i][k] * power[2 * k + 1];
                }
                upRe += bRe * line[3 + 2 * i] - bIm * line[4 + 2 * i];
                upIm += bRe * line[4 + 2 * i] + bIm * line[3 + 2 * i];
            }
            double size = downRe * downRe + downIm * downIm;
            double re = line[1] - (upRe * downRe + upIm * downIm) / size;
            double im = line[2] - (upIm * downRe - upRe * downIm) / size;
            sum += re * re + im * im;
        }
        return sum;
    }

    /** @param omega pulsation of each stretch [rad/s] */
    private ScaledResponse fit(int order, double[] omega) {
        int unknowns = order * (1 + rates.length);
        if (lines() < 2 * unknowns) {
            throw new IllegalArgumentException("a response of order " + order + " needs at least " + 2 * unknowns
                    + " spectral lines: "
                    + lines());
        }
        double[] theta = new double[unknowns];
        double[] re = new double[unknowns];
        double[] im = new double[unknowns];
        double[] power = new double[2 * (order + 1)];
        LeastSquares normal = new LeastSquares(unknowns);
        for (int iteration = 0; iteration < ITERATIONS; iteration++) {
            normal.clear();
            for (int i = 0; i < omega.length; i++) {
                for (double[] line : stretches.get(i).lines()) {
                    powers(line[0] / omega[i], power);
                    double weight = iteration == 0 ? 1 : 1 / denominator(theta, order, power);
                    row(line, order, power, weight, re, im);
                    double topRe = power[2 * order];
                    double topIm = power[2 * order + 1];
                    normal.add(re, weight * (line[1] * topRe - line[2] * topIm));
                    normal.add(im, weight * (line[1] * topIm + line[2] * topRe));
                }
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

    /**
     * Poles right of the least decay are moved left of it.
     *
     * @param a ascending
     */
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

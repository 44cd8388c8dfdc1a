package wbv.signal;

import java.util.Arrays;
import java.util.function.DoublePredicate;

/**
 * The response of an output to an input through time, by Morlet's wavelet: at every moment and frequency the cross power of the
 * two transforms over the power of the input's, both averaged over time about the moment (Torrence and Webster, J. Climate 12,
 * 1999, average likewise). What changes while the record lasts, as a sitter who softens does, shows; a mean over the record
 * would smear it.
 *
 * <p>The average weighs moments by a Gaussian of {@value #SMOOTHING} times the wavelet's standard deviation, which makes about
 * {@link #AVERAGES} independent values of each; so a coherence above {@link #CHANCE} comes by chance once in twenty times.
 * Values nearer to an end than the wavelet reaches, or with a tenth or more of their weight on missing samples, are NaN.
 *
 * @param times       by column, their centres, rising evenly [s]
 * @param frequencies by row, rising [Hz]
 * @param modulus     in the unit of the output over that of the input, by column, then by frequency; NaN where nothing is known
 * @param phase       likewise [rad]
 * @param coherence   likewise, 0 to 1
 */
public record WaveletResponse(double[] times, double[] frequencies, double[][] modulus, double[][] phase, double[][] coherence) {

    private static final double SMOOTHING = 8;

    /**
     * Independent values in an average: {@code √(1 + 2 s²)} for Gaussian weights of s standard deviations of the wavelet, whose
     * transform of white noise is correlated by {@code exp(-t²/4)}.
     */
    public static final double AVERAGES = Math.sqrt(1 + 2 * SMOOTHING * SMOOTHING);

    /** Coherence that two signals without relation exceed once in twenty times: {@code 1 - 0.05^(1/(n-1))} (Goodman 1957). */
    public static final double CHANCE = 1 - Math.pow(0.05, 1 / (AVERAGES - 1));

    private static final double REACH = 3;
    private static final double MOST_MISSING = 0.1;

    /**
     * Measures it.
     *
     * @param rate        samples per second [Hz]
     * @param start       time of the first sample [s]
     * @param input       series of any unit; NaN is missing. Not modified.
     * @param output      as long, of any unit. Not modified.
     * @param frequencies as many as wanted, rising, above 0 to half the rate [Hz]. Not modified.
     * @param columns     how many moments, at least 2, evenly over the record
     */
    public static WaveletResponse of(double rate, double start, double[] input, double[] output, double[] frequencies, int columns) {
        if (input.length != output.length || input.length < 2 || columns < 2) {
            throw new IllegalArgumentException("a response needs as many samples in as out, two columns at least: " + input.length
                    + ", " + output.length + ", " + columns);
        }
        int n = input.length;
        double[] x = new double[n];
        double[] y = new double[n];
        boolean[] missing = new boolean[n];
        for (int i = 0; i < n; i++) {
            missing[i] = Double.isNaN(input[i]) || Double.isNaN(output[i]);
            x[i] = missing[i] ? 0 : input[i];
            y[i] = missing[i] ? 0 : output[i];
        }
        double[] times = new double[columns];
        Arrays.setAll(times, c -> start + (c + 0.5) * n / columns / rate);
        double[][] modulus = new double[columns][frequencies.length];
        double[][] phase = new double[columns][frequencies.length];
        double[][] coherence = new double[columns][frequencies.length];
        MorletTransform transform = new MorletTransform(rate, frequencies, MorletTransform.USUAL_CYCLES);
        MorletTransform.Record cause = transform.record(x);
        MorletTransform.Record answer = transform.record(y);
        for (int k = 0; k < frequencies.length; k++) {
            ComplexSeries from = cause.at(k);
            ComplexSeries to = answer.at(k);
            double spread = SMOOTHING * MorletTransform.USUAL_CYCLES / (2 * Math.PI * frequencies[k]) * rate;
            for (int c = 0; c < columns; c++) {
                double centre = (c + 0.5) * n / columns;
                Average average = Average.about(centre, spread, from, to, missing);
                boolean known = average.missing < MOST_MISSING && average.input > 0
                        && Math.min(centre, n - centre) / rate >= transform.influence(k);
                modulus[c][k] = known ? Math.hypot(average.re, average.im) / average.input : Double.NaN;
                phase[c][k] = known ? Math.atan2(average.im, average.re) : Double.NaN;
                coherence[c][k] = known && average.output > 0
                        ? (average.re * average.re + average.im * average.im) / (average.input * average.output) : Double.NaN;
            }
        }
        return new WaveletResponse(times, frequencies.clone(), modulus, phase, coherence);
    }

    /** The same with holes at frequencies where the input has no power of its own, only what the wavelet's breadth lets through. */
    public WaveletResponse where(DoublePredicate excited) {
        double[][] less = new double[times.length][];
        for (int c = 0; c < less.length; c++) {
            less[c] = modulus[c].clone();
            for (int k = 0; k < frequencies.length; k++) {
                less[c][k] = excited.test(frequencies[k]) ? less[c][k] : Double.NaN;
            }
        }
        return new WaveletResponse(times, frequencies, less, phase, coherence);
    }

    /** The modulus, by column and frequency, with holes where the coherence could be chance. */
    public double[][] backed() {
        double[][] backed = new double[times.length][];
        for (int c = 0; c < backed.length; c++) {
            int column = c;
            backed[c] = modulus[c].clone();
            Arrays.setAll(backed[c], k -> coherence[column][k] > CHANCE ? backed[column][k] : Double.NaN);
        }
        return backed;
    }

    /**
     * By column, where the response is greatest there, among what is backed, between samples by a parabola [Hz]; NaN where the
     * greatest is at an end of what is backed.
     */
    public double[] ridge() {
        double[] ridge = new double[times.length];
        double[][] backed = backed();
        for (int c = 0; c < ridge.length; c++) {
            int best = -1;
            for (int k = 0; k < frequencies.length; k++) {
                best = backed[c][k] > (best < 0 ? 0 : backed[c][best]) ? k : best;
            }
            ridge[c] = best > 0 && best + 1 < frequencies.length ? top(backed[c], best) : Double.NaN;
        }
        return ridge;
    }

    private double top(double[] column, int best) {
        double before = column[best - 1];
        double after = column[best + 1];
        double bend = before - 2 * column[best] + after; // NaN beside a hole
        return bend < 0 ? frequencies[best] + (frequencies[best + 1] - frequencies[best]) * 0.5 * (before - after) / bend : Double.NaN;
    }

    /** Weighted means about a moment: powers of input and output, their cross power, share of weight on missing samples. */
    private record Average(double input, double output, double re, double im, double missing) {

        static Average about(double centre, double spread, ComplexSeries x, ComplexSeries y, boolean[] missing) {
            int first = (int) Math.max(0, Math.ceil(centre - REACH * spread));
            int last = (int) Math.min(missing.length - 1, Math.floor(centre + REACH * spread));
            double input = 0;
            double output = 0;
            double re = 0;
            double im = 0;
            double all = 0;
            double absent = 0;
            for (int i = first; i <= last; i++) {
                double off = (i - centre) / spread;
                double weight = Math.exp(-off * off / 2);
                double a = x.re()[i];
                double b = x.im()[i];
                double c = y.re()[i];
                double d = y.im()[i];
                all += weight;
                absent += missing[i] ? weight : 0;
                input += weight * (a * a + b * b);
                output += weight * (c * c + d * d);
                re += weight * (a * c + b * d);
                im += weight * (a * d - b * c);
            }
            return new Average(input / all, output / all, re / all, im / all, absent / all);
        }
    }
}

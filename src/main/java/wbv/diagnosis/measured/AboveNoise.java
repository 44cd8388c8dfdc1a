package wbv.diagnosis.measured;

import java.util.Arrays;
import wbv.body.Spectra;
import wbv.body.simulate.Excitation;

/**
 * What of a series is more than white noise of its sensor (Wiener, Extrapolation, Interpolation, and Smoothing of Stationary Time Series,
 * 1949), by its power over neighbouring lines.
 */
public final class AboveNoise {

    /** Lines to either side over which the power of one is averaged, an effort. */
    private static final int LINES = 8;
    /** Times its mean that the power of noise never reaches so: six deviations of the mean of 2 (2 LINES + 1) squares. */
    private static final double SURE = 1 + 6 / Math.sqrt(2 * LINES + 1);
    /** Part of an integral's power that noise is at most [1], an effort: a tenth of its size. */
    private static final double MOST = 0.01;

    private AboveNoise() {}

    /**
     * The integral of what is no noise: a spectrum, in the series' unit times seconds as often as it is integrated. Nothing below where
     * noise would be more of the integral than a little.
     *
     * @param spectrum of a series of the recording, as {@link Excitation#spectrum} gives it, in its own unit. Not modified.
     * @param noise standard deviation of a sample, in the same unit
     * @param times how often it is integrated
     */
    public static double[] integral(Excitation excitation, double[] spectrum, double noise, int times) {
        // A blow at the first sample is at every line as strong as that of noise is in the mean.
        double[] blow = new double[excitation.samples()];
        blow[0] = noise * Math.sqrt(blow.length);
        double[] mean = power(excitation.spectrum(blow));
        double[] own = power(spectrum);
        double[] out = spectrum;
        for (int i = 0; i < times; i++) {
            out = Spectra.overJOmega(excitation.omega(), out);
        }
        out = out.clone();
        double[] integrated = power(out);
        double all = 0;
        double ofNoise = 0;
        for (int k = own.length - 1; k >= 0; k--) {
            double above = around(own, k) / mean[k];
            double shown = above > SURE ? 1 - 1 / above : 0;
            if (shown > 0 && k > 0) {
                all += integrated[k];
                ofNoise += mean[k] / Math.pow(excitation.omega()[k], 2 * times);
            }
            boolean little = ofNoise < MOST * all;
            out[2 * k] *= little ? shown : 0;
            out[2 * k + 1] *= little ? shown : 0;
        }
        return out;
    }

    /** Mean power about a line, of as many lines as there are. */
    private static double around(double[] power, int k) {
        int from = Math.max(0, k - LINES);
        int to = Math.min(power.length - 1, k + LINES);
        double sum = 0;
        for (int i = from; i <= to; i++) {
            sum += power[i];
        }
        return sum / (to - from + 1);
    }

    /** Power by line of a spectrum. */
    private static double[] power(double[] spectrum) {
        double[] out = new double[spectrum.length / 2];
        Arrays.setAll(out, k -> spectrum[2 * k] * spectrum[2 * k] + spectrum[2 * k + 1] * spectrum[2 * k + 1]);
        return out;
    }
}

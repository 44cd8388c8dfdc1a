package wbv.signal;

import java.util.Arrays;

/**
 * Continuous wavelet transform by Morlet's complex wavelet, {@code W(t, a) = ∫ x(τ) ψ*((τ-t)/a) dτ / …}, computed exactly at
 * every
 * sample in the frequency domain (Torrence and Compo, Bull. Am. Meteorol. Soc. 79, 1998; thesis Eq. 2-26 with the conjugate and
 * limits ±∞ that it lacks).
 *
 * <p>Scaled so that the modulus is an amplitude: a sine of amplitude A at one of the frequencies gives A there. The wavelet at
 * frequency f is a Gaussian of standard deviation {@code a = ω_0/(2πf)} in time and {@code f/ω_0} in frequency. The signal is
 * followed by silence, whose edges are felt within {@code √2 a} of the ends: the cone of influence.
 * Thesis: Eq. 2-27.
 */
public final class MorletTransform {

    /** As many radians in the wavelet's standard deviation as usual. */
    public static final double USUAL_CYCLES = 6;
    private static final double REACH = 6;

    private final double rate;
    private final double[] frequencies;
    private final double cycles;

    /**
     * The transform of a record.
     *
     * @param rate samples per second [Hz]
     * @param frequencies as the transform has them, as long [Hz]
     * @param values by frequency, one complex value a sample
     * @param influence by frequency, how near an end of the record a value is not to be trusted [s]
     */
    public record Scalogram(double rate, double[] frequencies, ComplexSeries[] values, double[] influence) {

        /** Whether a value lies outside the cone of influence. */
        public boolean trusted(int frequency, int sample) {
            int last = values[frequency].length() - 1;
            return Math.min(sample, last - sample) / rate >= influence[frequency];
        }
    }

    /**
     * A transform at given frequencies.
     *
     * @param rate        samples per second [Hz]
     * @param frequencies as many as wanted, above 0, up to half the rate [Hz]. Not modified.
     * @param cycles      ω_0 [1], at least 5: more tell frequencies apart, fewer moments
     */
    public MorletTransform(double rate, double[] frequencies, double cycles) {
        if (!(rate > 0) || Double.isInfinite(rate)) {
            throw new IllegalArgumentException("sampling rate must be > 0 Hz: " + rate);
        }
        for (double f : frequencies) {
            if (!(f > 0 && f <= rate / 2)) {
                throw new IllegalArgumentException("a frequency must be > 0 to " + rate / 2 + " Hz: " + f);
            }
        }
        if (!(cycles >= 5) || Double.isInfinite(cycles)) {
            throw new IllegalArgumentException("ω_0 of Morlet's wavelet must be >= 5, or it has a mean: " + cycles);
        }
        this.rate = rate;
        this.frequencies = frequencies.clone();
        this.cycles = cycles;
    }

    /**
     * A series of so many frequencies to an octave from one to another [Hz].
     *
     * @param from [Hz]
     * @param to [Hz]
     */
    public static double[] octaves(double from, double to, int perOctave) {
        if (!(from > 0 && to > from) || perOctave < 1) {
            throw new IllegalArgumentException("frequencies must rise from above 0 by at least 1 to an octave: " + from + " to "
                    + to);
        }
        int count = 1 + (int) Math.floor(perOctave * Math.log(to / from) / Math.log(2) + 1e-9);
        double[] f = new double[count];
        Arrays.setAll(f, i -> from * Math.pow(2, (double) i / perOctave));
        return f;
    }

    /**
     * The transform at every frequency and every sample.
     *
     * @param samples series of any unit, finite, at least two. Not modified.
     * @throws IllegalArgumentException if one is missing
     */
    public Scalogram of(double[] samples) {
        Record record = record(samples);
        ComplexSeries[] values = new ComplexSeries[frequencies.length];
        double[] influence = new double[frequencies.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = record.at(i);
            influence[i] = influence(i);
        }
        return new Scalogram(rate, frequencies, values, influence);
    }

    /** A record ready to be seen at one frequency after another, where all at once would fill the memory. @see #of */
    Record record(double[] samples) {
        for (int n = 0; n < samples.length; n++) {
            if (!Double.isFinite(samples[n])) {
                throw new IllegalArgumentException("a wavelet transform needs every sample: " + n + " is " + samples[n]);
            }
        }
        double slowest = Arrays.stream(frequencies).min().orElse(rate / 2);
        int silence = (int) Math.min(samples.length, Math.ceil(REACH * deviation(slowest) * rate));
        RealDft dft = new RealDft(RealDft.covering(samples.length + silence));
        return new Record(dft, dft.forward(samples, dft.length() / 2 + 1), samples.length);
    }

    /** How near an end of a record a value at a frequency is not to be trusted [s]. */
    double influence(int frequency) {
        return Math.sqrt(2) * deviation(frequencies[frequency]);
    }

    /** A record's lines. */
    final class Record {
        private final RealDft dft;
        private final double[] lines;
        private final int length;

        private Record(RealDft dft, double[] lines, int length) {
            this.dft = dft;
            this.lines = lines;
            this.length = length;
        }

        /** Its transform at one of the frequencies, one value a sample. */
        ComplexSeries at(int frequency) {
            return MorletTransform.this.at(frequencies[frequency], lines, dft, length);
        }
    }

    /** Standard deviation of the wavelet in time [s]. */
    private double deviation(double frequency) {
        return cycles / (2 * Math.PI * frequency);
    }

    /** The analytic signal of the record past a Gaussian band about the frequency. */
    private ComplexSeries at(double frequency, double[] x, RealDft dft, int length) {
        double[] real = new double[x.length];
        double[] quadrature = new double[x.length];
        double sd = deviation(frequency);
        int last = x.length / 2 - 1;
        for (int k = 1; k < last; k++) {
            double off = sd * 2 * Math.PI * (k * rate / dft.length() - frequency);
            double gain = Math.exp(-off * off / 2);
            real[2 * k] = gain * x[2 * k];
            real[2 * k + 1] = gain * x[2 * k + 1];
            quadrature[2 * k] = gain * x[2 * k + 1];    // times -j
            quadrature[2 * k + 1] = -gain * x[2 * k];
        }
        return new ComplexSeries(dft.inverse(real, length), dft.inverse(quadrature, length));
    }
}

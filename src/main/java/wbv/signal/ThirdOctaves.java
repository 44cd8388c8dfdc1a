package wbv.signal;

import java.util.function.DoubleUnaryOperator;

/**
 * A spectrum in one-third-octave bands (IEC 61260-1, base ten): r.m.s. values of the bands about {@code 10^(n/10)} Hz, each from
 * {@code 10^((n-½)/10)} to {@code 10^((n+½)/10)} Hz.
 *
 * @param first n of the first band
 * @param rms   as many as there are bands, of each in turn, in the signal's unit. Not copied.
 */
public record ThirdOctaves(int first, double[] rms) {

    private static final double[] NOMINAL = {1, 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8};
    private static final int LEAST_BINS = 2;

    /**
     * The bands that a power spectral density resolves: two bins wide at least, and whole below its last bin.
     *
     * @param density one-sided, of bins from 0 Hz on [unit²/Hz]. Not modified.
     * @param step    from bin to bin [Hz]
     * @param from    lowest frequency wanted [Hz]
     * @param to      highest frequency wanted [Hz]
     * @param gain    by frequency [Hz], with which the signal is weighted
     */
    public static ThirdOctaves of(double[] density, double step, double from, double to, DoubleUnaryOperator gain) {
        int first = (int) Math.ceil(10 * Math.log10(from) - 0.5);
        while (upper(first) - lower(first) < LEAST_BINS * step) {
            first++;
        }
        int last = (int) Math.floor(10 * Math.log10(Math.min(to, step * (density.length - 1))) + 0.5);
        while (upper(last) > step * (density.length - 1)) {
            last--;
        }
        double[] rms = new double[Math.max(0, last - first + 1)];
        for (int band = 0; band < rms.length; band++) {
            double low = lower(first + band);
            double high = upper(first + band);
            double power = 0;
            for (int k = (int) Math.floor(low / step); k <= Math.ceil(high / step) && k < density.length; k++) {
                double within = Math.min(high, (k + 0.5) * step) - Math.max(low, (k - 0.5) * step);
                if (within > 0) {
                    double factor = gain.applyAsDouble(Math.max(k * step, step / 2));
                    power += density[k] * factor * factor * within;
                }
            }
            rms[band] = Math.sqrt(power);
        }
        return new ThirdOctaves(first, rms);
    }

    /**
     * Centre of a band [Hz], exact.
     *
     * @param band counted from the first
     */
    public double centre(int band) {
        return Math.pow(10, (first + band) / 10.0);
    }

    /** Centres of all bands, as long as {@code rms} [Hz], exact. */
    public double[] centres() {
        double[] centres = new double[rms.length];
        for (int band = 0; band < centres.length; band++) {
            centres[band] = centre(band);
        }
        return centres;
    }

    /**
     * What a band is called [Hz]: 3.15 for 3.1623.
     *
     * @param band counted from the first
     */
    public double nominal(int band) {
        int n = first + band;
        int decade = Math.floorDiv(n, 10);
        double digits = NOMINAL[Math.floorMod(n, 10)];
        return decade < 0 ? digits / Math.pow(10, -decade) : digits * Math.pow(10, decade);
    }

    /** R.m.s. of all bands together, in their unit. */
    public double total() {
        double power = 0;
        for (double each : rms) {
            power += each * each;
        }
        return Math.sqrt(power);
    }

    private static double lower(int n) {
        return Math.pow(10, (n - 0.5) / 10);
    }

    private static double upper(int n) {
        return Math.pow(10, (n + 0.5) / 10);
    }
}

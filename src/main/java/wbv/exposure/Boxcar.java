package wbv.exposure;

/**
 * Undoes the droop of sensors that integrate: a strap-down sensor such as the Xsens MTw gives velocity increments, so that a
 * sample of acceleration is the mean over the sampling period and lacks {@code 1 - sinc(f/rate)} at a frequency f (17 % at a
 * third of the rate). The inverse holds up to 0.45 of the rate and stays there beyond, where it would raise noise only.
 */
final class Boxcar {

    private static final double HIGHEST = 0.45;
    private static final int REACH = 24;
    private static final int POINTS = 4096;

    private Boxcar() {}

    /**
     * Gain that undoes the droop at a frequency.
     *
     * @param part of the sampling rate, 0 to 0.5
     */
    static double gain(double part) {
        double x = Math.PI * Math.min(part, HIGHEST);
        return x == 0 ? 1 : x / Math.sin(x);
    }

    /** The same as a filter of linear phase for samples: 2 reach + 1 taps, symmetric. */
    static double[] taps() {
        double[] taps = new double[2 * REACH + 1];
        double sum = 0;
        for (int n = 0; n <= REACH; n++) {
            double integral = 0;
            for (int i = 0; i < POINTS; i++) {
                double part = 0.5 * (i + 0.5) / POINTS;
                integral += gain(part) * Math.cos(2 * Math.PI * part * n) / POINTS;
            }
            double taper = Math.cos(Math.PI * n / (2 * (REACH + 1)));
            taps[REACH + n] = integral * taper * taper;
            taps[REACH - n] = taps[REACH + n];
            sum += n == 0 ? taps[REACH] : 2 * taps[REACH + n];
        }
        for (int i = 0; i < taps.length; i++) {
            taps[i] /= sum; // a constant stays what it is
        }
        return taps;
    }

    /** Samples by which the filter comes late. */
    static int reach() {
        return REACH;
    }
}

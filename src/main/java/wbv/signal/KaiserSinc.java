package wbv.signal;

/**
 * A low-pass filter between two samples: a sinc tapered by Kaiser's window, split into phases.
 *
 * <p>Phase p interpolates at {@code p / phases} of the way from one input sample to the next. Every phase is scaled so that a
 * constant stays exactly what it is. Lengths follow Kaiser (1974): {@code β = 0.1102 (A - 8.7)},
 * {@code N = (A - 7.95) / (14.36 Δf)} taps for a transition Δf [cycles per tap] and a stop band A dB down.
 */
final class KaiserSinc {

    private final int reach;
    private final double[][] taps;

    /**
     * @param phases      positions between two input samples
     * @param passband    edge of the pass band [cycles per input sample], 0 to {@code stopband}
     * @param stopband    edge of the stop band [cycles per input sample]
     * @param attenuation of the stop band, and of the ripple in the pass band [dB], at least 21
     */
    KaiserSinc(int phases, double passband, double stopband, double attenuation) {
        double cutoff = (passband + stopband) / 2;
        double beta = attenuation > 50 ? 0.1102 * (attenuation - 8.7)
                : 0.5842 * Math.pow(attenuation - 21, 0.4) + 0.07886 * (attenuation - 21);
        this.reach = (int) Math.ceil((attenuation - 7.95) / (14.36 * (stopband - passband)) / 2);
        this.taps = new double[phases][2 * reach];
        for (int phase = 0; phase < phases; phase++) {
            double sum = 0;
            for (int i = 0; i < 2 * reach; i++) {
                // Tap i weighs the input sample that lies i - reach + 1 samples after the one before the output.
                double distance = i - reach + 1 - (double) phase / phases;
                double taper = besselI0(beta * Math.sqrt(Math.max(0, 1 - distance * distance / (reach * (double) reach))));
                taps[phase][i] = sinc(2 * cutoff * distance) * taper;
                sum += taps[phase][i];
            }
            for (int i = 0; i < 2 * reach; i++) {
                taps[phase][i] /= sum;
            }
        }
    }

    /** Input samples on either side of an output that have a part in it. */
    int reach() {
        return reach;
    }

    /** The weights of 2 reach input samples in time order. Not to be modified. */
    double[] phase(int phase) {
        return taps[phase];
    }

    private static double sinc(double x) {
        return x == 0 ? 1 : Math.sin(Math.PI * x) / (Math.PI * x);
    }

    /** Modified Bessel function of order 0 by its power series, which converges for every argument. */
    static double besselI0(double x) {
        double term = 1;
        double sum = 1;
        for (int k = 1; term > 1e-17 * sum; k++) {
            term *= x * x / (4.0 * k * k);
            sum += term;
        }
        return sum;
    }
}

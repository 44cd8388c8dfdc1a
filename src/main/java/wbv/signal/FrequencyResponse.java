package wbv.signal;

import java.util.Arrays;

/**
 * Frequency response from one input to one output, with what it is worth at every frequency.
 *
 * <p>With {@code G_ab = E[A B*]}: {@code H1 = G_yx/G_xx} (unbiased where only the output is noisy, else low),
 * {@code H2 = G_yy/G_xy} (unbiased where only the input is noisy, else high), {@code Hv = (G_yx/|G_yx|) sqrt(G_yy/G_xx)}
 * (unbiased where both have the same signal-to-noise ratio), {@code γ² = |G_yx|²/(G_xx G_yy)}. So |H1| = γ²|H2| and
 * |Hv|² = |H1||H2|. The relative random error of a modulus is {@code sqrt(1-γ²)/(γ sqrt(2 n_d))} (Bendat and Piersol, Random
 * Data, 2010, section 9.2).
 *
 * <p>Arrays are not copied, neither in nor out: treat them as read-only.
 *
 * @param frequency     bins from 0 Hz to half the sampling rate [Hz]
 * @param inputDensity  G_xx by bin [unit_x²/Hz]
 * @param outputDensity G_yy by bin [unit_y²/Hz]
 * @param h1            H1 [unit_y/unit_x]; NaN where the input has no power
 * @param h2            H2 [unit_y/unit_x]; NaN where the cross spectrum is zero
 * @param hv            Hv [unit_y/unit_x]; NaN where either is
 * @param coherence     γ² by bin, 0 to 1; 0 where a signal has no power
 * @param error         relative standard error of |H| by bin; infinite where the coherence is 0
 * @param backing       what backs the response, or what is missing, by the rule of {@link Excited}
 * @param averages      n_d, number of independent averages
 */
public record FrequencyResponse(double[] frequency, double[] inputDensity, double[] outputDensity, ComplexSeries h1,
        ComplexSeries h2, ComplexSeries hv, double[] coherence, double[] error, Backing[] backing,
        double averages) {

    /** Where the response may be used. */
    public boolean[] usable() {
        return Backing.usable(backing);
    }

    /**
     * When a bin may be used. The bins at and next to 0 Hz over which Hann's window spreads the mean or the trend never may (see
     * {@link Detrend}). Beside these two limits, an estimated coherence must be so high that the input is known to cause more than
     * half of the output: a true coherence of one half reaches it in less than 5 % of cases (see {@link CoherenceDistribution}).
     * From few averages that asks for more than the limit, from a single one no coherence is enough.
     *
     * @param coherence least coherence γ², 0 to 1: at 0.7, H1 and H2, between which the truth lies where the noise is on either
     *                  side, differ by 30 %
     * @param floor     least input density relative to its largest, 0 to 1: 1e-4 is 40 dB below
     */
    public record Excited(double coherence, double floor) {

        /** Coherence of at least 0.7, input density at most 40 dB below its peak. */
        public static final Excited USUAL = new Excited(0.7, 1e-4);
        /** What happens in fewer cases than this is ruled out. */
        static final double RARE = 0.05;
        private static final double HALF = 0.5;

        public Excited {
            if (!(coherence >= 0 && coherence <= 1)) {
                throw new IllegalArgumentException("least coherence must be 0 to 1: " + coherence);
            }
            if (!(floor >= 0 && floor <= 1)) {
                throw new IllegalArgumentException("least relative input density must be 0 to 1: " + floor);
            }
        }

        /** The least estimated coherence of an output with its inputs [1], from a number of averages. */
        public double leastCoherence(double averages, int inputs) {
            return averages > inputs ? Math.max(coherence, new CoherenceDistribution(averages, inputs).quantile(1 - RARE, HALF)) : 1;
        }
    }

    /** Hv of one input: root of H1 H2. Thesis: Eq. 2-24, 2-25. */
    static FrequencyResponse of(double[] frequency, double[] xx, double[] yy, ComplexSeries yx, double averages,
            int firstBin, Excited excited) {
        int bins = frequency.length;
        ComplexSeries h1 = new ComplexSeries(new double[bins], new double[bins]);
        ComplexSeries h2 = new ComplexSeries(new double[bins], new double[bins]);
        ComplexSeries hv = new ComplexSeries(new double[bins], new double[bins]);
        double[] coherence = new double[bins];
        double[] error = new double[bins];
        for (int k = 0; k < bins; k++) {
            double cross = yx.magnitude(k);
            scale(yx, k, 1 / xx[k], h1);
            scale(yx, k, yy[k] / (cross * cross), h2); // G_yy / G_xy = G_yy G_yx / |G_yx|²
            scale(yx, k, Math.sqrt(yy[k] / xx[k]) / cross, hv);
            coherence[k] = xx[k] > 0 && yy[k] > 0 ? Math.min(1, cross / xx[k] * (cross / yy[k])) : 0;
            error[k] = Math.sqrt((1 - coherence[k]) / coherence[k] / (2 * averages));
        }
        double[] own = new double[bins];
        Arrays.fill(own, 1);
        Judge judge = new Judge(averages, 1, firstBin, excited);
        Backing[] backing = judge.of(xx, yy, judge.noise(yy, coherence, xx), coherence, own, 0);
        return new FrequencyResponse(frequency, xx, yy, h1, h2, hv, coherence, error, backing, averages);
    }

    private static void scale(ComplexSeries from, int k, double factor, ComplexSeries to) {
        boolean defined = Double.isFinite(factor);
        to.re()[k] = defined ? from.re()[k] * factor : Double.NaN;
        to.im()[k] = defined ? from.im()[k] * factor : Double.NaN;
    }
}

package wbv.signal;

/**
 * Power that a body takes in at its driving point, over frequency: {@code P(f) = Re G_Fv} [W/Hz], one-sided, with its sign. It is
 * positive where energy goes into the body and stays there; its integral is the mean of force times velocity.
 *
 * <p>From force and acceleration, since {@code V = A/(jω)}: {@code Re E[F V*] = -Im E[F A*] / ω}. A rigid mass absorbs nothing,
 * so that a plate under the sitter needs no correction. Arrays are not copied: treat them as read-only.
 *
 * @param frequency by bin, rising in equal steps [Hz]
 * @param density   by frequency [W/Hz]; 0 in the lowest bins, which hold what is left of means and trends
 */
public record AbsorbedPower(double[] frequency, double[] density) {

    public AbsorbedPower {
        if (frequency.length != density.length || frequency.length < 2) {
            throw new IllegalArgumentException("as many densities as frequencies, at least 2: " + density.length + " and "
                    + frequency.length);
        }
    }

    /**
     * The power that spectra hold.
     * Thesis: Eq. 2-8.
     *
     * @param force        channel [N], along the acceleration, as it acts on the body
     * @param acceleration channel [m/s²]
     */
    public static AbsorbedPower of(SpectralMatrix spectra, int force, int acceleration) {
        double[] frequency = spectra.segmentation().frequencies();
        double[] quadrature = spectra.cross(force, acceleration).im();
        double[] density = new double[frequency.length];
        for (int k = spectra.detrend().firstBin(); k < density.length; k++) {
            density[k] = -quadrature[k] / (2 * Math.PI * frequency[k]);
        }
        return new AbsorbedPower(frequency, density);
    }

    /** All of it [W]. Thesis: Eq. 2-7. */
    public double total() {
        return between(0, Double.POSITIVE_INFINITY);
    }

    /**
     * Power of the bins from one frequency to another, both included [W].
     *
     * @param from [Hz]
     * @param to [Hz]
     */
    public double between(double from, double to) {
        double sum = 0;
        for (int k = 0; k < density.length; k++) {
            sum += frequency[k] >= from && frequency[k] <= to ? density[k] : 0;
        }
        return sum * (frequency[1] - frequency[0]);
    }

    /** Power up to each frequency [W], by frequency. */
    public double[] cumulative() {
        double[] sums = new double[density.length];
        double sum = 0;
        for (int k = 0; k < density.length; k++) {
            sum += density[k] * (frequency[1] - frequency[0]);
            sums[k] = sum;
        }
        return sums;
    }
}

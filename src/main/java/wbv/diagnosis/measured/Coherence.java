package wbv.diagnosis.measured;

import wbv.signal.CrossSpectrum;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse;
import wbv.signal.Segmentation;

/**
 * How much of one series goes with another, averaged over frequency, without what chance gives: of n independent segments that have nothing
 * to do with each other the coherence is 1/n in the mean and (n-1)/(n²(n+1)) in variance (Bendat and Piersol, Random Data, 2010, section
 * 9.2.3).
 *
 * @param share 1 for all, 0 in the mean where there is no relation, then below 0 as often as above
 * @param deviation standard deviation of the share where there is no relation
 */
public record Coherence(double share, double deviation) {

    /** Of what was too short to tell: less than any other. */
    public static final Coherence NONE = new Coherence(Double.NEGATIVE_INFINITY, 0);

    /** Longest and shortest segments, in samples. */
    private static final int LONGEST = 256;
    private static final int SHORTEST = 64;
    /** Independent segments below which shorter ones are taken. */
    private static final double FEWEST = 12;
    /** Deviations that no chance reaches: the distribution leans to high shares, and the best of several outputs is asked. */
    private static final double SURE = 6;
    /** Squared correlation of Hann-windowed bins with the next and the one after. */
    private static final double[] NEIGHBOURS = {1, 4.0 / 9, 1.0 / 36};

    /** The first bin that the mean of a segment does not spread over. */
    private static final int FIRST = 2;

    /** By what frequencies count. */
    public enum Weight {
        /** By how strong the first series is there. */
        INPUT,
        /** By how strong the second is. */
        OUTPUT
    }

    /**
     * How much of y goes with x; {@link #NONE} where two segments do not fit in.
     *
     * @param rate [Hz]
     * @param x a series without gaps, in its own unit. Not modified.
     * @param y a series as long, in its own unit. Not modified.
     */
    public static Coherence of(double rate, double[] x, double[] y, Weight weight) {
        return of(rate, x, y, weight, LONGEST);
    }

    /**
     * The same of other segments: of what rings for long, long ones tell.
     *
     * @param rate [Hz]
     * @param x a series without gaps, in its own unit. Not modified.
     * @param y a series as long, in its own unit. Not modified.
     * @param longest samples of a segment at most, a power of two
     */
    public static Coherence of(double rate, double[] x, double[] y, Weight weight, int longest) {
        CrossSpectrum spectra = new CrossSpectrum(new Segmentation(rate, segment(rate, x.length, longest), 0.5), Detrend.MEAN, 1);
        for (int i = 0; i < x.length; i++) {
            spectra.accept(x[i], y[i]);
        }
        if (spectra.averaged(0) < 2) {
            return NONE;
        }
        FrequencyResponse response = spectra.response(0, FrequencyResponse.Excited.USUAL);
        double n = response.averages();
        double[] weights = weight == Weight.INPUT ? response.inputDensity() : response.outputDensity();
        double sum = 0;
        double total = 0;
        double square = 0;
        for (int k = FIRST; k < weights.length; k++) {
            sum += weights[k] * (response.coherence()[k] - 1 / n) / (1 - 1 / n);
            total += weights[k];
            for (int apart = 0; apart < NEIGHBOURS.length && k + apart < weights.length; apart++) {
                square += (apart == 0 ? 1 : 2) * NEIGHBOURS[apart] * weights[k] * weights[k + apart];
            }
        }
        double scatter = Math.sqrt((n - 1) / (n * n * (n + 1))) / (1 - 1 / n);
        return total > 0 ? new Coherence(sum / total, scatter * Math.sqrt(square) / total) : NONE;
    }

    /**
     * Samples of a segment of which enough fit in.
     *
     * @param rate [Hz]
     * @param samples of the series
     * @param longest samples of a segment at most, a power of two
     */
    public static int segment(double rate, int samples, int longest) {
        int length = longest;
        while (length > SHORTEST && new Segmentation(rate, length, 0.5).independent(2L * samples / length - 1) < FEWEST) {
            length /= 2;
        }
        return length;
    }

    /** The share from which on there is a relation. */
    public double sure() {
        return SURE * deviation;
    }

    /** Whether there is a relation. */
    public boolean isSure() {
        return share > sure();
    }
}

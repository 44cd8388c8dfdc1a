package wbv.identify;

import wbv.signal.Backing;
import wbv.signal.Detrend;
import wbv.signal.FrequencyResponse.Excited;
import wbv.signal.ResponseMatrix;
import wbv.signal.Segmentation;
import wbv.signal.SpectralMatrix;

/**
 * Which frequencies a recording tells of: those at which an input has power that the output follows, by the rule of frequency
 * responses ({@link Excited}). A model has poles elsewhere too, since it has a number of them; nothing made them move.
 */
public final class ExcitedBand {

    /** Segments for each input, overlapping by half, and the shortest that one may be [samples]: as of a frequency response. */
    private static final int LEAST_SEGMENTS = 4;
    private static final int SHORTEST = 8;

    private final Segmentation segmentation;
    private final boolean[] follows;
    private final int first;
    private final int last;

    private ExcitedBand(Segmentation segmentation, boolean[] follows) {
        this.segmentation = segmentation;
        this.follows = follows;
        int low = follows.length;
        int high = -1;
        for (int k = 0; k < follows.length; k++) {
            if (follows[k]) {
                low = Math.min(low, k);
                high = k;
            }
        }
        first = low;
        last = high;
    }

    /** Of samples. */
    public static ExcitedBand of(Samples samples) {
        int m = samples.inputs();
        Segmentation segmentation = Segmentation.ofSitter(samples.rate(), samples.length(), LEAST_SEGMENTS * m, SHORTEST);
        SpectralMatrix spectra = new SpectralMatrix(segmentation, Detrend.MEAN, m + 1);
        double[] row = new double[m + 1];
        for (int k = 0; k < samples.length(); k++) {
            for (int i = 0; i < m; i++) {
                row[i] = samples.u()[i][k];
            }
            row[m] = samples.y()[k];
            spectra.accept(row);
        }
        boolean[] follows = new boolean[segmentation.bins()];
        if (spectra.independent() > m) {
            ResponseMatrix response = ResponseMatrix.of(spectra, m, Excited.USUAL);
            for (int i = 0; i < m; i++) {
                Backing[] backing = response.backing(0, i);
                for (int k = 0; k < follows.length; k++) {
                    follows[k] |= backing[k] == Backing.USABLE;
                }
            }
        }
        return new ExcitedBand(segmentation, follows);
    }

    /** Whether the output follows an input anywhere. */
    public boolean exists() {
        return last >= 0;
    }

    /** The lowest frequency at which the output follows [Hz]; NaN if there is none. */
    public double from() {
        return exists() ? segmentation.frequency(first) : Double.NaN;
    }

    /** The highest frequency at which the output follows [Hz]; NaN if there is none. */
    public double to() {
        return exists() ? segmentation.frequency(last) : Double.NaN;
    }

    /**
     * Whether the recording can tell of a mode: the output follows an input somewhere within its half-power band,
     * f (1 ± damping ratio), or at the frequency nearest to it.
     *
     * @param frequency natural frequency [Hz]
     * @param damping   ratio
     */
    public boolean holds(double frequency, double damping) {
        double bin = segmentation.rate() / segmentation.length();
        double reach = Math.max(bin / 2, damping * frequency);
        int low = Math.max(0, (int) Math.ceil((frequency - reach) / bin));
        int high = Math.min(follows.length - 1, (int) Math.floor((frequency + reach) / bin));
        for (int k = low; k <= high; k++) {
            if (follows[k]) {
                return true;
            }
        }
        return false;
    }
}

package wbv.signal;

import java.util.Arrays;

/**
 * Auto and cross spectra of several channels together, averaged over segments as they pass (Welch 1967): at every bin a
 * Hermitian matrix {@code G_ij = E[X_i X_j*]}, one-sided, [unit_i unit_j / Hz].
 *
 * <p>A segment in which any channel lacks a sample (NaN) is left out and counted, so that every entry comes from the same
 * segments and the matrix cannot contradict itself. With a memory, each segment makes the earlier ones weigh less, so that the
 * average follows what changes. Memory does not grow, and nothing is allocated for a sample.
 */
public final class SpectralMatrix {

    private final Segmentation segmentation;
    private final Detrend detrend;
    private final double memory;
    private final Segments[] channels;
    private final double[][] spectra;
    private final double[][] re;
    private final double[][] im;
    private double weight;
    private double squares;
    private long averaged;
    private long skipped;

    /**
     * An average in which all segments weigh the same.
     *
     * @param channels at least 1
     */
    public SpectralMatrix(Segmentation segmentation, Detrend detrend, int channels) {
        this(segmentation, detrend, channels, 1);
    }

    /**
     * Averages of no segment yet.
     *
     * @param memory factor: what a segment weighs after the next one over what it weighed before, &gt; 0 to 1; 1 forgets nothing
     */
    public SpectralMatrix(Segmentation segmentation, Detrend detrend, int channels, double memory) {
        if (channels < 1) {
            throw new IllegalArgumentException("a spectral matrix needs at least 1 channel: " + channels);
        }
        if (!(memory > 0 && memory <= 1)) {
            throw new IllegalArgumentException("memory of a segment must be > 0 to 1: " + memory);
        }
        this.segmentation = segmentation;
        this.detrend = detrend;
        this.memory = memory;
        this.channels = new Segments[channels];
        Arrays.setAll(this.channels, i -> new Segments(segmentation, detrend));
        this.spectra = new double[channels][];
        this.re = new double[channels * (channels + 1) / 2][segmentation.bins()];
        this.im = new double[re.length][segmentation.bins()];
    }

    /**
     * Takes the next sample of every channel; NaN is missing.
     *
     * @param values one a channel, in its own unit. Not modified.
     * @return whether a segment was added to the average
     */
    public boolean accept(double[] values) {
        if (values.length != channels.length) {
            throw new IllegalArgumentException(values.length + " values for " + channels.length + " channels");
        }
        boolean due = false;
        for (int i = 0; i < channels.length; i++) {
            due = channels[i].accept(values[i]);
        }
        if (!due) {
            return false;
        }
        for (Segments channel : channels) {
            if (!channel.whole()) {
                skipped++;
                return false;
            }
        }
        add();
        return true;
    }

    /**
     * The average as it would be had a channel passed a filter first. What is taken in later goes to this matrix, not to that.
     *
     * @param factor what the filter makes of each bin. Not modified.
     */
    public SpectralMatrix filtered(int channel, ComplexSeries factor) {
        SpectralMatrix other = new SpectralMatrix(segmentation, detrend, channels.length, memory);
        for (int i = 0; i < channels.length; i++) {
            for (int j = 0; j <= i; j++) {
                int at = index(i, j);
                for (int k = 0; k < segmentation.bins(); k++) {
                    double a = factor.re()[k];
                    double b = i == channel ? factor.im()[k] : -factor.im()[k];   // G_ij = E[X_i X_j*]
                    boolean twice = i == channel && j == channel;
                    boolean once = !twice && (i == channel || j == channel);
                    double square = twice ? a * a + b * b : 1;
                    other.re[at][k] = once ? a * re[at][k] - b * im[at][k] : square * re[at][k];
                    other.im[at][k] = once ? a * im[at][k] + b * re[at][k] : square * im[at][k];
                }
            }
        }
        other.weight = weight;
        other.squares = squares;
        other.averaged = averaged;
        other.skipped = skipped;
        return other;
    }

    /** The average of some of the channels alone, in the order named. What is taken in later goes to this matrix, not to that. */
    public SpectralMatrix only(int... chosen) {
        SpectralMatrix other = new SpectralMatrix(segmentation, detrend, chosen.length, memory);
        for (int i = 0; i < chosen.length; i++) {
            for (int j = 0; j <= i; j++) {
                int at = index(Math.max(chosen[i], chosen[j]), Math.min(chosen[i], chosen[j]));
                double sign = chosen[i] >= chosen[j] ? 1 : -1;   // G_ji = G_ij*
                other.re[index(i, j)] = re[at].clone();
                other.im[index(i, j)] = Arrays.stream(im[at]).map(value -> sign * value).toArray();
            }
        }
        other.weight = weight;
        other.squares = squares;
        other.averaged = averaged;
        other.skipped = skipped;
        return other;
    }

    private void add() {
        for (int i = 0; i < channels.length; i++) {
            spectra[i] = channels[i].spectrum();
        }
        boolean forgets = memory < 1;
        for (int i = 0; i < channels.length; i++) {
            for (int j = 0; j <= i; j++) {
                double[] sumRe = re[index(i, j)];
                double[] sumIm = im[index(i, j)];
                if (forgets) {
                    scale(sumRe, memory);
                    scale(sumIm, memory);
                }
                if (i == j) {
                    Segments.addPower(spectra[i], sumRe);
                } else {
                    Segments.addProduct(spectra[i], spectra[j], sumRe, sumIm);
                }
            }
        }
        weight = memory * weight + 1;
        squares = memory * memory * squares + 1;
        averaged++;
    }

    private static void scale(double[] values, double factor) {
        for (int k = 0; k < values.length; k++) {
            values[k] *= factor;
        }
    }

    /** Place of entry (i, j), j not above i, among the sums. */
    private static int index(int i, int j) {
        return i * (i + 1) / 2 + j;
    }

    /** How samples are cut into segments. */
    public Segmentation segmentation() {
        return segmentation;
    }

    /** What is taken away from each segment. */
    public Detrend detrend() {
        return detrend;
    }

    /** Number of channels. */
    public int channels() {
        return channels.length;
    }

    /** Segments averaged so far, those nearly forgotten included. */
    public long averaged() {
        return averaged;
    }

    /** Segments left out because a sample was missing. */
    public long skipped() {
        return skipped;
    }

    /** n_d: the number of independent segments of one weight that would scatter as much as the average does. */
    public double independent() {
        return averaged == 0 ? 0 : segmentation.independent(Math.round(weight * weight / squares));
    }

    /** Power spectral density of a channel, by bin [unit²/Hz]; NaN before the first whole segment. */
    public double[] density(int channel) {
        return scaled(re[index(channel, channel)], 1);
    }

    /** Cross spectral density {@code G_ij = E[X_i X_j*]} [unit_i unit_j / Hz]; NaN before the first whole segment. */
    public ComplexSeries cross(int i, int j) {
        int at = i >= j ? index(i, j) : index(j, i);
        return new ComplexSeries(scaled(re[at], 1), scaled(im[at], i >= j ? 1 : -1));
    }

    /**
     * Power spectral density of what each channel shares with none of the others, by channel and bin [unit²/Hz]: what is left of it when
     * all of them are taken out, over what is left of noise (Bendat and Piersol, Random Data, 2010, section 7.3). NaN where the others
     * leave nothing, or there are too few independent segments to tell.
     */
    public double[][] unshared() {
        Hermitian matrix = new Hermitian(channels.length);
        double free = independent() - channels.length + 1;
        double scale = Segments.densityScale(segmentation) / weight * independent() / free;
        double[][] out = new double[channels.length][segmentation.bins()];
        for (int k = 0; k < segmentation.bins(); k++) {
            for (int i = 0; i < channels.length; i++) {
                for (int j = 0; j <= i; j++) {
                    matrix.set(i, j, re[index(i, j)][k], im[index(i, j)][k]);
                }
            }
            boolean told = free >= 1 && matrix.invert();
            for (int i = 0; i < channels.length; i++) {
                out[i][k] = told ? scale / matrix.inverseRe(i, i) : Double.NaN;
            }
        }
        return out;
    }

    private double[] scaled(double[] sums, double sign) {
        double scale = sign * Segments.densityScale(segmentation) / weight;
        return Arrays.stream(sums).map(sum -> sum * scale).toArray();
    }
}

package wbv.diagnosis.measured;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.signal.Fft;
import wbv.signal.LostSamples;

/**
 * How noisy a sensor is, from the band above the excitation (0.25 to 0.37 of the sampling rate): the median over blocks, since the
 * quietest block would be too low and the mean would count every bump. Where sensors show in that band that they move together, what they
 * share is no noise.
 */
public final class NoiseLevel {

    private static final int BLOCK = 512;
    private static final double LOW = 0.25;
    private static final double HIGH = 0.37;
    private static final double BAND = 0.025;
    /**
     * Standard deviations by which one band may be louder than the quietest and still hold no more than noise: by chance one of thirty
     * thousand is louder, and any of thirteen once in two thousand times.
     */
    static final double ALIKE = 4;
    /**
     * How many neighbouring lines under a Hann window scatter as much as one by itself: 1 + 2 (4/9 + 1/36), by the correlation of their
     * powers.
     */
    private static final double HANN = 1.944;
    /** Part of a block that may be lost [1]: what is bridged takes as much of the noise's power. */
    private static final double BRIDGED = 0.02;
    /** Standard deviation of a median over that of a mean. */
    private static final double MEDIAN = 1.2533;

    /** Standard deviation of a sample, the median over the axes of a place, in the channels' unit. */
    public double ofPlace(Recording recording, Channel channel) {
        List<Double> levels = new ArrayList<>();
        for (Channel other : recording.channels()) {
            if (other.location().equals(channel.location()) && other.quantity() == channel.quantity()) {
                levels.add(of(recording.values(other)));
            }
        }
        levels.removeIf(level -> !(level > 0));   // an axis that was not recorded
        if (levels.isEmpty()) {
            throw new DataFault(String.format(Locale.ROOT,
                    "%s has no noise between %.3g and %.3g Hz that others could be judged by: was it recorded "
                            + "whole, and with its own rounding? say how noisy it is (--noise)",
                    channel, LOW * recording.clock().rate(),
                    HIGH * recording.clock().rate()));
        }
        return median(levels.stream().mapToDouble(Double::doubleValue).toArray());
    }

    /**
     * Standard deviation of a sample of sensors of one kind, where the band above the excitation is not free of motion; no number where it
     * is.
     *
     * @param series the input's and what other sensors of its kind measured along the same axis, without gaps. Not modified.
     */
    OptionalDouble ofWhatIsNotShared(double[][] series) {
        return series.length < 2 ? OptionalDouble.empty() : new Unshared(series, LOW, HIGH, BAND).level();
    }

    /**
     * Standard deviation of a sample, if its noise is white.
     *
     * @param x NaN where lost. Not modified.
     */
    double of(double[] x) {
        return between(LostSamples.filled(x), LOW, HIGH, BLOCK, starts(x, BLOCK));
    }

    /**
     * Standard deviation of a sample where no band is known to be free of excitation: white noise is no stronger than the quietest band,
     * and no weaker than the rounding of the values. Bands that differ from the quietest by no more than chance
     * are one noise.
     *
     * @param x by sample [unit of the channel], NaN where lost. Not modified.
     */
    public double bound(double[] x) {
        return Math.max(quietest(x), rounding(x) / Math.sqrt(12));
    }

    /**
     * The same where a part of what was measured is known: what is left of it is noise and whatever else is not known.
     *
     * @param x by sample [unit of the channel], NaN where lost. Not modified.
     * @param left what is left of it, likewise. Not modified.
     */
    double bound(double[] x, double[] left) {
        return Math.min(bound(x), Math.max(quietest(left), rounding(x) / Math.sqrt(12)));
    }

    /** That of the quietest band and of all that are no louder than chance makes bands of one noise. */
    private static double quietest(double[] x) {
        int block = Math.min(BLOCK, Integer.highestOneBit(Math.max(8, x.length / 4)));
        double[] bridged = LostSamples.filled(x);
        int[] starts = starts(x, block);
        List<Double> powers = new ArrayList<>();
        for (double low = BAND; low + BAND <= HIGH; low += BAND) {
            powers.add(Math.pow(between(bridged, low, low + BAND, block, starts), 2));
        }
        double lines = Math.max(1, BAND * block) / HANN;
        double scatter = MEDIAN / Math.sqrt(lines * starts.length);
        double median = Math.pow(1 - 1 / (9 * lines), 3);   // of a power that so many lines make, over its mean (Wilson and Hilferty 1931)
        double loudest = Collections.min(powers) * (1 + ALIKE * scatter);
        return Math.sqrt(powers.stream().mapToDouble(power -> power).filter(power -> power <= loudest).average().orElseThrow() / median);
    }

    /** The least difference between two neighbouring samples that differ. */
    private static double rounding(double[] x) {
        double least = Double.POSITIVE_INFINITY;
        double largest = 0;
        for (int i = 1; i < x.length; i++) {
            double step = Math.abs(x[i] - x[i - 1]);
            largest = Double.isNaN(x[i]) ? largest : Math.max(largest, Math.abs(x[i]));
            least = step > 1e-12 * largest ? Math.min(least, step) : least;
        }
        return Double.isInfinite(least) ? 0 : least;
    }

    /**
     * Where blocks that count begin: those in which much is lost do not where others do.
     *
     * @param read NaN where lost. Not modified.
     */
    private static int[] starts(double[] read, int size) {
        int[] all = IntStream.iterate(0, start -> start + size <= read.length, start -> start + size / 2).toArray();
        int[] whole = IntStream.of(all).filter(start -> isWhole(read, start, size)).toArray();
        return whole.length > 0 ? whole : all;
    }

    /**
     * @param x with its gaps bridged
     * @param starts of blocks that count. Neither is modified.
     */
    private static double between(double[] x, double low, double high, int size, int[] starts) {
        Fft fft = new Fft(size);
        double[] weights = new double[size];
        double power = 0;
        for (int i = 0; i < size; i++) {
            weights[i] = 0.5 - 0.5 * Math.cos(2 * Math.PI * i / size);
            power += weights[i] * weights[i];
        }
        List<Double> blocks = new ArrayList<>();
        for (int start : starts) {
            double[] block = Arrays.copyOfRange(x, start, start + size);
            double mean = Arrays.stream(block).average().orElse(0);
            for (int i = 0; i < size; i++) {
                block[i] = (block[i] - mean) * weights[i];
            }
            fft.forward(block);
            double sum = 0;
            int lines = 0;
            for (int k = (int) Math.ceil(low * size); k <= (int) (high * size); k++) {
                sum += (block[2 * k] * block[2 * k] + block[2 * k + 1] * block[2 * k + 1]) / power;
                lines++;
            }
            if (!Double.isNaN(sum)) {
                blocks.add(sum / lines);
            }
        }
        return Math.sqrt(median(blocks.stream().mapToDouble(Double::doubleValue).toArray()));
    }

    /** Whether what bridges a block's gaps, which has no noise, makes little of it. */
    private static boolean isWhole(double[] read, int start, int size) {
        return Arrays.stream(read, start, start + size).filter(Double::isNaN).count() <= BRIDGED * size;
    }

    private static double median(double[] values) {
        Arrays.sort(values);
        int n = values.length;
        return n == 0 ? Double.NaN : n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
    }
}

package wbv.study;

import java.util.Arrays;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.signal.WaveletResponse;

/** The samples of one input and its outputs, kept whole for a response that is followed through time. */
final class Waves {

    /** Samples of one channel that are kept, at most: a day at 60 Hz (5.2 million), 50 MB a channel. */
    private static final long MOST = 6_000_000;
    /** Moments that a picture shows. */
    private static final int COLUMNS = 300;
    /** Frequencies that a picture shows [Hz]: a sitter's resonances, by less than the wavelet tells apart. */
    private static final double FIRST = 1;
    private static final double LAST = 16;
    private static final double STEP = 0.25;

    private final double[][] samples;
    private int count;

    /**
     * @param channels the input first
     * @param length of the recording in samples
     */
    Waves(int channels, long length) {
        if (length > MOST) {
            throw new DataFault("a response can be followed through " + MOST + " samples at most, not " + length
                    + "; cut the recording, or leave out --wavelet");
        }
        samples = new double[channels][(int) length];
    }

    void accept(double[] values) {
        for (int c = 0; c < samples.length && count < samples[c].length; c++) {
            samples[c][count] = values[c];
        }
        count++;
    }

    /** From the first channel to another, 1 to 16 Hz or to 0.4 of the rate. */
    WaveletResponse response(int channel, Clock clock) {
        int length = Math.min(count, samples[0].length);
        int last = (int) Math.floor((Math.min(LAST, 0.4 * clock.rate()) - FIRST) / STEP);
        double[] frequencies = new double[Math.max(2, last + 1)];
        Arrays.setAll(frequencies, k -> FIRST + k * STEP);
        return WaveletResponse.of(clock.rate(), clock.start(), without(samples[0], length), without(samples[channel], length), frequencies,
                Math.max(2, Math.min(COLUMNS, length / 8)));
    }

    /** Less their mean, which no wavelet sees but every missing sample would. */
    private static double[] without(double[] values, int length) {
        double mean = Arrays.stream(values, 0, length).filter(Double::isFinite).average().orElse(0);
        return Arrays.stream(values, 0, length).map(value -> value - mean).toArray();
    }
}

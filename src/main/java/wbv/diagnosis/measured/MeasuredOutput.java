package wbv.diagnosis.measured;

import java.util.Arrays;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/**
 * What was measured at an output of a model, and which samples of it count.
 *
 * @param channel of its sensor
 * @param series by sample, gaps bridged, of a sitter without its mean [unit of the channel]. Not a copy
 * @param mean what was taken from the series, in its unit
 * @param valid samples that count. Not a copy
 * @param repeated samples in which the whole sensor repeats itself or reads zero
 */
record MeasuredOutput(Channel channel, double[] series, double mean, boolean[] valid, int repeated) {

    MeasuredOutput {
        if (series.length != valid.length) {
            throw new IllegalArgumentException(channel + ": " + series.length + " samples, of which " + valid.length + " may count");
        }
    }

    /**
     * On a rig constants count, and rounded values of a slow stroke repeat without being lost.
     *
     * @param driven samples in which it answers to its input. Not modified.
     */
    static MeasuredOutput onRig(Recording recording, Channel channel, boolean[] driven) {
        double[] raw = recording.values(channel);
        boolean[] valid = present(raw);
        for (int i = 0; i < valid.length; i++) {
            valid[i] &= driven[i];
        }
        return new MeasuredOutput(channel, LostSamples.filled(raw), 0, valid, 0);
    }

    /**
     * Of a sitter: neither what its sensor lost counts, nor what it read while the input was not known.
     *
     * @param recorded as it was read
     * @param slowed the same at a sitter's rate, in which what was lost is missing already
     * @param driven samples of the latter in which the input is known. Not modified.
     */
    static MeasuredOutput ofSitter(Recording recorded, Recording slowed, Channel channel, boolean[] driven) {
        double[] raw = slowed.values(channel);
        Dropouts dropouts = new Dropouts(recorded, channel);
        boolean[] valid = slowed == recorded ? dropouts.valid() : present(raw);
        for (int i = 0; i < valid.length; i++) {
            valid[i] &= driven[i];
        }
        double[] counted = LostSamples.marked(raw, valid);
        return new MeasuredOutput(channel, LostSamples.centred(counted), LostSamples.mean(counted), valid, dropouts.found());
    }

    /** The series by sample [unit of the channel], NaN where it does not count: a new array. */
    double[] read() {
        return LostSamples.marked(series, valid);
    }

    private static boolean[] present(double[] x) {
        boolean[] out = new boolean[x.length];
        for (int i = 0; i < x.length; i++) {
            out[i] = !Double.isNaN(x[i]);
        }
        return out;
    }

    /** A stretch of it; what is known of the whole stays known. */
    MeasuredOutput part(int from, int to) {
        return new MeasuredOutput(channel, Arrays.copyOfRange(series, from, to), mean, Arrays.copyOfRange(valid, from, to), repeated);
    }
}

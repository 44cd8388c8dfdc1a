package wbv.diagnosis.measured;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.signal.BandlimitedResampler;
import wbv.signal.LostSamples;

/**
 * Brings a fast recording of a sitter to about 60 Hz. What a sitter does lies below 22 Hz: faster samples show no more of it, only more
 * noise beside it, and take longer.
 */
public final class SitterRate {

    /** Samples a second of a sitter that are judged at most [Hz]. */
    static final double USUAL = 60;
    /** What is hardly faster stays as it is. */
    private static final double FAST = 1.1;
    private static final int MOST = 64;
    /** By how much the rate may be another than the usual one. */
    private static final double NEARLY = 0.02;
    /** Part of the samples about a moment that may be lost. */
    private static final double LOST = 0.25;

    private SitterRate() {}

    /** The recording at the usual rate, lost samples NaN; itself where it is no faster. */
    public static Recording usual(Recording recording) {
        double rate = recording.clock().rate();
        if (rate <= FAST * USUAL) {
            return recording;
        }
        int up = 1;
        while (up < MOST && Math.abs(rate * up / down(rate, up) / USUAL - 1) > NEARLY) {
            up++;
        }
        int down = down(rate, up);
        Map<Channel, double[]> slow = new LinkedHashMap<>();
        for (Channel channel : recording.channels()) {
            slow.put(channel, slowed(recording.values(channel), new Dropouts(recording, channel).valid(), up, down));
        }
        return recording.at(rate * up / down, slow);
    }

    private static int down(double rate, int up) {
        return (int) Math.round(rate * up / USUAL);
    }

    /** @param valid samples that count. Neither is modified. */
    private static double[] slowed(double[] x, boolean[] valid, int up, int down) {
        double[] counted = LostSamples.marked(x, valid);
        double[] out = BandlimitedResampler.resample(LostSamples.filled(counted), up, down);
        for (int k = 0; k < out.length; k++) {
            int from = Math.max(0, (int) Math.ceil((double) (k - 1) * down / up));
            int to = Math.min(x.length, (int) Math.floor((double) (k + 1) * down / up) + 1);
            long lost = Arrays.stream(counted, from, to).filter(Double::isNaN).count();
            out[k] = lost > LOST * (to - from) ? Double.NaN : out[k];
        }
        return out;
    }
}

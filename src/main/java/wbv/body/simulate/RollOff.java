package wbv.body.simulate;

import java.util.Arrays;
import java.util.List;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.signal.Detrend;
import wbv.signal.Segmentation;
import wbv.signal.SpectralMatrix;

/**
 * How the sensors' anti-alias filter rolls off, read from their own noise, which is what a sensor shares with no other: white inside, it
 * falls as the filter does, whether the excitation ends there or not. Base and outputs pass the same filter, so it cancels in what is
 * linear; what a law adds inside the body has to pass it too.
 */
final class RollOff {

    /** Samples of a segment: a filter is no finer, and shorter ones are the more to average. */
    private static final int SEGMENT = 128;
    private static final int BINS = SEGMENT / 2 + 1;
    private static final double FROM = 0.25;
    private static final double FLAT = 0.37;
    /** Bins on either side of one that are averaged with it. */
    private static final int ABOUT = 1;

    private final double[] gain;

    private RollOff(double[] gain) {
        this.gain = gain;
    }

    /**
     * As half of the sensors of one quantity show it at least: one that hears more than its noise there shows less of it, and one in whose
     * noise something of the excitation is left shows more. No filter at all where the recording is too short to tell.
     */
    static RollOff of(Recording recording, Channel input) {
        List<double[]> series = recording.channels().stream().filter(channel -> channel.quantity() == input.quantity())
                .map(recording::values).filter(values -> Arrays.stream(values).anyMatch(value -> value != values[0])).toList();
        double[] gain = new double[BINS];
        Arrays.fill(gain, 1);
        if (series.isEmpty()) {
            return new RollOff(gain);
        }
        SpectralMatrix spectra = new SpectralMatrix(new Segmentation(recording.clock().rate(), SEGMENT, 0.5), Detrend.MEAN, series.size());
        double[] row = new double[series.size()];
        for (int i = 0; i < recording.length(); i++) {
            int at = i;
            Arrays.setAll(row, c -> series.get(c)[at]);
            spectra.accept(row);
        }
        double[][] noise = Arrays.stream(spectra.unshared()).filter(own -> mean(own, FROM, FLAT) > 0)
                .toArray(double[][]::new);
        for (int k = (int) (FLAT * SEGMENT); k < BINS && noise.length > 0; k++) {
            int from = Math.max(0, k - ABOUT);
            int to = Math.min(BINS, k + ABOUT + 1);
            double[] parts = Arrays.stream(noise)
                    .mapToDouble(own -> Arrays.stream(own, from, to).average().orElse(1) / mean(own, FROM, FLAT)).sorted().toArray();
            double near = (parts[parts.length / 2] + parts[(parts.length - 1) / 2]) / 2;
            gain[k] = near >= 0 ? Math.sqrt(Math.min(1, near)) : 1;
        }
        return new RollOff(gain);
    }

    private static double mean(double[] density, double from, double to) {
        return Arrays.stream(density, (int) (from * SEGMENT), (int) (to * SEGMENT)).average().orElse(0);
    }

    /** The filter's gain at a frequency in units of the sampling rate, 0 to 0.5. */
    double at(double relative) {
        double at = Math.min(relative * SEGMENT, gain.length - 1.0);
        int k = Math.min((int) at, gain.length - 2);
        return gain[k] + (at - k) * (gain[k + 1] - gain[k]);
    }
}

package wbv.body.simulate;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.body.Model;
import wbv.body.SensorFilter;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.signal.Detrend;
import wbv.signal.Segmentation;
import wbv.signal.SpectralMatrix;

/**
 * How the sensors' anti-alias filter rolls off, read from their own noise, which is what a sensor shares with no other: white inside, it
 * falls as the filter does, whether the excitation ends there or not. Base and outputs pass the same filter, so it cancels in what is
 * linear; what a law adds inside the body has to pass it too.
 */
public final class RollOff {

    /** Samples of a segment: a filter is no finer, and shorter ones are the more to average. */
    private static final int SEGMENT = 128;
    private static final int BINS = SEGMENT / 2 + 1;
    private static final double FROM = 0.25;
    private static final double FLAT = 0.37;
    /** Bins on either side of one that are averaged with it. */
    private static final int ABOUT = 1;

    private RollOff() {}

    /**
     * The filter of a model's sensors: what the model says of it, or else what the noise of a recording shows, of a person whose base's
     * acceleration was measured. On a rig no band is known to hold noise alone: nothing is read there. It takes all sensors to tell: what
     * runs a model on its inputs alone has {@link Excitation#asDeclared} instead.
     *
     * @return empty where none is known, or everything passes
     */
    public static Optional<SensorFilter> of(Model model, Recording recording) {
        Optional<Channel> heard = model.base().sensor()
                .filter(input -> !model.isRig() && input.quantity() == Quantity.ACCELERATION);
        return model.base().filter().or(() -> heard.map(input -> read(recording, input))).filter(filter -> !filter.isOpen());
    }

    /**
     * As half of the sensors of one quantity show it at least: one that hears more than its noise there shows less of it, and one in whose
     * noise something of the excitation is left shows more. No filter at all where the recording is too short to tell.
     */
    static SensorFilter read(Recording recording, Channel input) {
        List<double[]> series = recording.channels().stream().filter(channel -> channel.quantity() == input.quantity())
                .map(recording::values).filter(values -> Arrays.stream(values).anyMatch(value -> value != values[0])).toList();
        double[] gain = new double[BINS];
        Arrays.fill(gain, 1);
        if (series.isEmpty()) {
            return filter(gain);
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
        return filter(gain);
    }

    /** From the last of the bins at which everything passes. */
    private static SensorFilter filter(double[] gain) {
        List<Integer> bins = IntStream.range((int) (FLAT * SEGMENT) - 1, BINS).boxed().toList();
        return new SensorFilter(bins.stream().map(k -> (double) k / SEGMENT).toList(), bins.stream().map(k -> gain[k]).toList());
    }

    private static double mean(double[] density, double from, double to) {
        return Arrays.stream(density, (int) (from * SEGMENT), (int) (to * SEGMENT)).average().orElse(0);
    }
}

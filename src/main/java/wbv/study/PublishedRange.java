package wbv.study;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import wbv.body.PublishedModels;
import wbv.body.simulate.ModelResponse;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.result.Digits;
import wbv.signal.Segmentation;

/**
 * What the published models of seated people transmit vertically from seat to head: from the least of them to the greatest. Their
 * values are mostly recalled and marked as assumed ({@link PublishedModels}); what ISO 5982 gives as a range is not among them.
 *
 * @param low      least modulus at every bin [1]; NaN where there is none
 * @param high     greatest modulus at every bin [1]
 * @param peaks    moduli at the models' peaks [1], by model, in the order of {@link PublishedModels#names}
 * @param peaksAt  their frequencies by model [Hz]
 */
public record PublishedRange(double[] low, double[] high, double[] peaks, double[] peaksAt) {

    private static final Channel BASE = new Channel("platform", Quantity.ACCELERATION, 'z');
    private static final Channel HEAD = new Channel("head", Quantity.ACCELERATION, 'z');
    private static final Set<String> BASES = Set.of("seat", "platform", "floor");

    /** The range at the bins of a segmentation; empty if the two channels are not vertical acceleration below a sitter and at the head. */
    public static Optional<PublishedRange> of(Channel input, Channel output, Segmentation segmentation) {
        return BASES.contains(input.location()) && vertical(input) && output.location().equals("head") && vertical(output)
                ? Optional.of(of(segmentation)) : Optional.empty();
    }

    private static boolean vertical(Channel channel) {
        return channel.axis() == 'z'
                && (channel.quantity() == Quantity.ACCELERATION || channel.quantity() == Quantity.SPECIFIC_FORCE);
    }

    private static PublishedRange of(Segmentation segmentation) {
        List<double[]> moduli = new ArrayList<>();
        try {
            for (String name : PublishedModels.names()) {
                moduli.add(new ModelResponse(PublishedModels.open(name), segmentation).of(BASE, HEAD).magnitudes());
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e); // they lie within the program
        }
        double[] low = new double[segmentation.bins()];
        double[] high = new double[segmentation.bins()];
        Arrays.setAll(low, k -> moduli.stream().mapToDouble(each -> each[k]).min().orElse(Double.NaN));
        Arrays.setAll(high, k -> moduli.stream().mapToDouble(each -> each[k]).max().orElse(Double.NaN));
        double[] peaks = new double[moduli.size()];
        double[] peaksAt = new double[moduli.size()];
        for (int m = 0; m < peaks.length; m++) {
            for (int k = 0; k < segmentation.bins(); k++) {
                if (moduli.get(m)[k] > peaks[m]) {
                    peaks[m] = moduli.get(m)[k];
                    peaksAt[m] = segmentation.frequency(k);
                }
            }
        }
        return new PublishedRange(low, high, peaks, peaksAt);
    }

    /** The lowest of the models' peaks, a modulus [1]. */
    public double leastPeak() {
        return Arrays.stream(peaks).min().orElseThrow();
    }

    /** The highest [1]. */
    public double greatestPeak() {
        return Arrays.stream(peaks).max().orElseThrow();
    }

    /** The range in a few words. */
    public String shortly() {
        return "seat to head by " + peaks.length + " published models, " + Digits.significant(leastPeak(), 2) + " to "
                + Digits.significant(greatestPeak(), 2) + " (assumed)";
    }

    /** The range in words. */
    public String words() {
        return peaks.length + " published models of seated people, seat to head (values recalled, assumed): peak "
                + Digits.significant(leastPeak(), 2) + " to " + Digits.significant(greatestPeak(), 2) + " at "
                + Digits.significant(Arrays.stream(peaksAt).min().orElseThrow(), 2) + " to "
                + Digits.significant(Arrays.stream(peaksAt).max().orElseThrow(), 2) + " Hz";
    }
}

package wbv.study;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Summary;
import wbv.signal.Backing;
import wbv.signal.Detrend;
import wbv.signal.GapBridges;
import wbv.signal.OtherCauses;
import wbv.signal.Segmentation;
import wbv.signal.SpectralMatrix;

/**
 * The other motions that were recorded where an input was: along its other axes, and about them. Their spectra with the inputs and
 * each output tell which of them an output follows where the inputs do not make it.
 */
final class OtherAxes {

    private static final Set<Quantity> MOTIONS = EnumSet.of(Quantity.ACCELERATION, Quantity.SPECIFIC_FORCE, Quantity.ANGULAR_RATE);
    private static final double LONGEST_BRIDGE = 0.05;

    /**
     * The motion that an output follows.
     *
     * @param partial median partial coherence there
     * @param bins at how many frequencies
     */
    record Named(Channel channel, double partial, int bins) {}

    private final List<Channel> candidates;
    private final int inputs;
    private final int outputs;
    private final GapBridges bridges;
    private final List<SpectralMatrix> spectra = new ArrayList<>();
    private final int[] columns;
    private final double[] values;
    private final double[] own;

    /** @param columns the channels of the rows to come, after the time */
    OtherAxes(Inspection inspection, List<Channel> inputs, List<Channel> outputs, Segmentation segmentation, List<Channel> columns) {
        this.inputs = inputs.size();
        this.outputs = outputs.size();
        candidates = inspection.summaries().keySet().stream().filter(channel -> MOTIONS.contains(channel.quantity())
                && inputs.stream().anyMatch(input -> input.location().equals(channel.location()))
                && inputs.stream().noneMatch(input -> sameMotion(input, channel)) && !outputs.contains(channel)
                && moves(inspection.summaries().get(channel))).toList();
        List<Channel> all = Stream.of(inputs, candidates, outputs).flatMap(List::stream).toList();
        this.columns = all.stream().mapToInt(channel -> 1 + columns.indexOf(channel)).toArray();
        values = new double[all.size()];
        own = new double[this.inputs + candidates.size() + 1];
        bridges = new GapBridges(all.size(), Math.max(1, (int) Math.round(LONGEST_BRIDGE * segmentation.rate())));
        for (int o = 0; o < outputs.size() && !candidates.isEmpty(); o++) {
            spectra.add(new SpectralMatrix(segmentation, Detrend.MEAN, own.length));
        }
    }

    private static boolean sameMotion(Channel a, Channel b) {
        return a.axis() == b.axis() && (a.quantity() == Quantity.ANGULAR_RATE) == (b.quantity() == Quantity.ANGULAR_RATE);
    }

    private static boolean moves(Summary summary) {
        return summary.count() > 0 && summary.rms() > 0;
    }

    /**
     * Takes the next row.
     *
     * @param row time, then the channels. Not modified.
     */
    void accept(double[] row) {
        if (!candidates.isEmpty()) {
            Arrays.setAll(values, i -> row[columns[i]]);
            average();
        }
    }

    /** Takes in what the bridges still hold. */
    void finish() {
        for (int late = candidates.isEmpty() ? 0 : bridges.delay(); late > 0; late--) {
            Arrays.fill(values, Double.NaN);
            average();
        }
    }

    private void average() {
        if (!bridges.accept(values)) {
            return;
        }
        int known = own.length - 1;
        System.arraycopy(values, 0, own, 0, known);
        for (int o = 0; o < outputs; o++) {
            own[known] = values[known + o];
            spectra.get(o).accept(own);
        }
    }

    /** What an output follows at each bin where its inputs do not make it; empty if no other motion was recorded. */
    Optional<OtherCauses> causes(int output, Backing[] backing) {
        return candidates.isEmpty() || spectra.get(output).independent() <= inputs + 1 ? Optional.empty()
                : Optional.of(OtherCauses.of(spectra.get(output), inputs, backing));
    }

    /** The motion that is named most often for an output. */
    Optional<Named> likeliest(int output, Backing[] backing) {
        return causes(output, backing).flatMap(OtherCauses::likeliest)
                .map(found -> new Named(candidates.get(found.candidate()), found.partial(), found.bins()));
    }

    /** Names by bin; empty where none is named. */
    String[] names(int output, Backing[] backing) {
        String[] names = new String[backing.length];
        Arrays.fill(names, "");
        causes(output, backing).ifPresent(found -> IntStream.range(0, names.length).filter(k -> found.named()[k] >= 0)
                .forEach(k -> names[k] = candidates.get(found.named()[k]).toString()));
        return names;
    }

    /** Whether any other motion was recorded. */
    boolean recorded() {
        return !candidates.isEmpty();
    }
}

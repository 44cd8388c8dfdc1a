package wbv.diagnosis.convention;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.measured.Coherence;
import wbv.diagnosis.measured.Measured;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/**
 * Channels that carry nothing of the motion: no more goes with them of any other channel, or of how large that is, than chance gives. Of
 * what moves beside others some part goes with some of them, whatever law is between. What has two levels only, as a binary sequence, is
 * always as large, though: what a sensor makes of it that loses the sign goes with how large the model's own answer is, which remembers.
 */
final class Unmoved {

    /** Lengths of segments: short ones scatter less, long ones hear what rings. */
    private static final int SHORT = 256;
    private static final int LONG = 4096;
    private static final int SEGMENTS = 16;

    private final Model model;
    private final Recording recording;
    private final List<Channel> channels;
    private final double[][] series;

    Unmoved(Model model, Recording recording) {
        this.model = model;
        this.recording = recording;
        this.channels = model.channels();
        this.series = channels.stream().map(channel -> LostSamples.centred(recording.values(channel)))
                .toArray(double[][]::new);
    }

    /** Whether nothing of a channel goes with any of some others. */
    boolean beside(Channel channel, List<Channel> others) {
        double[] own = series[channels.indexOf(channel)];
        return others.stream().filter(other -> !other.equals(channel)).map(other -> series[channels.indexOf(other)])
                .noneMatch(other -> related(own, other));
    }

    /** Whether nothing of all that was measured goes with what moves the model, nor with what the model makes of that. */
    boolean all() {
        return model.outputs().stream().allMatch(output -> beside(output, model.excitations())) && !answered();
    }

    private boolean answered() {
        double[][] answer = new Simulator(Excitation.of(model, recording, recording.length())).outputs(model.assembly());
        return IntStream.range(0, answer.length)
                .anyMatch(o -> related(series[channels.indexOf(model.outputs().get(o))], Measured.centred(answer[o])));
    }

    /** Share of a channel that has to go with others to be told from chance [1]: of few long segments much. */
    double told(Channel channel) {
        double[] own = series[channels.indexOf(channel)];
        return Coherence.of(recording.clock().rate(), own, own, Coherence.Weight.OUTPUT, SHORT).sure();
    }

    private boolean related(double[] x, double[] y) {
        double[] size = size(x);
        double[] other = size(y);
        return Stream.of(new double[][] {x, y}, new double[][] {x, other}, new double[][] {size, y}, new double[][] {size, other})
                .anyMatch(pair -> lengths().anyMatch(length -> Arrays.stream(Coherence.Weight.values())
                        .anyMatch(weight -> Coherence.of(recording.clock().rate(), pair[0], pair[1], weight, length).isSure())));
    }

    private IntStream lengths() {
        int most = Integer.highestOneBit(Math.max(SHORT, Math.min(LONG, recording.length() / SEGMENTS)));
        return IntStream.of(SHORT, most).distinct();
    }

    private static double[] size(double[] x) {
        return Measured.centred(Arrays.stream(x).map(Math::abs).toArray());
    }
}

package wbv.network;

import java.util.ArrayList;
import java.util.List;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;

/**
 * What a network reads from a recording, window by window.
 *
 * @param modes     of the body
 * @param time      middle of every window, one a window [s]
 * @param readings as many; nothing where samples are missing that are too many to bridge
 */
public record NetworkReadings(int modes, double[] time, List<Reading> readings) {

    private static final double RATE_TOLERANCE = 0.01;
    private static final int AT_ONCE = 256;

    /**
     * Slides a window over a recording.
     *
     * @param input  the excitation; not looked for where the network does not see it
     * @param output the answer
     * @param hop    samples from one window to the next
     * @throws DataFault if the recording's rate is not the network's, a channel is missing or of another quantity or axis than
     *                   those the network was trained on, or the recording is shorter than a window
     */
    public static NetworkReadings of(Reader reader, String name, Recording recording, Channel input, Channel output, int hop) {
        require(reader.model(), name, recording, input, output);
        List<double[]> columns = columns(reader.model().architecture(), recording, input, output);
        List<double[][]> motions = new ArrayList<>();
        List<Reading> readings = new ArrayList<>();
        List<Double> time = new ArrayList<>();
        List<Integer> waiting = new ArrayList<>();
        int targets = 2 * reader.model().modes();
        Sliding.over(columns, hop, (last, motion) -> {
            time.add(recording.clock().time(last) - (Imaging.SAMPLES - 1) / 2.0 / Imaging.RATE);
            readings.add(Reading.nothing(targets));
            motion.ifPresent(window -> {
                motions.add(window);
                waiting.add(readings.size() - 1);
            });
            if (motions.size() == AT_ONCE) {
                ask(reader, motions, waiting, readings);
            }
        });
        ask(reader, motions, waiting, readings);
        return new NetworkReadings(reader.model().modes(), time.stream().mapToDouble(t -> t).toArray(), List.copyOf(readings));
    }

    private static void ask(Reader reader, List<double[][]> motions, List<Integer> waiting, List<Reading> into) {
        List<Reading> read = reader.readAll(motions);
        for (int i = 0; i < read.size(); i++) {
            into.set(waiting.get(i), read.get(i));
        }
        motions.clear();
        waiting.clear();
    }

    private static void require(TrainedNetwork model, String name, Recording recording, Channel input, Channel output) {
        for (Channel channel : model.architecture().excited() ? List.of(input, output) : List.of(output)) {
            Channel trained = model.channels().get(channel == output ? 1 : 0);
            if (recording.has(channel) && (channel.quantity() != trained.quantity() || channel.axis() != trained.axis())) {
                throw DataFault.in(name, "the network was trained on " + trained.quantity().symbol() + "." + trained.axis()
                        + ", not on that of " + channel);
            }
        }
        require(model.architecture(), name, recording, input, output);
    }

    /** @throws DataFault if a recording is nothing that a network of an architecture can look at */
    static void require(Architecture architecture, String name, Recording recording, Channel input, Channel output) {
        double rate = recording.clock().rate();
        if (Math.abs(rate / Imaging.RATE - 1) > RATE_TOLERANCE) {
            throw DataFault.in(name, "is sampled at " + rate + " Hz; networks know " + Imaging.RATE + " Hz alone");
        }
        for (Channel channel : architecture.excited() ? architecture.channels(input, output) : List.of(output)) {
            if (!recording.has(channel)) {
                throw DataFault.in(name, "has no channel " + channel + "; it has " + recording.channels());
            }
        }
        if (recording.length() < Imaging.SAMPLES) {
            throw DataFault.in(name, "has " + recording.length() + " samples; a network needs " + Imaging.SAMPLES + " (3.65 s)");
        }
    }

    /** What an architecture looks at; the answer stands for an excitation that it does not look at. */
    static List<double[]> columns(Architecture architecture, Recording recording, Channel input, Channel output) {
        return architecture.channels(input, output).stream()
                .map(channel -> recording.values(architecture.excited() ? channel : output)).toList();
    }

    /** Windows that could be read. */
    public long read() {
        return readings.stream().filter(Reading::read).count();
    }

    /** Windows unlike any that the network was trained on. */
    public long unlike() {
        return readings.stream().filter(Reading::unlike).count();
    }
}

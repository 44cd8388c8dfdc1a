package wbv.study;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.identify.EquivalentBodies;
import wbv.identify.EquivalentBody;
import wbv.identify.MotionWindow;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * The bodies between the base and its outputs, at the end of a recording: what {@code analyze} and {@code track} print. The last
 * samples are kept as they pass, so that an hour needs no more memory than ten minutes.
 */
final class PathBodies {

    /** Samples that are kept: nine minutes at 60 Hz. */
    private static final int CAPACITY = 1 << 15;

    private final Channel input;
    private final List<Channel> motions;
    private final List<Channel> outputs;
    private final MotionWindow window;

    /** @param motions other motions of the base, which may move the outputs too */
    PathBodies(double rate, Channel input, List<Channel> motions, List<Channel> outputs) {
        this.input = input;
        this.motions = List.copyOf(motions);
        this.outputs = List.copyOf(outputs);
        this.window = new MotionWindow(rate, 1 + motions.size() + outputs.size(), CAPACITY);
    }

    /** What else of the base's motion was recorded: its accelerations and angular rates along and about the other axes. */
    static List<Channel> motionsOf(List<Channel> recorded, Channel input, List<Channel> outputs) {
        Quantity linear = input.quantity() == Quantity.SPECIFIC_FORCE
                || recorded.stream().noneMatch(c -> c.location().equals(input.location())
                        && c.quantity() == Quantity.ACCELERATION) ? Quantity.SPECIFIC_FORCE : Quantity.ACCELERATION;
        return recorded.stream().filter(c -> c.location().equals(input.location()) && !c.equals(input) && !outputs.contains(c))
                .filter(c -> c.quantity() == linear || c.quantity() == Quantity.ANGULAR_RATE).toList();
    }

    List<Channel> motions() {
        return motions;
    }

    /** What {@link #accept} takes: the input, the other motions, the outputs. */
    List<Channel> channels() {
        return Stream.of(List.of(input), motions, outputs).flatMap(List::stream).toList();
    }

    /**
     * Takes a sample; NaN is missing.
     *
     * @param values one a channel of {@link #channels}, in its unit. Not modified.
     */
    void accept(double[] values) {
        window.accept(values);
    }

    /**
     * What is known after the last sample, in the order of the outputs.
     *
     * @param degrees as {@link EquivalentBodies#of} has it
     */
    List<PathBody> bodies(int degrees) {
        if (window.length() == 0) {
            return outputs.stream().map(output -> PathBody.none(output, "nothing was recorded")).toList();
        }
        EquivalentBodies fits = new EquivalentBodies(window, motions.size());
        return IntStream.range(0, outputs.size()).parallel().mapToObj(i -> body(fits, i, degrees)).toList();
    }

    private PathBody body(EquivalentBodies fits, int i, int degrees) {
        Channel output = outputs.get(i);
        if (kind(input) != kind(output)) {
            return PathBody.none(output, "a body is followed from acceleration to acceleration, or from rate to rate");
        }
        double[] y = window.channel(1 + motions.size() + i);
        return fits.of(y, degrees).map((EquivalentBody body) -> PathBody.of(output, body, motions, window.rate()))
                .orElseGet(() -> PathBody.none(output, moves(y) ? "too little motion, or too short" : "nothing moves"));
    }

    private static boolean moves(double[] y) {
        for (double value : y) {
            if (Double.isFinite(value) && value != 0) {
                return true;
            }
        }
        return false;
    }

    /** Accelerations count as one, what cannot be followed as force. */
    static Quantity kind(Channel channel) {
        return switch (channel.quantity()) {
            case ACCELERATION, SPECIFIC_FORCE -> Quantity.ACCELERATION;
            case ANGULAR_RATE -> Quantity.ANGULAR_RATE;
            default -> Quantity.FORCE;
        };
    }
}

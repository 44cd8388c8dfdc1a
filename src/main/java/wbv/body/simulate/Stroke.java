package wbv.body.simulate;

import java.util.ArrayList;
import java.util.List;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/**
 * The measured motion that drives links, as it was recorded: no band limit and no mean removed, since slow and long strokes are
 * what such links are tested with.
 *
 * @param position of the base by sample [m]. Not copied
 * @param velocity of the base by sample [m/s]. Not copied
 * @param starts where laws with memory start anew: at the first sample, and after every gap, in which nobody saw what was done
 *                 to the link
 */
public record Stroke(double[] position, double[] velocity, List<Start> starts) {

    /**
     * A sample from which laws with memory know nothing of what was before.
     *
     * @param sample index
     * @param force by link there [N], NaN where it was not measured. Not copied
     */
    public record Start(int sample, double[] force) {
        /** The force in a link [N]; NaN where it was not measured. */
        double in(int link) {
            return link < force.length ? force[link] : Double.NaN;
        }
    }

    public Stroke {
        starts = List.copyOf(starts);
        if (position.length != velocity.length || position.length < 2) {
            throw new IllegalArgumentException("a stroke needs at least two samples of position and as many of velocity: "
                    + position.length
                    + " and " + velocity.length);
        }
    }

    /**
     * A position alone; its velocity by central differences.
     *
     * @param position by sample [m]. Not modified.
     * @param step between samples [s]
     * @param start force in each link at the first sample [N]
     */
    public static Stroke ofPosition(double[] position, double step, double... start) {
        int n = position.length;
        double[] velocity = new double[n];
        for (int i = 0; i < n; i++) {
            int before = Math.max(0, i - 1);
            int after = Math.min(n - 1, i + 1);
            velocity[i] = (position[after] - position[before]) / ((after - before) * step);
        }
        return new Stroke(position, velocity, List.of(new Start(0, start)));
    }

    /**
     * A velocity alone; its position by the trapezoidal rule from 0.
     *
     * @param velocity by sample [m/s]. Not modified.
     * @param step between samples [s]
     * @param start force in each link at the first sample [N]
     */
    public static Stroke ofVelocity(double[] velocity, double step, double... start) {
        double[] position = new double[velocity.length];
        for (int i = 1; i < position.length; i++) {
            position[i] = position[i - 1] + step * (velocity[i - 1] + velocity[i]) / 2;
        }
        return new Stroke(position, velocity, List.of(new Start(0, start)));
    }

    /** As a recording holds it: the base's channel, and the other of position and velocity where it was measured too. */
    static Stroke of(Model model, Recording recording, Channel input, int samples) {
        double step = recording.clock().step();
        double[] raw = recording.values(input);
        List<Start> starts = new ArrayList<>();
        for (int i = 0; i < samples; i++) {
            int sample = i;
            if (!Double.isNaN(raw[i]) && (i == 0 || Double.isNaN(raw[i - 1]))) {
                starts.add(new Start(i, model.links().stream().mapToDouble(link -> link.sensor().filter(recording::has)
                        .map(sensor -> recording.values(sensor)[sample]).orElse(Double.NaN)).toArray()));
            }
        }
        double[] own = cut(recording, input, samples);
        Channel velocity = new Channel(input.location(), Quantity.VELOCITY, input.axis());
        return switch (input.quantity()) {
            case POSITION -> new Stroke(own,
                    recording.has(velocity) ? cut(recording, velocity, samples) : ofPosition(own, step).velocity(), starts);
            case VELOCITY -> new Stroke(ofVelocity(own, step).position(), own, starts);
            default -> throw new DataFault("a driven link needs the measured position or velocity of the base (pos or vel): "
                    + input);
        };
    }

    private static double[] cut(Recording recording, Channel channel, int samples) {
        return java.util.Arrays.copyOf(LostSamples.filled(recording.values(channel)), samples);
    }
}

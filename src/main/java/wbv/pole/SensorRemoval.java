package wbv.pole;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.filter.BodyEstimate;
import wbv.identify.Pole;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingWriter;

/**
 * Does without sensors: from the base and the measured place alone, the motion of the absent places and the bounds of their
 * bodies.
 *
 * <p>A whole recording by {@link RemovalRun}.
 */
public final class SensorRemoval {

    private final TrainedPoles trained;

    /** Does without the sensors of the places that were trained for. */
    public SensorRemoval(TrainedPoles trained) {
        this.trained = trained;
    }

    /**
     * A pole of the measured place, and what it bounds.
     *
     * @param time   from which it counts [s]
     * @param sample likewise
     * @param pole   as measured, smoothed over windows
     * @param bounds of every absent channel's body, in the order of {@link Attributes#OF_A_BODY}
     */
    public record Seen(double time, long sample, Pole pole, Map<Channel, List<Chord>> bounds) {}

    /**
     * The body of an absent place as the constrained estimator follows it within the bounds, at all samples.
     *
     * @param frequency by sample [Hz]
     * @param damping ratio by sample
     * @param motion of that body by sample [m/s²]
     */
    public record Body(double[] frequency, double[] damping, double[] motion) {}

    /**
     * What was predicted.
     *
     * @param motion of every absent channel [m/s²], at all samples of the recording, by the trained response
     * @param bodies of every absent channel
     * @param seen   poles measured on the way
     * @param lost   windows in which no pole of the cluster was found, or a sample was missing
     */
    public record Prediction(Map<Channel, double[]> motion, Map<Channel, Body> bodies, List<Seen> seen, int lost) {

        /**
         * Writes the motion of absent channels as a recording.
         *
         * @param recording from which it was predicted
         */
        public void writeMotion(Path file, List<Channel> absent, Recording recording) throws IOException {
            try (RecordingWriter writer = RecordingWriter.create(file, absent, recording.metadata())) {
                double[] row = new double[1 + absent.size()];
                for (int k = 0; k < recording.length(); k++) {
                    row[0] = recording.clock().time(k);
                    for (int i = 0; i < absent.size(); i++) {
                        row[1 + i] = motion.get(absent.get(i))[k];
                    }
                    writer.write(row);
                }
                writer.finish();
            }
        }

        /** Poles whose polygons were cut inside, as a share of those seen [1]; NaN if none was. */
        public double inside() {
            long all = seen.stream().flatMap(each -> each.bounds().values().stream()).flatMap(List::stream).count();
            long inside = seen.stream().flatMap(each -> each.bounds().values().stream()).flatMap(List::stream)
                    .filter(Chord::inside).count();
            return inside / (double) all;
        }
    }

    /**
     * Predicts. The recording need not have the absent channels; where it has, they are not looked at.
     *
     * @param name of the recording, for messages
     */
    public Prediction predict(String name, Recording recording) {
        Layout layout = trained.layout();
        layout.requireMeasured(name, recording);
        RemovalRun run = new RemovalRun(trained, name, recording.clock().rate());
        double[][] u = layout.inputs().stream().map(recording::values).toArray(double[][]::new);
        double[] y = recording.values(layout.measured());
        Map<Channel, double[]> motion = new LinkedHashMap<>();
        Map<Channel, Body> bodies = new LinkedHashMap<>();
        for (Channel absent : layout.absent()) {
            motion.put(absent, new double[y.length]);
            bodies.put(absent, new Body(new double[y.length], new double[y.length], new double[y.length]));
        }
        List<Seen> seen = new ArrayList<>();
        double[] now = new double[u.length];
        for (int k = 0; k < y.length; k++) {
            for (int i = 0; i < u.length; i++) {
                now[i] = u[i][k];
            }
            run.step(now, y[k]);
            if (run.fresh()) {
                seen.add(new Seen(recording.clock().time(k), k, run.pole(), run.bounds()));
            }
            for (int i = 0; i < layout.absent().size(); i++) {
                Channel absent = layout.absent().get(i);
                motion.get(absent)[k] = run.motion(i);
                BodyEstimate track = run.body(i);
                Body body = bodies.get(absent);
                body.frequency()[k] = track.frequency();
                body.damping()[k] = track.damping();
                body.motion()[k] = track.prediction();
            }
        }
        return new Prediction(motion, bodies, seen, run.lost());
    }
}

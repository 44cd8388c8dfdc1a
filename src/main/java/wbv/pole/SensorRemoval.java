package wbv.pole;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.filter.Bounds.Attribute;
import wbv.identify.Pole;
import wbv.identify.TransferRun;
import wbv.identify.TunedResponse;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.recording.RecordingWriter;

/**
 * Does without sensors: from the base and the measured place alone, the motion of the absent places and the bounds of their
 * bodies.
 *
 * <p>Every hop the window that has just passed is identified; its pole in the main cluster tunes the trained responses and cuts
 * the polygons. Nothing later than a sample is used for it. Until the first window is whole, the trained population's median
 * stands in;
 * while no pole of the cluster is found, the last one holds, and is counted.
 */
public final class SensorRemoval {

    private static final double STEADY = 0.5;
    /** Below which motion counts as gravity and bias [Hz]. */
    private static final double LEVEL_CORNER = 0.02;

    private final TrainedPoles trained;

    public SensorRemoval(TrainedPoles trained) {
        this.trained = trained;
    }

    /**
     * A pole of the measured place, and what it bounds.
     *
     * @param time   from which it counts [s]
     * @param sample likewise
     * @param pole   as measured, smoothed over windows
     * @param bounds of every absent channel's body, in the order of {@link Attributes#OF_A_POLE}
     */
    public record Seen(double time, long sample, Pole pole, Map<Channel, List<Chord>> bounds) { }

    /**
     * What was predicted.
     *
     * @param motion of every absent channel [m/s²], at all samples of the recording
     * @param seen   poles measured on the way
     * @param lost   windows in which no pole of the cluster was found, or a sample was missing
     */
    public record Prediction(Map<Channel, double[]> motion, List<Seen> seen, int lost) {

        /** @throws DataFault if the motion grows beyond all numbers, as of polygons that no body made */
        public Prediction {
            motion.forEach((channel, values) -> {
                if (Arrays.stream(values).anyMatch(Double::isInfinite)) {
                    throw new DataFault("what the polygons say of " + channel + " grows without bound: train them anew by 'wbv poles'");
                }
            });
        }

        /** Writes the motion of absent channels as a recording. @param recording from which it was predicted */
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

        /** Poles whose polygons were cut inside, as a share of those seen; NaN if none was. */
        public double inside() {
            long all = seen.stream().flatMap(each -> each.bounds().values().stream()).flatMap(List::stream).count();
            long inside = seen.stream().flatMap(each -> each.bounds().values().stream()).flatMap(List::stream)
                    .filter(Chord::inside).count();
            return inside / (double) all;
        }

        /** Bounds of an absent channel's body for the constrained estimator. */
        public PolygonConstraint constraint(Channel absent) {
            return new PolygonConstraint(seen.stream().mapToLong(Seen::sample).toArray(),
                    seen.stream().map(each -> each.bounds().get(absent).toArray(Chord[]::new)).toArray(Chord[][]::new));
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
        double rate = recording.clock().rate();
        double[][] u = layout.inputs().stream().map(channel -> PoleWindows.bridged(recording.values(channel)))
                .toArray(double[][]::new);
        double[] y = PoleWindows.bridged(recording.values(layout.measured()));
        int window = trained.windows().samples(name, rate, u.length);
        int hop = Math.max(1, (int) Math.round(trained.windows().hop() * rate));
        List<Seen> seen = new ArrayList<>();
        Map<Channel, double[]> motion = new LinkedHashMap<>();
        Map<Channel, TransferRun> runs = new LinkedHashMap<>();
        Pole pole = trained.typical();
        for (Channel absent : layout.absent()) {
            motion.put(absent, new double[recording.length()]);
            try {
                runs.put(absent, new TransferRun(trained.responses().get(absent).at(2 * Math.PI * pole.frequency()), rate));
            } catch (IllegalArgumentException wrong) { // a response that overflows
                throw new DataFault("what the polygons say of " + absent + " is no body's response; train them anew by 'wbv poles'", wrong);
            }
        }
        int lost = 0;
        double[] level = new double[u.length];
        double[] now = new double[u.length];
        double forget = 2 * Math.PI * LEVEL_CORNER / rate;
        for (int k = 0; k < recording.length(); k++) {
            if (k >= window && (k - window) % hop == 0) {
                Optional<Pole> found = trained.windows().window(u, y, k - window, window, rate).flatMap(trained::mainOf);
                if (found.isPresent()) {
                    double before = 2 * Math.PI * pole.frequency();
                    pole = seen.isEmpty() ? found.get() : smoothed(pole, found.get());
                    double after = 2 * Math.PI * pole.frequency();
                    for (Channel absent : layout.absent()) {
                        TunedResponse response = trained.responses().get(absent);
                        runs.get(absent).retune(response.at(after), response.pulsation(after) / response.pulsation(before));
                    }
                    seen.add(new Seen(recording.clock().time(k), k, pole, bounds(pole)));
                } else {
                    lost++;
                }
            }
            for (int i = 0; i < u.length; i++) {
                double value = u[i][k];
                // A constant is gravity or bias; what is missing holds still.
                level[i] = Double.isFinite(value) ? k == 0 ? value : level[i] + forget * (value - level[i]) : level[i];
                now[i] = Double.isFinite(value) ? value - level[i] : 0;
            }
            for (Channel absent : layout.absent()) {
                motion.get(absent)[k] = runs.get(absent).step(now);
            }
        }
        return new Prediction(motion, seen, lost);
    }

    private static Pole smoothed(Pole before, Pole now) {
        return new Pole(before.re() + STEADY * (now.re() - before.re()), before.im() + STEADY * (now.im() - before.im()));
    }

    private Map<Channel, List<Chord>> bounds(Pole pole) {
        Map<Channel, List<Chord>> bounds = new LinkedHashMap<>();
        for (Channel absent : trained.layout().absent()) {
            List<Chord> chords = new ArrayList<>();
            for (Attribute attribute : Attributes.OF_A_POLE) {
                chords.add(trained.chord(absent, pole, attribute));
            }
            bounds.put(absent, chords);
        }
        return bounds;
    }
}

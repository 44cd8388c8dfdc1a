package wbv.task;

import com.github.javacliparser.FileOption;
import com.github.javacliparser.FlagOption;
import com.github.javacliparser.FloatOption;
import com.github.javacliparser.IntOption;
import com.yahoo.labs.samoa.instances.Instance;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import moa.classifiers.Classifier;
import moa.classifiers.Regressor;
import moa.core.Measurement;
import moa.core.ObjectRepository;
import moa.evaluation.LearningEvaluation;
import moa.evaluation.preview.LearningCurve;
import moa.options.ClassOption;
import moa.streams.InstanceStream;
import moa.tasks.AuxiliarMainTask;
import moa.tasks.TaskMonitor;
import wbv.recording.AtomicFile;
import wbv.recording.DataFault;

/**
 * Takes a sensor away from a stream: for a while the learner sees the class, then no more; all the time it predicts it first, and
 * what it foresaw is held against what the sensor, which the task still reads, says. One row for every interval.
 *
 * <p>Memory does not grow: the newest rows are the result, all of them go to a file. With a checkpoint, a run that was killed goes
 * on where the last checkpoint was written, rows behind it are dropped from the file, and the end is as if nothing had happened.
 */
public class PredictWithoutSensor extends AuxiliarMainTask {

    private static final long serialVersionUID = 1;
    private static final String TIME = "time [s]";

    public final ClassOption learnerOption = new ClassOption("learner", 'l', "What predicts the class.", Regressor.class,
            "wbv.learn.SensorRemover");
    public final ClassOption streamOption = new ClassOption("stream", 's', "Base and measured place; the absent place is the class.",
            InstanceStream.class, "wbv.stream.RigStream -e 'subject=1 regime=1 seconds=600' -i "
                    + "platform.acc.z,platform.acc.x,platform.gyr.y,seat.acc.z");
    public final FloatOption removedOption = new FloatOption("removed", 'a', "When the sensor goes [s].", 300, 0, 1e12);
    public final FloatOption intervalOption = new FloatOption("interval", 'e', "Time from one row to the next [s].", 30, 1e-3, 1e9);
    public final IntOption rowsOption = new IntOption("rows", 'n', "Newest rows that are the result.", 1000, 1, 1000000);
    public final FileOption tableOption = new FileOption("table", 't', "CSV file for all rows, written as they come.", null, "csv", true);
    public final FileOption checkpointOption = new FileOption("checkpoint", 'c', "File to go on from, where it is there, and to write "
            + "now and then.", null, "wbv", true);
    public final FloatOption everyOption = new FloatOption("every", 'k', "Time from one checkpoint to the next, of the stream [s].", 300,
            1e-3, 1e9);
    public final FlagOption liveOption = new FlagOption("live", 'j', "The stream goes on by itself: skip nothing when going on.");

    /** What a run needs to go on. */
    private static final class State implements Serializable {
        private static final long serialVersionUID = 1;
        private final Classifier learner;
        private long instances;
        private long bytes;
        private double start;
        private double due;
        private double next;
        private final Score score = new Score();
        private final Deque<double[]> rows = new ArrayDeque<>();

        State(Classifier learner) {
            this.learner = learner;
        }
    }

    /** What was foreseen in an interval, against what the sensor said. */
    private static final class Score implements Serializable {
        private static final long serialVersionUID = 1;
        private long n;
        private double truth;
        private double square;
        private double error;
        private double errorSquare;

        void take(double said, double y) {
            n++;
            truth += y;
            square += y * y;
            error += said - y;
            errorSquare += (said - y) * (said - y);
        }

        /** Mean square of the difference over the variance, constants left out; NaN if nothing moved. */
        double share() {
            double variance = square - truth * truth / n;
            return variance > 0 ? (errorSquare - error * error / n) / variance : Double.NaN;
        }

        void clear() {
            n = 0;
            truth = 0;
            square = 0;
            error = 0;
            errorSquare = 0;
        }
    }

    @Override
    public String getPurposeString() {
        return "Takes a sensor away from a stream and predicts the place that had it, learning before.";
    }

    @Override
    public Class<?> getTaskResultType() {
        return LearningCurve.class;
    }

    @Override
    protected Object doMainTask(TaskMonitor monitor, ObjectRepository repository) {
        InstanceStream stream = (InstanceStream) getPreparedClassOption(streamOption);
        try {
            return run(stream, monitor);
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    private LearningCurve run(InstanceStream stream, TaskMonitor monitor) throws IOException {
        State state = state(stream);
        boolean resumed = state.instances > 0;
        if (resumed && !liveOption.isSet()) {
            for (long k = 0; k < state.instances && stream.hasMoreInstances(); k++) {
                stream.nextInstance();
            }
        }
        int time = stream.getHeader().attribute(0).name().equals("t") ? 0 : -1;
        try (Rows table = rows(state)) {
            while (stream.hasMoreInstances()) {
                Instance instance = stream.nextInstance().getData();
                double t = time < 0 ? state.instances : instance.value(time);
                if (state.instances == 0) {
                    state.start = t;
                    state.due = t + intervalOption.getValue();
                    state.next = t + everyOption.getValue();
                }
                take(state, instance, t);
                state.instances++;
                if (t >= state.due - 1e-9) {
                    row(state, t, table);
                    state.due += intervalOption.getValue() * Math.max(1, Math.ceil((t - state.due) / intervalOption.getValue()));
                }
                if (t >= state.next - 1e-9) {
                    checkpoint(state, table);
                    state.next += everyOption.getValue() * Math.max(1, Math.ceil((t - state.next) / everyOption.getValue()));
                }
                if (state.instances % 1000 == 0) {
                    if (monitor.taskShouldAbort()) {
                        break;
                    }
                    monitor.setCurrentActivityFractionComplete(state.instances
                            / (double) (state.instances + Math.max(0, stream.estimatedRemainingInstances())));
                }
            }
        }
        return curve(state);
    }

    private void take(State state, Instance instance, double t) {
        double truth = instance.classIsMissing() ? Double.NaN : instance.classValue();
        double said = state.learner.getVotesForInstance(instance)[0];
        if (Double.isFinite(truth) && Double.isFinite(said)) {
            state.score.take(said, truth);
        }
        Instance seen = instance;
        if (t - state.start >= removedOption.getValue()) {
            seen = instance.copy();
            seen.setDataset(instance.dataset());
            seen.setClassValue(Double.NaN);
        }
        state.learner.trainOnInstance(seen);
    }

    private void row(State state, double t, Rows table) throws IOException {
        Measurement[] known = state.learner.getModelMeasurements();
        double[] row = new double[3 + known.length];
        row[0] = t;
        row[1] = t - state.start >= removedOption.getValue() ? 0 : 1;
        row[2] = state.score.share();
        for (int i = 0; i < known.length; i++) {
            row[3 + i] = known[i].getValue();
        }
        state.score.clear();
        state.rows.addLast(row);
        if (state.rows.size() > rowsOption.getValue()) {
            state.rows.removeFirst();
        }
        if (table.file().isPresent()) {
            StringBuilder text = new StringBuilder();
            if (state.bytes == 0) {
                text.append(TIME + ",sensor,error over variance");
                for (Measurement each : known) {
                    text.append(',').append(each.getName());
                }
                text.append('\n');
            }
            for (int i = 0; i < row.length; i++) {
                text.append(i == 0 ? "" : ",").append(Double.isNaN(row[i]) ? "" : Double.toString(row[i]));
            }
            byte[] bytes = text.append('\n').toString().getBytes(StandardCharsets.UTF_8);
            ByteBuffer buffer = ByteBuffer.wrap(bytes);
            while (buffer.hasRemaining()) {
                table.file().get().write(buffer);
            }
            state.bytes += bytes.length;
        }
    }

    private static boolean named(FileOption option) {
        return option.getValue() != null && !option.getValue().isEmpty();
    }

    /** The file of all rows, where one is named. */
    private record Rows(Optional<FileChannel> file) implements Closeable {
        @Override
        public void close() throws IOException {
            if (file.isPresent()) {
                file.get().close();
            }
        }
    }

    /** Opened, and cut to what the checkpoint knows of. */
    private Rows rows(State state) throws IOException {
        if (!named(tableOption)) {
            return new Rows(Optional.empty());
        }
        Path folder = Path.of(tableOption.getValue()).toAbsolutePath().getParent();
        Files.createDirectories(folder);
        FileChannel table = FileChannel.open(Path.of(tableOption.getValue()), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        if (table.size() < state.bytes) {
            table.close();
            throw DataFault.in(tableOption.getValue(), "is shorter than the checkpoint says; give both back, or take both away");
        }
        table.truncate(state.bytes);
        table.position(state.bytes);
        return new Rows(Optional.of(table));
    }

    private State state(InstanceStream stream) throws IOException {
        if (named(checkpointOption) && Files.exists(Path.of(checkpointOption.getValue()))) {
            try (ObjectInputStream in = new ObjectInputStream(
                    new ByteArrayInputStream(Files.readAllBytes(Path.of(checkpointOption.getValue()))))) {
                in.setObjectInputFilter(AdmittedClasses.filter());
                String words = in.readUTF();
                if (!words.equals(words())) {
                    throw DataFault.in(checkpointOption.getValue(), "is of another run: " + words);
                }
                return (State) in.readObject();
            } catch (DataFault wrong) {
                throw wrong;
            } catch (IOException | ClassNotFoundException | RuntimeException damaged) {
                throw DataFault.in(checkpointOption.getValue(), "is no checkpoint of this version of wbv; take it away to begin anew",
                        damaged);
            }
        }
        Classifier learner = (Classifier) getPreparedClassOption(learnerOption);
        learner.setModelContext(stream.getHeader());
        learner.resetLearning();
        return new State(learner);
    }

    /** What must be the same for a run to go on. */
    private String words() {
        return learnerOption.getValueAsCLIString() + " | " + streamOption.getValueAsCLIString() + " | " + removedOption.getValue()
                + " | " + intervalOption.getValue();
    }

    private void checkpoint(State state, Rows table) throws IOException {
        if (!named(checkpointOption)) {
            return;
        }
        if (table.file().isPresent()) {
            table.file().get().force(false); // rows that a checkpoint knows of are there
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeUTF(words());
            out.writeObject(state);
        }
        AtomicFile.write(Path.of(checkpointOption.getValue()), bytes.toByteArray());
    }

    private static LearningCurve curve(State state) {
        LearningCurve curve = new LearningCurve(TIME);
        Measurement[] known = state.learner.getModelMeasurements();
        for (double[] row : state.rows) {
            Measurement[] all = new Measurement[row.length];
            all[0] = new Measurement(TIME, row[0]);
            all[1] = new Measurement("sensor", row[1]);
            all[2] = new Measurement("error over variance", row[2]);
            for (int i = 3; i < row.length; i++) {
                all[i] = new Measurement(known[i - 3].getName(), row[i]);
            }
            curve.insertEntry(new LearningEvaluation(all));
        }
        return curve;
    }
}

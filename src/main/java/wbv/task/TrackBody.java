package wbv.task;

import com.github.javacliparser.FileOption;
import com.github.javacliparser.FloatOption;
import com.yahoo.labs.samoa.instances.Instance;
import com.yahoo.labs.samoa.instances.InstancesHeader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.function.ObjDoubleConsumer;
import moa.core.Measurement;
import moa.core.ObjectRepository;
import moa.evaluation.LearningEvaluation;
import moa.evaluation.preview.LearningCurve;
import moa.options.ClassOption;
import moa.streams.InstanceStream;
import moa.tasks.AuxiliarMainTask;
import moa.tasks.TaskMonitor;
import wbv.filter.BodyEstimate;
import wbv.learn.BodyLearner;
import wbv.learn.TrackMeasurements;

/**
 * Follows natural frequency and damping ratio of a body through a stream. The result is a learning curve over time; every
 * sample of it can be written to a file. The estimate at a time rests on samples up to three before it.
 */
public class TrackBody extends AuxiliarMainTask {

    private static final long serialVersionUID = 1;
    private static final String TIME = "time [s]";
    private static final int BETWEEN_MONITOR_LOOKS = 1000;

    public final ClassOption learnerOption = new ClassOption("learner", 'l',
            "What estimates the body.", BodyLearner.class, "wbv.learn.AdwinKalman");
    public final ClassOption streamOption = new ClassOption("stream", 's',
            "Motion of the base, and of the body as the class.", InstanceStream.class, "wbv.stream.RigStream");
    public final FloatOption intervalOption = new FloatOption("interval", 'e',
            "Time from one entry of the curve to the next [s].", 1, 1e-3, 1e9);
    public final FileOption tracksOption = new FileOption("tracks", 't',
            "File for the estimate at every sample, .csv or .arff.", null, "csv", true);

    @Override
    public String getPurposeString() {
        return "Follows the natural frequency and the damping ratio of a body through a stream.";
    }

    @Override
    public Class<?> getTaskResultType() {
        return LearningCurve.class;
    }

    @Override
    protected Object doMainTask(TaskMonitor monitor, ObjectRepository repository) {
        BodyLearner learner = (BodyLearner) getPreparedClassOption(learnerOption);
        InstanceStream stream = (InstanceStream) getPreparedClassOption(streamOption);
        learner.setModelContext(stream.getHeader());
        learner.resetLearning();
        if (tracksOption.getValue() == null || tracksOption.getValue().isEmpty()) {
            return follow(stream, learner, monitor, (track, time) -> {});
        }
        try (TrackFile file = TrackFile.create(Path.of(tracksOption.getValue()))) {
            LearningCurve curve = follow(stream, learner, monitor, file::write);
            file.finish();
            return curve;
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    private LearningCurve follow(InstanceStream stream, BodyLearner learner, TaskMonitor monitor, ObjDoubleConsumer<BodyEstimate> sink) {
        LearningCurve curve = new LearningCurve(TIME);
        InstancesHeader header = stream.getHeader();
        int timeIndex = header.attribute(0).name().equals("t") ? 0 : -1;
        double due = Double.NEGATIVE_INFINITY;
        long count = 0;
        double time = 0;
        boolean told = true;
        while (stream.hasMoreInstances()) {
            Instance instance = stream.nextInstance().getData();
            learner.trainOnInstance(instance);
            time = timeIndex < 0 ? count / learner.spec().rate() : instance.value(timeIndex);
            sink.accept(learner.track(), time);
            told = false;
            if (count == 0) {
                due = time + intervalOption.getValue();
            } else if (time >= due - 1e-9) {
                curve.insertEntry(entry(time, learner));
                due += intervalOption.getValue() * Math.max(1, Math.ceil((time - due) / intervalOption.getValue()));
                told = true;
            }
            count++;
            if (count % BETWEEN_MONITOR_LOOKS == 0) {
                if (monitor.taskShouldAbort()) {
                    return curve;
                }
                monitor.setCurrentActivityFractionComplete(
                        count / (double) (count + stream.estimatedRemainingInstances()));
            }
        }
        if (!told) {
            curve.insertEntry(entry(time, learner));
        }
        return curve;
    }

    private static LearningEvaluation entry(double time, BodyLearner learner) {
        Measurement[] known = TrackMeasurements.of(learner.track(), learner.explained());
        Measurement[] all = new Measurement[known.length + 1];
        all[0] = new Measurement(TIME, time);
        System.arraycopy(known, 0, all, 1, known.length);
        return new LearningEvaluation(all);
    }
}

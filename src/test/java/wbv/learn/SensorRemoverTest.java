package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.yahoo.labs.samoa.instances.Instance;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import moa.classifiers.Regressor;
import moa.core.Measurement;
import moa.options.AbstractOptionHandler;
import moa.options.ClassOption;
import moa.streams.InstanceStream;
import moa.tasks.MainTask;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import wbv.pole.Layout;
import wbv.pole.PoleTraining;
import wbv.pole.PoleWindows;
import wbv.pole.PolygonFile;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/** The chain of poles, polygons and a bounded body as a MOA learner. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class SensorRemoverTest {

    private static final String LEARNER = "wbv.learn.SensorRemover -w 10 -h 1 -b 10 -k 40";
    private static final String CHANNELS = "platform.acc.z,platform.acc.x,platform.gyr.y,seat.acc.z";
    private static final String EXPERIMENT = "subject=1 excitation=random:z:0.5-12:0.9 seconds=70 seed=4";
    private static final String STREAM = "wbv.stream.RigStream -e '" + EXPERIMENT + "' -i " + CHANNELS;

    private List<Instance> instances;

    @BeforeAll
    void read() throws Exception {
        InstanceStream stream = (InstanceStream) ClassOption.cliStringToObject(STREAM, InstanceStream.class, null);
        ((AbstractOptionHandler) stream).prepareForUse();
        instances = new ArrayList<>();
        while (stream.hasMoreInstances()) {
            instances.add(stream.nextInstance().getData());
        }
    }

    private static SensorRemover learner(String text) throws Exception {
        SensorRemover learner = (SensorRemover) ClassOption.cliStringToObject(text, Regressor.class, null);
        learner.prepareForUse();
        learner.resetLearning();
        return learner;
    }

    private static Instance without(Instance instance) {
        Instance copy = instance.copy();
        copy.setDataset(instance.dataset());
        copy.setClassValue(Double.NaN);
        return copy;
    }

    /** Predictions of a stretch without its sensor. */
    private double[] removed(SensorRemover learner, int from, int to) {
        double[] said = new double[to - from];
        for (int k = from; k < to; k++) {
            said[k - from] = learner.getVotesForInstance(without(instances.get(k)))[0];
            learner.trainOnInstance(without(instances.get(k)));
        }
        return said;
    }

    /** Mean square of the error over the variance. */
    private double share(double[] said, int from) {
        double mean = instances.subList(from, from + said.length).stream().mapToDouble(Instance::classValue).average().orElseThrow();
        double error = 0;
        double power = 0;
        for (int k = 0; k < said.length; k++) {
            double y = instances.get(from + k).classValue();
            error += (said[k] - y) * (said[k] - y);
            power += (y - mean) * (y - mean);
        }
        return error / power;
    }

    @Test
    void itLearnsWhileTheSensorIsThereAndPredictsWhenItIsGone() throws Exception {
        SensorRemover learner = learner(LEARNER);
        assertTrue(share(removed(learner, 0, 600), 0) > 0.3, "knows nothing yet");
        for (Instance instance : instances.subList(600, 2400)) {
            learner.trainOnInstance(instance);
        }
        double share = share(removed(learner, 2400, 3600), 2400);
        assertTrue(share < 0.08, "of the variance: " + share);
    }

    /** What the sensor says reaches no prediction before the next training. */
    @Test
    void noPredictionUsesTheSensorButThroughPolygons() throws Exception {
        SensorRemover with = learner(LEARNER);
        for (Instance instance : instances.subList(0, 2400)) {
            with.trainOnInstance(instance);
        }
        SensorRemover apart = (SensorRemover) with.copy();
        for (int k = 2400; k < 2440; k++) {
            Instance other = instances.get(k).copy();
            other.setDataset(instances.get(k).dataset());
            double truth = instances.get(k).classValue();
            other.setClassValue(truth + (k % 2 == 0 ? 5 : -5));
            assertEquals(with.getVotesForInstance(instances.get(k))[0], apart.getVotesForInstance(other)[0], 0.02, "but for the level");
            with.trainOnInstance(instances.get(k));
            apart.trainOnInstance(other);
        }
    }

    @Tag("slow")
    @Test
    void aCopyGoesOnAndPredictingChangesNothing() throws Exception {
        SensorRemover learner = learner(LEARNER);
        for (Instance instance : instances.subList(0, 2000)) {
            learner.trainOnInstance(instance);
        }
        SensorRemover copy = (SensorRemover) learner.copy();
        for (Instance instance : instances.subList(2000, 2800)) {
            double said = learner.getVotesForInstance(instance)[0];
            assertEquals(said, copy.getVotesForInstance(instance)[0]);
            assertEquals(said, copy.getVotesForInstance(instance)[0]);
            learner.trainOnInstance(instance);
            copy.trainOnInstance(instance);
        }
        String text = learner.getCLICreationString(Regressor.class);
        assertEquals(text, learner(text).getCLICreationString(Regressor.class));
    }

    @Tag("slow")
    @Test
    void moasOwnEvaluationTakesIt() throws Exception {
        Object result = ((MainTask) ClassOption.cliStringToObject("EvaluatePrequentialRegression -l (" + LEARNER + ") -s (" + STREAM
                + ") -i 3600 -f 1200", MainTask.class, null)).doTask();
        assertTrue(result.toString().contains("windows learned"), result.toString());
    }

    @Tag("slow")
    @Test
    void trainedPolygonsAreFollowed(@TempDir Path folder) throws Exception {
        Layout layout = null;
        PoleTraining training = null;
        for (int subject = 2; subject <= 3; subject++) {
            for (String level : List.of("0.6", "1.2")) {
                Recording recording = RigSpec.parse("subject=" + subject + " excitation=random:z:0.5-12:" + level + " seconds=35 seed="
                        + (subject + level.charAt(2)) + " channels=" + CHANNELS + ",head.acc.z").recording();
                if (training == null) {
                    layout = Layout.along('z', "platform", "seat", List.of("head"), recording.channels());
                    training = new PoleTraining(layout, new PoleWindows(15, 5, 4));
                }
                training.add(training.examine(subject + " at " + level, recording));
            }
        }
        Path file = Files.writeString(folder.resolve("polygons.json"), PolygonFile.text(training.finish().trained(), Map.of()));
        SensorRemover learner = learner("wbv.learn.SensorRemover -p " + file);
        SensorRemover response = learner("wbv.learn.SensorRemover -g response -p " + file);
        for (SensorRemover each : List.of(learner, response)) {
            removed(each, 0, 1800);
            assertTrue(share(removed(each, 1800, 3600), 1800) < 0.1, "a stranger, from the first sample without a sensor");
        }
        Measurement[] known = learner.getModelMeasurements();
        double[] values = new double[known.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = known[i].getValue();
        }
        assertEquals("natural frequency [Hz]", known[6].getName());
        assertTrue(values[6] > values[7] && values[6] < values[8], values[6] + " within " + values[7] + " to " + values[8]);
    }

    @Test
    void whatItCannotReadIsSaid() throws Exception {
        IllegalArgumentException wrong = assertThrows(IllegalArgumentException.class,
                () -> learner(LEARNER + " -m pelvis.acc.z").trainOnInstance(instances.get(0)));
        assertTrue(wrong.getMessage().contains("no attribute pelvis.acc.z"), wrong.getMessage());
    }
}

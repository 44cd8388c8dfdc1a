package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.yahoo.labs.samoa.instances.Instance;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import moa.classifiers.Regressor;
import moa.core.Measurement;
import moa.options.ClassOption;
import moa.tasks.MainTask;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import wbv.network.WithEngine;
import wbv.stream.RigStream;

class SpectrogramRegressorTest {

    private static final String EXPERIMENT = "wbv.stream.RigStream -e 'sitter=one-dof zeta=0.3 f0=5.5 seconds=%s%s'";

    @BeforeAll
    static void needsTheEngine() {
        WithEngine.orSkip();
    }

    @Test
    void predictsTheBodyOfTheStream() throws Exception {
        SpectrogramRegressor frequency = learner("wbv.learn.SpectrogramRegressor");
        SpectrogramRegressor damping = learner("wbv.learn.SpectrogramRegressor -t damping -i platform.acc.z");
        List<Instance> instances = instances("30", "");
        List<Double> said = new ArrayList<>();
        for (Instance instance : instances) {
            frequency.trainOnInstance(instance);
            damping.trainOnInstance(instance);
            if (frequency.looks() > 0) {
                said.add(frequency.getVotesForInstance(instance)[0]);
            }
        }
        assertTrue(frequency.looks() > 45, frequency.looks() + " looks in 26 s, two a second");
        assertEquals(5.5, said.stream().mapToDouble(f -> f).average().orElseThrow(), 0.3);
        assertEquals(0.3, damping.getVotesForInstance(instances.get(0))[0], 0.1);
    }

    @Test
    void beforeTheFirstWindowItSaysTheMeanOfAllAndAfterAResetTheSameAgain() throws Exception {
        SpectrogramRegressor learner = learner("wbv.learn.SpectrogramRegressor -h 20");
        List<Instance> instances = instances("8", "");
        double before = learner.getVotesForInstance(instances.get(0))[0];
        assertTrue(before > 4 && before < 7, "the middle of 2 to 9 Hz: " + before);
        double[] first = run(learner, instances);
        learner.resetLearning();
        assertEquals(Arrays.toString(first), Arrays.toString(run(learner, instances)));
    }

    @Test
    void aCopyGoesOnAsTheOriginalWould() throws Exception {
        SpectrogramRegressor learner = learner("wbv.learn.SpectrogramRegressor -h 10");
        List<Instance> instances = instances("10", "");
        run(learner, instances.subList(0, 300));
        SpectrogramRegressor copy = (SpectrogramRegressor) learner.copy();
        List<Instance> rest = instances.subList(300, instances.size());
        assertEquals(Arrays.toString(run(learner, rest)), Arrays.toString(run(copy, rest)));
    }

    @Test
    void lostPacketsAreBridgedAndLongGapsAreWaitedFor() throws Exception {
        SpectrogramRegressor learner = learner("wbv.learn.SpectrogramRegressor -h 1");
        List<Instance> instances = instances("10", "");
        for (int i = 0; i < instances.size(); i++) {
            if (i == 100 || i == 101 || i >= 400 && i < 420) {
                instances.get(i).setValue(1, Double.NaN);
            }
            learner.trainOnInstance(instances.get(i));
        }
        // Full from sample 226 (219 and 8 of delay) to the gap at 400, and not again until 219 samples after it.
        assertEquals((408 - 226) * 1.0, learner.looks(), 2);
        for (Measurement each : learner.getModelMeasurements()) {
            assertTrue(Double.isFinite(each.getValue()), each.getName());
        }
    }

    @Test
    void otherRatesAreRefused() throws Exception {
        SpectrogramRegressor learner = learner("wbv.learn.SpectrogramRegressor");
        List<Instance> instances = instances("2", " rate=100");
        learner.trainOnInstance(instances.get(0));
        assertThrows(IllegalArgumentException.class, () -> learner.trainOnInstance(instances.get(1)));
    }

    @Test
    void moaRunsIt() throws Exception {
        MainTask task = (MainTask) ClassOption.cliStringToObject("EvaluatePrequentialRegression "
                + "-l wbv.learn.SpectrogramRegressor -s (" + String.format(EXPERIMENT, "10", "")
                + ") -i 500 -f 250", MainTask.class, null);
        task.prepareForUse();
        String curve = task.doTask().toString();
        assertTrue(curve.contains("natural frequency [Hz]"), curve);
    }

    private static double[] run(SpectrogramRegressor learner, List<Instance> instances) {
        return instances.stream().mapToDouble(instance -> {
            learner.trainOnInstance(instance);
            return learner.getVotesForInstance(instance)[0];
        }).toArray();
    }

    private static SpectrogramRegressor learner(String text) throws Exception {
        SpectrogramRegressor learner = (SpectrogramRegressor) ClassOption.cliStringToObject(text, Regressor.class, null);
        learner.prepareForUse();
        learner.resetLearning();
        return learner;
    }

    private static List<Instance> instances(String seconds, String more) throws Exception {
        RigStream stream = (RigStream) ClassOption.cliStringToObject(String.format(EXPERIMENT, seconds, more),
                moa.streams.InstanceStream.class, null);
        stream.prepareForUse();
        List<Instance> instances = new ArrayList<>();
        while (stream.hasMoreInstances()) {
            instances.add(stream.nextInstance().getData());
        }
        return instances;
    }
}

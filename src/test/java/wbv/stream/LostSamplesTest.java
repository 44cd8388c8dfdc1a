package wbv.stream;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.yahoo.labs.samoa.instances.Instance;
import java.io.OutputStream;
import java.io.PrintStream;
import moa.classifiers.Classifier;
import moa.options.AbstractOptionHandler;
import moa.options.ClassOption;
import moa.streams.InstanceStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** MOA's own regressors on a ride of which 1 % of packets was lost. */
class LostSamplesTest {

    private static final String RIDE = "wbv.stream.RecordingStream -f data/arff/ride-subject1.arff -i platform.acc.z -o head.acc.z";

    private static InstanceStream stream(String cli) throws Exception {
        AbstractOptionHandler stream = (AbstractOptionHandler) ClassOption.cliStringToObject(cli, InstanceStream.class, null);
        stream.prepareForUse();
        return (InstanceStream) stream;
    }

    /**
     * Runs a regressor over a stream, test then train; some of MOA's print as they go.
     *
     * @return instances foreseen, all by finite numbers
     */
    private static int foreseen(InstanceStream stream, String cli) throws Exception {
        Classifier learner = (Classifier) ClassOption.cliStringToObject(cli, Classifier.class, null);
        learner.setModelContext(stream.getHeader());
        learner.prepareForUse();
        PrintStream out = System.out;
        System.setOut(new PrintStream(OutputStream.nullOutputStream()));
        try {
            int foreseen = 0;
            for (int i = 0; stream.hasMoreInstances(); i++) {
                Instance instance = stream.nextInstance().getData();
                double[] votes = learner.getVotesForInstance(instance);
                assertTrue(votes.length == 0 || i < 2 || Double.isFinite(votes[0]), () -> cli + " after " + instance);
                learner.trainOnInstance(instance);
                foreseen++;
            }
            return foreseen;
        } finally {
            System.setOut(out);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"trees.FIMTDD", "rules.AMRulesRegressor", "rules.functions.Perceptron"})
    void regressorsOfMoaRunWhereInstancesThatLackAValueAreLeftOut(String name) throws Exception {
        runs(name);
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"trees.ORTO", "functions.SGD", "functions.AdaGrad", "rules.functions.TargetMean",
        "rules.functions.FadingTargetMean", "rules.functions.AdaptiveNodePredictor", "meta.RandomRules",
        "rules.functions.LowPassFilteredLearner", "meta.SelfOptimisingKNearestLeaves", "trees.SelfOptimisingBaseTree",
        "trees.ARFFIMTDD", "meta.AdaptiveRandomForestRegressor"})
    void soDoAllOthersOfThem(String name) throws Exception {
        runs(name);
    }

    private static void runs(String name) throws Exception {
        assertEquals(8825, foreseen(stream(RIDE + " -l skipped"), "moa.classifiers." + name), 20);
    }

    /** What the option is for: where MOA takes missing values itself one day, it can go. */
    @Test
    void aTreeOfMoaTakesNoMissingValues() {
        assertThrows(AssertionError.class, () -> foreseen(stream(RIDE), "moa.classifiers.trees.FIMTDD"));
    }

    @Test
    void whatIsLeftOutIsWhatLacksAValueAndNothingElse() throws Exception {
        InstanceStream all = stream(RIDE);
        InstanceStream some = stream(RIDE + " -l skipped");
        int lacking = 0;
        while (all.hasMoreInstances()) {
            Instance instance = all.nextInstance().getData();
            if (instance.classIsMissing() || instance.isMissing(1)) {
                lacking++;
                continue;
            }
            Instance same = some.nextInstance().getData();
            for (int i = 0; i < 3; i++) {
                assertEquals(instance.value(i), same.value(i), 0);
            }
        }
        assertFalse(some.hasMoreInstances());
        assertTrue(lacking > 100, lacking + " lack a value");
    }

    @Test
    void aStreamThatLeavesOutStartsAgainAndIsCopied() throws Exception {
        InstanceStream stream = stream(RIDE + " -l skipped");
        for (int i = 0; i < 500; i++) {
            stream.nextInstance();
        }
        InstanceStream copy = (InstanceStream) stream.copy();
        assertEquals(stream.nextInstance().getData().value(0), copy.nextInstance().getData().value(0), 0);
        stream.restart();
        assertEquals(0, stream.nextInstance().getData().value(0), 0.1);
    }
}

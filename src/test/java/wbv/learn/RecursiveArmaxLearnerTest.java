package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.yahoo.labs.samoa.instances.Instance;
import moa.classifiers.Regressor;
import moa.core.Measurement;
import moa.options.AbstractOptionHandler;
import moa.options.ClassOption;
import moa.streams.InstanceStream;
import org.junit.jupiter.api.Test;

/** ARMAX sample by sample as a MOA learner, on a body that is known. */
class RecursiveArmaxLearnerTest {

    @Test
    void theBodyIsFoundAndPredictingChangesNothing() throws Exception {
        RecursiveArmaxLearner learner = (RecursiveArmaxLearner) ClassOption.cliStringToObject("wbv.learn.RecursiveArmaxLearner",
                Regressor.class, null);
        learner.prepareForUse();
        learner.resetLearning();
        InstanceStream stream = (InstanceStream) ClassOption.cliStringToObject(
                "wbv.stream.RigStream -e 'sitter=one-dof zeta=0.35 f0=5 seconds=60 seed=3'", InstanceStream.class, null);
        ((AbstractOptionHandler) stream).prepareForUse();
        RecursiveArmaxLearner left = (RecursiveArmaxLearner) learner.copy();
        double error = 0;
        double power = 0;
        while (stream.hasMoreInstances()) {
            Instance instance = stream.nextInstance().getData();
            double said = learner.getVotesForInstance(instance)[0];
            assertEquals(said, learner.getVotesForInstance(instance)[0]);
            assertEquals(said, left.getVotesForInstance(instance)[0]);
            if (instance.value(0) > 20) {
                error += Math.pow(said - instance.classValue(), 2);
                power += Math.pow(instance.classValue(), 2);
            }
            learner.trainOnInstance(instance);
            left.trainOnInstance(instance);
        }
        assertTrue(error < 0.02 * power, "one step ahead: " + error / power);
        Measurement[] known = learner.getModelMeasurements();
        for (Measurement each : known) {
            if (each.getName().equals("natural frequency [Hz]")) {
                assertEquals(5, each.getValue(), 0.3);
            } else if (each.getName().equals("damping ratio [1]")) {
                assertEquals(0.35, each.getValue(), 0.05);
            }
        }
    }
}

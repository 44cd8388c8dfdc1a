package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.stream.Stream;
import moa.classifiers.Regressor;
import moa.options.ClassOption;
import org.junit.jupiter.api.DynamicContainer;
import org.junit.jupiter.api.DynamicNode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import wbv.filter.Method;

class BodyTrackerTest {

    private static final String STREAM = "wbv.stream.RigStream -e 'sitter=one-dof zeta=0.3 f0=5.5 seconds=20'";

    @TestFactory
    Stream<DynamicNode> keepsTheContractByEveryMethod() {
        return Stream.of(Method.values()).map(method -> {
            String bounds = method == Method.CONSTRAINED ? " -b frequency=2:9,damping=0.1:0.8" : "";
            return DynamicContainer.dynamicContainer(method.word(), new LearnerContract<>("wbv.learn.BodyTracker -m "
                    + method.word()
                    + " -i platform.acc.z -f 4.0 -d 0.3 -p 100" + bounds, STREAM, BodyTracker.class, BodyTracker::covariance,
                    learner -> learner.track().missing()).tests());
        });
    }

    @Test
    void aBoundThatIsNoneIsRefusedInWords() throws Exception {
        BodyTracker learner = (BodyTracker) ClassOption.cliStringToObject(
                "wbv.learn.BodyTracker -m constrained -b frequency=8:3", Regressor.class, null);
        IllegalArgumentException refused = assertThrows(IllegalArgumentException.class, learner::resetLearning);
        assertEquals("lower bound of frequency must be <= the upper: 8.0, 3.0", refused.getMessage());
    }
}

package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.yahoo.labs.samoa.instances.Attribute;
import com.yahoo.labs.samoa.instances.DenseInstance;
import com.yahoo.labs.samoa.instances.Instance;
import com.yahoo.labs.samoa.instances.Instances;
import com.yahoo.labs.samoa.instances.InstancesHeader;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import wbv.filter.SimulatedSitter;
import wbv.filter.SimulatedSitter.Motion;
import wbv.filter.model.Spec;

class AdwinKalmanTest {

    private static final SimulatedSitter SITTER = new SimulatedSitter(4.6, 0.33);

    @TestFactory
    Stream<DynamicTest> keepsTheContract() {
        return new LearnerContract<>("wbv.learn.AdwinKalman -i platform.acc.z -f 4.0 -d 0.3 -w 0.005",
                "wbv.stream.RigStream -e 'sitter=one-dof zeta=0.3 f0=5.5 seconds=20'", AdwinKalman.class,
                AdwinKalman::covariance, learner -> learner.track().missing()).tests();
    }

    private static InstancesHeader header(String... names) {
        List<Attribute> attributes = new ArrayList<>();
        for (String name : names) {
            attributes.add(new Attribute(name));
        }
        InstancesHeader header = new InstancesHeader(new Instances("test", attributes, 0));
        header.setClassIndex(names.length - 1);
        return header;
    }

    private static Instance instance(InstancesHeader header, double... values) {
        Instance instance = new DenseInstance(1, values);
        instance.setDataset(header);
        return instance;
    }

    private static AdwinKalman learner() {
        AdwinKalman learner = new AdwinKalman();
        learner.prepareForUse();
        learner.resetLearning();
        return learner;
    }

    @Test
    void timesSayTheRate() {
        Motion motion = SITTER.steady(0.8, 1500, 1).measured(Spec.noise(60), 1);
        InstancesHeader header = header("t", "base", "body");
        AdwinKalman learner = learner();
        learner.rateOption.setValue(200);
        learner.resetLearning();
        for (int i = 0; i < 1500; i++) {
            learner.trainOnInstance(instance(header, 7 + i / 60.0, motion.u()[i], motion.y()[i]));
        }
        assertEquals(60, learner.spec().rate(), 1e-9);
        assertEquals(SITTER.frequency(), learner.track().frequency(), 0.05);
    }

    @Test
    void holesInTheTimesAreMissingSamples() {
        Motion motion = SITTER.steady(0.8, 1500, 1).measured(Spec.noise(60), 1);
        InstancesHeader header = header("t", "base", "body");
        AdwinKalman learner = learner();
        int left = 0;
        for (int i = 0; i < 1500; i++) {
            if (i % 100 == 37 || i % 100 == 38) {
                left++;
            } else {
                learner.trainOnInstance(instance(header, i / 60.0, motion.u()[i], motion.y()[i]));
            }
        }
        assertEquals(left, learner.track().missing());
        assertEquals(SITTER.frequency(), learner.track().frequency(), 0.05);
        assertEquals(SITTER.damping(), learner.track().damping(), 0.01);
    }

    @Test
    void theInputIsChosenByNameOrNumber() {
        Motion motion = SITTER.steady(0.8, 1500, 1).measured(Spec.noise(60), 1);
        InstancesHeader header = header("noise", "base", "body");
        for (String choice : new String[] {"base", "2"}) {
            AdwinKalman learner = learner();
            learner.inputOption.setValue(choice);
            learner.resetLearning();
            for (int i = 0; i < 1500; i++) {
                learner.trainOnInstance(instance(header, i % 7, motion.u()[i], motion.y()[i]));
            }
            assertEquals(SITTER.frequency(), learner.track().frequency(), 0.05);
        }
        AdwinKalman learner = learner();
        learner.inputOption.setValue("elsewhere");
        learner.resetLearning();
        assertThrows(IllegalArgumentException.class, () -> learner.trainOnInstance(instance(header, 0, 0, 0)));
    }

    @Test
    void optionsAreFewAndWellFormed() {
        long options = Arrays.stream(AdwinKalman.class.getFields())
                .filter(field -> field.getType().getSimpleName().endsWith("Option"))
                .peek(field -> assertTrue(Modifier.isFinal(field.getModifiers()), field.getName())).count();
        assertTrue(options <= 7, options + " options");
    }

    @Test
    void theDescriptionSaysWhatIsKnown() {
        StringBuilder text = new StringBuilder();
        learner().getModelDescription(text, 0);
        assertTrue(text.toString().contains("natural frequency 5.000 ± 2.500 Hz"), text.toString());
        assertTrue(text.toString().contains("not settled"), text.toString());
    }
}

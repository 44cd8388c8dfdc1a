package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import com.yahoo.labs.samoa.instances.Instance;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import moa.classifiers.AbstractClassifier;
import moa.classifiers.Regressor;
import moa.core.Measurement;
import moa.options.AbstractOptionHandler;
import moa.options.ClassOption;
import moa.streams.InstanceStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.junit.jupiter.api.DynamicTest;

/**
 * What every learner of ours keeps, as tests. A test class returns {@link #tests} from a {@code @TestFactory}.
 *
 * @param cli        the learner with options that differ from the defaults
 * @param stream     a stream of at least a thousand instances for it
 * @param covariance the learner's covariance matrix, row by row
 * @param missing    how many instances it has counted as missing
 */
public record LearnerContract<L extends AbstractClassifier & Regressor>(String cli, String stream, Class<L> type,
        Function<L, double[]> covariance, ToDoubleFunction<L> missing) {

    private static final int INSTANCES = 1000;

    /** One test for each promise. */
    public Stream<DynamicTest> tests() {
        return Stream.of(
                DynamicTest.dynamicTest("resetReplays", this::resetReplays),
                DynamicTest.dynamicTest("commandLineRoundTrips", this::commandLineRoundTrips),
                DynamicTest.dynamicTest("copyPredictsTheSame", this::copyPredictsTheSame),
                DynamicTest.dynamicTest("predictingChangesNothing", this::predictingChangesNothing),
                DynamicTest.dynamicTest("nothingIsPrinted", this::nothingIsPrinted),
                DynamicTest.dynamicTest("missingValuesAreToleratedAndCounted", this::missingValuesAreToleratedAndCounted),
                DynamicTest.dynamicTest("covarianceIsSymmetricAndPositive", this::covarianceIsSymmetricAndPositive),
                DynamicTest.dynamicTest("measurementsKeepTheirNames", this::measurementsKeepTheirNames),
                DynamicTest.dynamicTest("trainingAllocatesNothing", this::trainingAllocatesNothing));
    }

    private L learner() {
        return learner(cli);
    }

    private L learner(String text) {
        try {
            L learner = type.cast(ClassOption.cliStringToObject(text, Regressor.class, null));
            learner.prepareForUse();
            learner.resetLearning();
            return learner;
        } catch (Exception wrong) {
            throw new IllegalArgumentException(text, wrong);
        }
    }

    private List<Instance> instances() {
        try {
            InstanceStream source = (InstanceStream) ClassOption.cliStringToObject(stream, InstanceStream.class, null);
            ((AbstractOptionHandler) source).prepareForUse();
            List<Instance> instances = new ArrayList<>();
            while (instances.size() < INSTANCES) {
                instances.add(source.nextInstance().getData());
            }
            return instances;
        } catch (Exception wrong) {
            throw new IllegalArgumentException(stream, wrong);
        }
    }

    /** Predictions, each before its instance is learned from. */
    private double[] run(L learner, List<Instance> instances) {
        return instances.stream().mapToDouble(instance -> {
            double prediction = learner.getVotesForInstance(instance)[0];
            learner.trainOnInstance(instance);
            return prediction;
        }).toArray();
    }

    private void resetReplays() {
        L learner = learner();
        List<Instance> instances = instances();
        double[] first = run(learner, instances);
        assertTrue(Math.abs(first[INSTANCES - 1]) > 0, "predicts something");
        learner.resetLearning();
        assertArrayEquals(first, run(learner, instances), 0);
    }

    private void commandLineRoundTrips() {
        L learner = learner();
        String text = learner.getCLICreationString(Regressor.class);
        L again = learner(text);
        assertEquals(text, again.getCLICreationString(Regressor.class));
        assertArrayEquals(run(learner, instances()), run(again, instances()), 0);
    }

    private void copyPredictsTheSame() {
        L learner = learner();
        List<Instance> instances = instances();
        run(learner, instances.subList(0, INSTANCES / 2));
        L copy = type.cast(learner.copy());
        List<Instance> rest = instances.subList(INSTANCES / 2, INSTANCES);
        double[] expected = run(learner, rest);
        assertArrayEquals(expected, run(copy, rest), 0);
    }

    private void predictingChangesNothing() {
        L asked = learner();
        L left = learner();
        for (Instance instance : instances()) {
            asked.getVotesForInstance(instance);
            asked.getVotesForInstance(instance);
            asked.trainOnInstance(instance);
            left.trainOnInstance(instance);
        }
        assertArrayEquals(covariance.apply(left), covariance.apply(asked), 0);
    }

    private void nothingIsPrinted() {
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        PrintStream before = System.out;
        System.setOut(new PrintStream(printed, true));
        try {
            L learner = learner();
            run(learner, instances());
            learner.getModelDescription(new StringBuilder(), 0);
        } finally {
            System.setOut(before);
        }
        assertEquals(0, printed.size());
    }

    private void missingValuesAreToleratedAndCounted() {
        L learner = learner();
        Random random = new Random(1);
        int lost = 0;
        for (Instance instance : instances()) {
            int attribute = 1 + random.nextInt(instance.numAttributes() - 1);
            if (random.nextInt(10) == 0) {
                instance.setValue(attribute, Double.NaN);
                lost++;
            }
            assertTrue(Double.isFinite(learner.getVotesForInstance(instance)[0]), "finite prediction");
            learner.trainOnInstance(instance);
        }
        assertEquals(lost, missing.applyAsDouble(learner));
    }

    private void covarianceIsSymmetricAndPositive() {
        L learner = learner();
        run(learner, instances());
        double[] values = covariance.apply(learner);
        int n = (int) Math.round(Math.sqrt(values.length));
        DMatrixRMaj p = DMatrixRMaj.wrap(n, n, values);
        assertTrue(MatrixFeatures_DDRM.isSymmetric(p, 0));
        assertTrue(MatrixFeatures_DDRM.isPositiveDefinite(p));
    }

    private void measurementsKeepTheirNames() {
        L learner = learner();
        List<String> before = names(learner);
        run(learner, instances());
        assertEquals(before, names(learner));
    }

    private List<String> names(L learner) {
        return Stream.of(learner.getModelMeasurements()).map(Measurement::getName).toList();
    }

    /** Not counting the window of a detector, or of several, which may take another row of buckets now and then. */
    private void trainingAllocatesNothing() {
        L learner = learner();
        List<Instance> instances = instances();
        for (int warm = 0; warm < 20; warm++) {
            run(learner, instances);
        }
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long before = threads.getThreadAllocatedBytes(id);
        for (int i = 0; i < INSTANCES; i++) {
            learner.trainOnInstance(instances.get(i));
        }
        double bytes = (threads.getThreadAllocatedBytes(id) - before) / (double) INSTANCES;
        assertTrue(bytes < 8, bytes + " bytes a sample");
    }
}

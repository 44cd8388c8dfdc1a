package wbv.filter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Random;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.junit.jupiter.api.DynamicContainer;
import org.junit.jupiter.api.DynamicNode;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import wbv.filter.SimulatedSitter.Motion;
import wbv.filter.model.Spec;

/** What every estimator keeps, by every method, of one and of two degrees of freedom. */
class EstimatorContractTest {

    private static final SimulatedSitter SITTER = new SimulatedSitter(4.6, 0.33);
    private static final double NOISE = Spec.noise(SimulatedSitter.RATE);

    @TestFactory
    Stream<DynamicNode> everyEstimatorKeepsTheContract() {
        return Arrays.stream(Method.values()).flatMap(method -> Stream.of(1, 2).map(degrees -> {
            EstimatorDesign design = EstimatorDesign.of(method).withDegrees(degrees).withParticles(200);
            return DynamicContainer.dynamicContainer(method.word() + ", " + degrees + " degrees", Stream.of(
                    test("resetReplays", design, EstimatorContractTest::resetReplays),
                    test("aCopyContinuesAlike", design, EstimatorContractTest::aCopyContinuesAlike),
                    test("predictingChangesNothing", design, EstimatorContractTest::predictingChangesNothing),
                    test("missingSamplesAreToleratedAndCounted", design,
                            EstimatorContractTest::missingSamplesAreToleratedAndCounted),
                    test("aGapOfTenSecondsKeepsTheParameters", design, EstimatorContractTest::aGapOfTenSecondsKeepsTheParameters),
                    test("aChannelThatDiesLeavesTheParameters", design,
                            EstimatorContractTest::aChannelThatDiesLeavesTheParameters),
                    test("aConstantInputHoldsTheParameters", design, EstimatorContractTest::aConstantInputHoldsTheParameters),
                    test("theCovarianceStaysSymmetricAndPositive", design,
                            EstimatorContractTest::theCovarianceStaysSymmetricAndPositive),
                    test("nothingIsAllocatedPerSample", design, EstimatorContractTest::nothingIsAllocatedPerSample)));
        }));
    }

    private static DynamicTest test(String name, EstimatorDesign design, Consumer<EstimatorDesign> law) {
        return DynamicTest.dynamicTest(name, () -> law.accept(design));
    }

    private static Estimator estimator(EstimatorDesign design) {
        return design.estimator(Spec.at(SimulatedSitter.RATE), Silent::new);
    }

    /** Of two modes where the body is to have two: half of each. */
    private static Motion motion(EstimatorDesign design, int samples) {
        Motion first = SITTER.steady(0.8, samples, 5);
        if (design.degrees() == 1) {
            return first.measured(NOISE, 5);
        }
        Motion second = new SimulatedSitter(10, 0.25).steady(0.8, samples, 5);
        double[] y = new double[samples];
        Arrays.setAll(y, i -> 0.6 * first.y()[i] + 0.4 * second.y()[i]);
        return new Motion(first.u(), y).measured(NOISE, 5);
    }

    private static double[] run(Estimator estimator, Motion motion, int from, int to) {
        double[] seen = new double[4 * (to - from)];
        for (int i = from; i < to; i++) {
            BodyEstimate track = estimator.step(motion.u()[i], motion.y()[i]);
            int at = 4 * (i - from);
            seen[at] = track.frequency();
            seen[at + 1] = track.damping();
            seen[at + 2] = track.frequencyDeviation();
            seen[at + 3] = track.prediction();
        }
        return seen;
    }

    private static void resetReplays(EstimatorDesign design) {
        Estimator estimator = estimator(design);
        Motion motion = motion(design, 900);
        double[] first = run(estimator, motion, 0, 900);
        assertNotEquals(first[0], first[4 * 899], "something is estimated");
        estimator.reset();
        assertTrue(Arrays.equals(first, run(estimator, motion, 0, 900)));
    }

    private static void aCopyContinuesAlike(EstimatorDesign design) {
        Estimator estimator = estimator(design);
        Motion motion = motion(design, 900);
        run(estimator, motion, 0, 450);
        Estimator copy = estimator.copy();
        double[] original = run(estimator, motion, 450, 900);
        assertTrue(Arrays.equals(original, run(copy, motion, 450, 900)));
    }

    private static void predictingChangesNothing(EstimatorDesign design) {
        Estimator asked = estimator(design);
        Estimator left = estimator(design);
        Motion motion = motion(design, 600);
        for (int i = 0; i < 600; i++) {
            double foreseen = asked.predict(motion.u()[i]);
            assertEquals(foreseen, asked.predict(motion.u()[i]), 0);
            assertEquals(foreseen, asked.step(motion.u()[i], motion.y()[i]).prediction(), 0);
            left.step(motion.u()[i], motion.y()[i]);
        }
        assertTrue(Arrays.equals(asked.covariance(), left.covariance()));
    }

    private static void missingSamplesAreToleratedAndCounted(EstimatorDesign design) {
        Estimator estimator = estimator(design);
        Motion motion = motion(design, 1800);
        Random random = new Random(9);
        long missing = 0;
        for (int i = 0; i < 1800; i++) {
            boolean noInput = random.nextInt(50) == 0;
            boolean noOutput = random.nextInt(15) == 0;
            missing += noInput || noOutput ? 1 : 0;
            BodyEstimate track = estimator.step(noInput ? Double.NaN : motion.u()[i], noOutput ? Double.NaN : motion.y()[i]);
            assertTrue(Double.isFinite(track.frequency()) && Double.isFinite(track.dampingDeviation()), "finite at " + i);
        }
        assertEquals(missing, estimator.track().missing());
        assertEquals(0, estimator.track().gaps());
        near(design, estimator.track(), 0.1);
    }

    private static void near(EstimatorDesign design, BodyEstimate track, double tolerance) {
        if (design.degrees() == 1) {
            assertEquals(1, track.frequency() / SITTER.frequency(), tolerance);
            assertEquals(1, track.damping() / SITTER.damping(), 2 * tolerance);
        }
    }

    private static void aGapOfTenSecondsKeepsTheParameters(EstimatorDesign design) {
        Estimator estimator = estimator(design);
        Motion motion = motion(design, 3000);
        run(estimator, motion, 0, 1500);
        double frequency = estimator.track().frequency();
        double deviation = estimator.track().frequencyDeviation();
        for (int i = 0; i < 600; i++) {
            assertTrue(Double.isFinite(estimator.step(Double.NaN, Double.NaN).prediction()), "finite at " + i);
        }
        assertEquals(1, estimator.track().gaps());
        assertEquals(1, estimator.track().frequency() / frequency, 2e-3);
        assertTrue(estimator.track().frequencyDeviation() > deviation, "less is known after ten seconds");
        run(estimator, motion, 2100, 3000);
        near(design, estimator.track(), 0.1);
    }

    private static void aChannelThatDiesLeavesTheParameters(EstimatorDesign design) {
        Estimator estimator = estimator(design);
        Motion motion = motion(design, 3600);
        run(estimator, motion, 0, 1500);
        double frequency = estimator.track().frequency();
        double deviation = estimator.track().frequencyDeviation();
        for (int i = 1500; i < 3600; i++) {
            BodyEstimate track = estimator.step(motion.u()[i], Double.NaN);
            assertTrue(Double.isFinite(track.prediction()), "foreseen at " + i);
            assertEquals(1, track.frequency() / frequency, 0.05);
        }
        assertEquals(2100, estimator.track().missing());
        assertTrue(estimator.track().frequencyDeviation() > deviation);
    }

    private static void aConstantInputHoldsTheParameters(EstimatorDesign design) {
        Estimator estimator = estimator(design);
        Motion motion = SITTER.fading(0.8, 34, 30, 5).measured(NOISE, 5);
        run(estimator, motion, 0, 34 * 60);
        double frequency = estimator.track().frequency();
        for (int i = 0; i < 3000; i++) {
            estimator.step(0, 0);
        }
        assertEquals(1, estimator.track().frequency() / frequency, 0.02);
        if (design.method() != Method.EKF) {
            assertTrue(!estimator.track().excited(), "said that nothing is learned");
        }
    }

    private static void theCovarianceStaysSymmetricAndPositive(EstimatorDesign design) {
        Estimator estimator = estimator(design);
        Motion motion = motion(design, 1200);
        Random random = new Random(3);
        for (int i = 0; i < 1200; i++) {
            estimator.step(random.nextInt(20) == 0 ? Double.NaN : motion.u()[i], random.nextInt(20) == 0 ? Double.NaN
                    : motion.y()[i]);
            if (i % 7 == 0) {
                double[] values = estimator.covariance();
                int n = (int) Math.round(Math.sqrt(values.length));
                DMatrixRMaj p = DMatrixRMaj.wrap(n, n, values);
                assertTrue(MatrixFeatures_DDRM.isSymmetric(p, 0), "symmetric at " + i);
                assertTrue(MatrixFeatures_DDRM.isPositiveDefinite(scaled(p)), "positive at " + i);
            }
        }
    }

    private static DMatrixRMaj scaled(DMatrixRMaj p) {
        DMatrixRMaj to = p.copy();
        for (int r = 0; r < p.numRows; r++) {
            for (int c = 0; c < p.numCols; c++) {
                to.set(r, c, p.get(r, c) / Math.sqrt(p.get(r, r) * p.get(c, c)));
            }
        }
        return to;
    }

    private static void nothingIsAllocatedPerSample(EstimatorDesign design) {
        Estimator estimator = estimator(design);
        Motion motion = motion(design, 1500);
        for (int warm = 0; warm < (design.method() == Method.FUSED ? 3 : 8); warm++) {
            feed(estimator, motion);
        }
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long before = threads.getThreadAllocatedBytes(id);
        feed(estimator, motion);
        double bytes = (threads.getThreadAllocatedBytes(id) - before) / 1500.0;
        assertTrue(bytes < 4, bytes + " bytes a sample");
    }

    private static void feed(Estimator estimator, Motion motion) {
        for (int i = 0; i < motion.u().length; i++) {
            estimator.step(motion.u()[i], motion.y()[i]);
        }
    }
}

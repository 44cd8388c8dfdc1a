package wbv.filter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.filter.SimulatedSitter.Motion;
import wbv.filter.model.Spec;

class BodyEstimatorTest {

    private static final double NOISE = Spec.noise(SimulatedSitter.RATE);
    private static final SimulatedSitter SITTER = new SimulatedSitter(4.6, 0.33);

    private static BodyEstimator estimator() {
        return new BodyEstimator(Spec.at(SimulatedSitter.RATE), new Silent());
    }

    private static Motion motion(int samples) {
        return SITTER.steady(0.8, samples, 5).measured(NOISE, 5);
    }

    private static void feed(BodyEstimator estimator, Motion motion, int from, int to) {
        for (int i = from; i < to; i++) {
            estimator.step(motion.u()[i], motion.y()[i]);
        }
    }

    private static void assertNear(SimulatedSitter truth, BodyEstimate track, double tolerance) {
        assertEquals(1, track.frequency() / truth.frequency(), tolerance, "natural frequency");
        assertEquals(1, track.damping() / truth.damping(), tolerance, "damping ratio");
    }

    @Test
    void deviationsCoverTheErrors() {
        int covered = 0;
        for (long seed = 0; seed < 50; seed++) {
            SimulatedSitter sitter = SimulatedSitter.of(seed);
            BodyEstimator estimator = estimator();
            Motion motion = sitter.steady(0.8, 3600, seed).measured(NOISE, seed);
            feed(estimator, motion, 0, 3600);
            BodyEstimate track = estimator.track();
            double f = (track.frequency() - sitter.frequency()) / track.frequencyDeviation();
            double z = (track.damping() - sitter.damping()) / track.dampingDeviation();
            covered += (Math.abs(f) < 2 ? 1 : 0) + (Math.abs(z) < 2 ? 1 : 0);
        }
        // 95 % of 100 with a right model: under binomial spread, 88 and more; the assumed drift makes it wider, not narrower
        assertTrue(covered >= 88, covered + " of 100 within two standard deviations");
    }

    @Test
    void theInnovationsOfARightModelAreConsistent() {
        BodyEstimator estimator = estimator();
        Motion motion = motion(20000);
        feed(estimator, motion, 0, 2000);
        double sum = 0;
        for (int i = 2000; i < 20000; i++) {
            sum += estimator.step(motion.u()[i], motion.y()[i]).nis();
        }
        assertEquals(1, sum / 18000, 0.15);
    }

    /** A second mode near the first: the model of one degree of freedom misses a fifth to a half of the motion. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void theInnovationsOfAWrongModelAreConsistentToo(long seed) {
        Motion first = SITTER.steady(0.8, 12000, seed);
        Motion second = new SimulatedSitter(8, 0.3).steady(0.8, 12000, seed);
        double[] mixed = new double[12000];
        double power = 0;
        double beside = 0;
        for (int i = 0; i < mixed.length; i++) {
            mixed[i] = 0.7 * first.y()[i] + 0.3 * second.y()[i];
            power += mixed[i] * mixed[i];
            beside += Math.pow(mixed[i] - first.y()[i], 2);
        }
        assertTrue(Math.sqrt(beside / power) > 0.2, "the model must be wrong");
        Motion motion = new Motion(first.u(), mixed).measured(NOISE, seed);
        BodyEstimator estimator = estimator();
        feed(estimator, motion, 0, 1200);
        double sum = 0;
        for (int i = 1200; i < mixed.length; i++) {
            sum += estimator.step(motion.u()[i], motion.y()[i]).nis();
        }
        assertEquals(1, sum / (mixed.length - 1200), 0.25);
        assertEquals(0, estimator.track().divergences());
        assertTrue(estimator.track().outputNoise() > 5 * NOISE, "model error is noticed");
        assertTrue(estimator.track().frequency() > 4 && estimator.track().frequency() < 8,
                "between the modes: " + estimator.track().frequency());
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void theCovarianceStaysSymmetricAndPositive(long seed) {
        BodyEstimator estimator = estimator();
        Motion motion = SimulatedSitter.of(seed).steady(0.8, 3000, seed).measured(NOISE, seed);
        Random random = new Random(seed);
        for (int i = 0; i < 3000; i++) {
            boolean lost = random.nextInt(10) == 0;
            estimator.step(lost ? Double.NaN : motion.u()[i], random.nextInt(10) == 0 ? Double.NaN : motion.y()[i]);
            DMatrixRMaj p = DMatrixRMaj.wrap(5, 5, estimator.covariance());
            assertTrue(MatrixFeatures_DDRM.isSymmetric(p, 0), "symmetric at " + i);
            for (int r = 0; r < 5; r++) {
                double scale = 1 / Math.sqrt(p.get(r, r));
                for (int c = 0; c < 5; c++) {
                    p.set(r, c, p.get(r, c) * scale);
                    p.set(c, r, p.get(c, r) * scale);
                }
            }
            assertTrue(MatrixFeatures_DDRM.isPositiveDefinite(p), "positive at " + i);
        }
    }

    @Test
    void gravityAndBiasChangeNothing() {
        Motion motion = motion(1800);
        BodyEstimator plain = estimator();
        BodyEstimator tilted = estimator();
        for (int i = 0; i < 1800; i++) {
            plain.step(motion.u()[i], motion.y()[i]);
            tilted.step(motion.u()[i] + 9.81, motion.y()[i] + 9.5);
        }
        assertNear(SITTER, tilted.track(), 0.01);
        assertEquals(plain.track().frequency(), tilted.track().frequency(), 1e-9);
        assertEquals(plain.track().prediction() + 9.5, tilted.track().prediction(), 1e-8);
    }

    @Test
    void thePredictionUsesThePresentInputOnly() {
        BodyEstimator estimator = estimator();
        Motion motion = motion(3000);
        double error = 0;
        double power = 0;
        feed(estimator, motion, 0, 1200);
        for (int i = 1200; i < 3000; i++) {
            double foreseen = estimator.predict(motion.u()[i]);
            assertEquals(foreseen, estimator.step(motion.u()[i], motion.y()[i]).prediction(), 0);
            error += Math.pow(foreseen - motion.y()[i], 2);
            power += motion.y()[i] * motion.y()[i];
        }
        assertTrue(Math.sqrt(error / power) < 0.05, "NRMSE " + Math.sqrt(error / power));
    }

    @Test
    void withoutExcitationParametersHoldAndTheirDeviationsGrow() {
        BodyEstimator estimator = estimator();
        Motion motion = SITTER.fading(0.8, 34, 30, 5).measured(NOISE, 5);
        feed(estimator, motion, 0, 34 * 60);
        double frequency = estimator.track().frequency();
        double damping = estimator.track().damping();
        double deviation = estimator.track().frequencyDeviation();
        Random random = new Random(3);
        for (int i = 0; i < 36000; i++) {
            estimator.step(NOISE * random.nextGaussian(), NOISE * random.nextGaussian());
        }
        assertEquals(1, estimator.track().frequency() / frequency, 0.01);
        assertEquals(1, estimator.track().damping() / damping, 0.01);
        // uncertainty grows as the assumed drift says: 0.3 % in a second, as a random walk
        double drifted = estimator.track().frequency() * Spec.DRIFT * Math.sqrt(600);
        assertEquals(Math.hypot(deviation, drifted), estimator.track().frequencyDeviation(), 0.02 * drifted);
        assertFalse(estimator.track().excited());
        assertEquals(0, estimator.track().divergences());
    }

    /** Motion far below the resonance passes through the body as it is and tells nothing about it. */
    @Test
    void slowMotionTellsNothingAndDoesNoHarm() {
        BodyEstimator estimator = estimator();
        feed(estimator, motion(1800), 0, 1800);
        for (int i = 0; i < 36000; i++) {
            double slow = 0.02 * Math.sin(2 * Math.PI * 0.3 * i / 60);
            estimator.step(slow, slow);
        }
        assertNear(SITTER, estimator.track(), 0.05);
    }

    @Test
    void missingSamplesAreBridgedAndCounted() {
        BodyEstimator estimator = estimator();
        Motion motion = motion(2400);
        Random random = new Random(9);
        long missing = 0;
        for (int i = 0; i < 2400; i++) {
            boolean noInput = random.nextInt(25) == 0;
            boolean noOutput = random.nextInt(10) == 0;
            missing += noInput || noOutput ? 1 : 0;
            estimator.step(noInput ? Double.NaN : motion.u()[i], noOutput ? Double.NaN : motion.y()[i]);
        }
        assertEquals(missing, estimator.track().missing());
        assertEquals(0, estimator.track().gaps());
        assertNear(SITTER, estimator.track(), 0.05);
    }

    @Test
    void aLongGapRestartsTheMotionAndKeepsTheParameters() {
        BodyEstimator estimator = estimator();
        Motion motion = motion(4000);
        feed(estimator, motion, 0, 1800);
        double frequency = estimator.track().frequency();
        for (int i = 0; i < 600; i++) {
            estimator.step(Double.NaN, Double.NaN);
        }
        assertEquals(1, estimator.track().gaps());
        assertEquals(frequency, estimator.track().frequency(), 1e-12);
        feed(estimator, motion, 3000, 4000);
        assertEquals(1, estimator.track().gaps());
        assertEquals(0, estimator.track().divergences());
        assertNear(SITTER, estimator.track(), 0.02);
    }

    @Test
    void aRecordingThatBeginsWithNothingIsWaitedFor() {
        BodyEstimator estimator = estimator();
        for (int i = 0; i < 100; i++) {
            estimator.step(Double.NaN, i % 2 == 0 ? Double.NaN : 1);
        }
        feed(estimator, motion(1500), 0, 1500);
        assertNear(SITTER, estimator.track(), 0.02);
    }

    @Test
    void aGlitchDoesNotThrowItOff() {
        BodyEstimator estimator = estimator();
        Motion motion = motion(2400);
        feed(estimator, motion, 0, 1500);
        for (int i = 1500; i < 2400; i++) {
            BodyEstimate track = estimator.step(motion.u()[i], i == 1600 ? 300 : motion.y()[i]);
            assertNear(SITTER, track, 0.1);
        }
        assertNear(SITTER, estimator.track(), 0.03);
    }

    @Test
    void nonsenseIsCountedAndRecoveredFrom() {
        BodyEstimator estimator = estimator();
        Random random = new Random(4);
        double walk = 0;
        for (int i = 0; i < 6000; i++) {
            walk += 1e6 * random.nextGaussian();
            BodyEstimate track = estimator.step(i % 7 == 0 ? 1e8 * random.nextGaussian() : Double.POSITIVE_INFINITY, walk);
            assertTrue(Double.isFinite(track.frequency()) && Double.isFinite(track.damping())
                    && Double.isFinite(track.frequencyDeviation()), "finite at " + i);
        }
        for (int i = 0; i < 6000; i++) {
            BodyEstimate track = estimator.step(random.nextGaussian(), random.nextGaussian());
            assertTrue(track.frequency() >= Spec.LEAST_FREQUENCY && track.frequency() <= Spec.MOST_FREQUENCY);
            assertTrue(track.damping() >= Spec.LEAST_DAMPING && track.damping() <= Spec.MOST_DAMPING);
        }
        long divergences = estimator.track().divergences();
        assertTrue(divergences > 0, "unrelated signals have no body");
        assertTrue(divergences < 20, "no storm in 200 s: " + divergences);
        Motion motion = motion(9000);
        feed(estimator, motion, 0, 9000);
        assertNear(SITTER, estimator.track(), 0.02);
    }

    @Test
    void aCopyContinuesAsTheOriginal() {
        BodyEstimator estimator = estimator();
        Motion motion = motion(1500);
        feed(estimator, motion, 0, 700);
        BodyEstimator copy = estimator.copy();
        feed(estimator, motion, 700, 1500);
        assertFalse(copy.track().frequency() == estimator.track().frequency(), "independent");
        feed(copy, motion, 700, 1500);
        assertSame(estimator.track(), copy.track());
    }

    @Test
    void resetReplays() {
        BodyEstimator estimator = estimator();
        Motion motion = motion(1500);
        feed(estimator, motion, 0, 1500);
        BodyEstimator first = estimator.copy();
        estimator.reset();
        assertTrue(Double.isNaN(estimator.track().nis()));
        feed(estimator, motion, 0, 1500);
        assertSame(first.track(), estimator.track());
    }

    private static void assertSame(BodyEstimate expected, BodyEstimate actual) {
        assertEquals(expected.frequency(), actual.frequency(), 0);
        assertEquals(expected.damping(), actual.damping(), 0);
        assertEquals(expected.frequencyDeviation(), actual.frequencyDeviation(), 0);
        assertEquals(expected.dampingDeviation(), actual.dampingDeviation(), 0);
        assertEquals(expected.prediction(), actual.prediction(), 0);
        assertEquals(expected.nis(), actual.nis(), 0);
        assertEquals(expected.outputNoise(), actual.outputNoise(), 0);
        assertEquals(expected.missing(), actual.missing());
    }

    @Test
    void aSpecChecksItself() {
        assertThrows(IllegalArgumentException.class, () -> Spec.at(0));
        assertThrows(IllegalArgumentException.class, () -> Spec.at(60).startingAt(Double.NaN, 0.3));
        assertThrows(IllegalArgumentException.class, () -> Spec.at(60).startingAt(5, 4));
        assertThrows(IllegalArgumentException.class, () -> new Spec(60, 5, 0.3, 0, 1, 0));
        assertEquals(0.0107, Spec.at(60).inputNoise(), 5e-5);
    }
}

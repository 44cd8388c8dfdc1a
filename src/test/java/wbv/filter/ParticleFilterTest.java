package wbv.filter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.filter.SimulatedSitter.Motion;
import wbv.filter.model.Spec;

class ParticleFilterTest {

    private static final double NOISE = Spec.noise(SimulatedSitter.RATE);

    private static Estimator estimator(int particles, long seed) {
        return EstimatorDesign.of(Method.PARTICLE).withParticles(particles).withSeed(seed).estimator(Spec.at(SimulatedSitter.RATE),
                Silent::new);
    }

    /** It is another way to the same posterior: where the extended filter is right, both agree within what they do not know. */
    @Tag("slow")
    @Test
    void itAgreesWithTheExtendedFilter() {
        for (long seed = 0; seed < 6; seed++) {
            SimulatedSitter sitter = SimulatedSitter.of(seed);
            Motion motion = sitter.steady(0.8, 2400, seed).measured(NOISE, seed);
            Estimator particles = estimator(1000, seed);
            Estimator extended = EstimatorDesign.of(Method.EKF_ADWIN).estimator(Spec.at(SimulatedSitter.RATE), Silent::new);
            for (int i = 0; i < 2400; i++) {
                particles.step(motion.u()[i], motion.y()[i]);
                extended.step(motion.u()[i], motion.y()[i]);
            }
            BodyEstimate a = particles.track();
            BodyEstimate b = extended.track();
            assertEquals(b.frequency(), a.frequency(), 3 * Math.hypot(a.frequencyDeviation(), b.frequencyDeviation()));
            assertEquals(b.damping(), a.damping(), 3 * Math.hypot(a.dampingDeviation(), b.dampingDeviation()));
            assertEquals(0, a.divergences());
        }
    }

    /** Half the particles start anywhere, so a start far away does no harm. */
    @Test
    void aWrongStartIsFoundOut() {
        SimulatedSitter sitter = new SimulatedSitter(4.2, 0.3);
        Motion motion = sitter.steady(0.8, 1800, 2).measured(NOISE, 2);
        Estimator estimator = EstimatorDesign.of(Method.PARTICLE).estimator(Spec.at(60).startingAt(20, 2), Silent::new);
        for (int i = 0; i < 1800; i++) {
            estimator.step(motion.u()[i], motion.y()[i]);
        }
        assertEquals(4.2, estimator.track().frequency(), 0.1);
        assertEquals(0.3, estimator.track().damping(), 0.02);
    }

    @Test
    void anotherSeedIsAnotherCloudWithTheSameAnswer() {
        Motion motion = new SimulatedSitter(5, 0.4).steady(0.8, 1500, 2).measured(NOISE, 2);
        Estimator one = estimator(500, 1);
        Estimator other = estimator(500, 2);
        for (int i = 0; i < 1500; i++) {
            one.step(motion.u()[i], motion.y()[i]);
            other.step(motion.u()[i], motion.y()[i]);
        }
        assertTrue(one.track().frequency() != other.track().frequency());
        assertEquals(one.track().frequency(), other.track().frequency(), 0.1);
    }

    /** An output that jumps about as nothing could: counted, and no number breaks. */
    @Test
    void degeneracyIsCountedAndRecoveredFrom() {
        Estimator estimator = estimator(200, 1);
        Random random = new Random(4);
        for (int i = 0; i < 3000; i++) {
            BodyEstimate track = estimator.step(random.nextGaussian(), (i / 400 % 2 == 0 ? 1 : 1e5) * random.nextGaussian());
            assertTrue(Double.isFinite(track.frequency()) && Double.isFinite(track.dampingDeviation()), "finite at " + i);
        }
        assertTrue(estimator.track().divergences() > 0);
        Motion motion = new SimulatedSitter(5, 0.4).steady(0.8, 6000, 2).measured(NOISE, 2);
        for (int i = 0; i < 6000; i++) {
            estimator.step(motion.u()[i], motion.y()[i]);
        }
        assertEquals(5, estimator.track().frequency(), 0.15);
    }

    /** Systematic resampling and kernel keep mean and covariance: Liu and West 2001, section 10.3.2. */
    @Test
    void aCloudHasTheMomentsOfItsWeights() {
        Random random = new Random(8);
        double[][] points = new double[500][2];
        double[] weights = new double[500];
        double sum = 0;
        for (int k = 0; k < 500; k++) {
            points[k][0] = random.nextGaussian();
            points[k][1] = 0.5 * points[k][0] + 0.1 * random.nextGaussian();
            weights[k] = random.nextDouble();
            sum += weights[k];
        }
        for (int k = 0; k < 500; k++) {
            weights[k] /= sum;
        }
        Cloud cloud = new Cloud(2);
        double[] mean = new double[2];
        cloud.meanOf(points, weights, mean);
        cloud.covarianceOf(points, weights, mean);
        cloud.factor();
        // L Lᵀ is the covariance
        double[] e0 = {1, 0};
        double[] e1 = {0, 1};
        double l00 = cloud.rootTimes(0, e0);
        double l10 = cloud.rootTimes(1, e0);
        double l11 = cloud.rootTimes(1, e1);
        assertEquals(cloud.covariance(0, 0), l00 * l00, 1e-12);
        assertEquals(cloud.covariance(0, 1), l00 * l10, 1e-12);
        assertEquals(cloud.covariance(1, 1), l10 * l10 + l11 * l11, 1e-12);
        assertEquals(0.5, cloud.covariance(0, 1) / cloud.covariance(0, 0), 0.02);
    }

    @Test
    void tooFewParticlesAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> EstimatorDesign.of(Method.PARTICLE).withParticles(3));
    }
}

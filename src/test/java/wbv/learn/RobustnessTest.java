package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.filter.BodyEstimate;
import wbv.filter.BodyEstimator;
import wbv.filter.SimulatedSitter;
import wbv.filter.SimulatedSitter.Motion;
import wbv.filter.model.Spec;
import wbv.rig.RigRun;
import wbv.rig.RigSpec;

/** What the estimator meets beside the conditions of {@link AcceptanceTest}. */
class RobustnessTest {

    private static BodyEstimator estimator(double rate) {
        return new BodyEstimator(Spec.at(rate), new AdwinAlarm(0.002));
    }

    private static void assertNear(SimulatedSitter truth, BodyEstimate track, double tolerance, String when) {
        assertEquals(1, track.frequency() / truth.frequency(), tolerance, "natural frequency " + when);
        assertEquals(1, track.damping() / truth.damping(), tolerance, "damping ratio " + when);
    }

    @ParameterizedTest
    @ValueSource(doubles = {40, 100, 250, 1000})
    void otherRatesAreAsGood(double rate) {
        double[] row = new double[3];
        for (int seed = 0; seed < 4; seed++) {
            SimulatedSitter sitter = SimulatedSitter.of(seed);
            RigRun run = RigSpec.oneDof(sitter.damping(), sitter.frequency(), 0.7, 30, 300 + seed).withRate(rate).run();
            BodyEstimator estimator = estimator(rate);
            while (run.read(row)) {
                BodyEstimate track = estimator.step(row[1], row[2]);
                if (row[0] > 20) {
                    assertNear(sitter, track, 0.03, "at " + row[0] + " s of " + rate + " Hz");
                }
            }
        }
    }

    /** Forty decibels up and down: the same body all the time. */
    @Test
    void shakingHarderOrSofterIsNoChangeOfTheBody() {
        double[] row = new double[3];
        for (int seed = 0; seed < 5; seed++) {
            SimulatedSitter sitter = SimulatedSitter.of(seed);
            String program = "random:z:0.5-12:1@30+random:z:0.5-12:0.1@30+random:z:0.5-12:0.5@30+random:z:0.5-12:2@30"
                    + "+random:z:0.5-12:0.02@30+random:z:0.5-12:1.5@30";
            RigRun run = RigSpec.parse("sitter=one-dof zeta=" + sitter.damping() + " f0=" + sitter.frequency() + " excitation="
                    + program + " seconds=180 seed=" + seed).run();
            BodyEstimator estimator = estimator(60);
            while (run.read(row)) {
                BodyEstimate track = estimator.step(row[1], row[2]);
                if (row[0] > 20) {
                    assertNear(sitter, track, 0.05, "at " + row[0] + " s");
                }
            }
            assertEquals(0, estimator.track().changes());
            assertEquals(0, estimator.track().divergences());
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 2})
    void aLargeChangeIsHeardAndLearned(double factor) {
        int twice = 0;
        for (int seed = 0; seed < 20; seed++) {
            SimulatedSitter before = SimulatedSitter.of(seed);
            SimulatedSitter after = before.withStiffness(factor);
            Motion motion = before.becoming(after, 0.8, 50, 40, seed).measured(Spec.noise(60), seed);
            BodyEstimator estimator = estimator(60);
            for (int i = 0; i < motion.u().length; i++) {
                BodyEstimate track = estimator.step(motion.u()[i], motion.y()[i]);
                assertTrue(!track.changed() || i >= 2400, "changed before the change");
                if (i > 45 * 60) {
                    assertNear(after, track, 0.05, "five seconds after");
                }
            }
            assertTrue(estimator.track().changes() >= 1, "heard");
            twice += estimator.track().changes() > 1 ? 1 : 0;
        }
        assertTrue(twice <= 1, "told again while it is still being learned: " + twice + " of 20");
    }

    /** Sensors better than was said: innovations are smaller than expected all along, and the alarm listens all the same. */
    @Test
    void aBetterSensorDoesNotDeafenTheAlarm() {
        SimulatedSitter before = new SimulatedSitter(4.6, 0.33);
        Motion motion = before.becoming(before.withStiffness(1.25), 0.8, 60, 50, 7).measured(Spec.noise(60) / 2, 7);
        BodyEstimator estimator = estimator(60);
        for (int i = 0; i < motion.u().length; i++) {
            estimator.step(motion.u()[i], motion.y()[i]);
        }
        assertEquals(1, estimator.track().changes());
        assertNear(before.withStiffness(1.25), estimator.track(), 0.05, "in the end");
    }
}

package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.filter.BodyEstimate;
import wbv.filter.BodyEstimator;
import wbv.filter.SimulatedSitter;
import wbv.filter.SimulatedSitter.Motion;
import wbv.filter.model.Spec;
import wbv.rig.RigRun;
import wbv.rig.RigSpec;

/**
 * What the estimator is held to: fifty linear sitters, ζ 0.2 to 0.6 and f0 3 to 7 Hz, under 0.5 to 1 m/s² of random motion, and
 * a start that is 40 % off, to either side.
 */
class AcceptanceTest {

    private static final int SITTERS = 50;
    private static final int FIRST = 8;

    private static double rms(int seed) {
        return 0.5 + 0.125 * (seed % 5);
    }

    /** Starts 40 % off, frequency and damping high and low in all four ways. */
    private static BodyEstimator fortyPercentOff(SimulatedSitter sitter, int seed) {
        double f = sitter.frequency() * (seed % 2 == 0 ? 0.6 : 1.4);
        double z = sitter.damping() * (seed / 2 % 2 == 0 ? 0.6 : 1.4);
        return new BodyEstimator(Spec.at(60).startingAt(f, z), new AdwinAlarm(0.002));
    }

    private static double error(BodyEstimate track, SimulatedSitter truth) {
        return Math.max(Math.abs(track.frequency() / truth.frequency() - 1), Math.abs(track.damping() / truth.damping() - 1));
    }

    private static BodyEstimate step(BodyEstimator estimator, RigRun run, double[] row) {
        assertTrue(run.read(row), "rig plays on");
        return estimator.step(row[1], row[2]);
    }

    @Tag("slow")
    @Test
    void everySitterOfTheRigIsKnownWithinFivePercentAfterTwentySeconds() {
        List<String> late = new ArrayList<>();
        double[] row = new double[3];
        for (int seed = 0; seed < SITTERS; seed++) {
            SimulatedSitter sitter = SimulatedSitter.of(seed);
            RigRun run = RigSpec.oneDof(sitter.damping(), sitter.frequency(), rms(seed), 30, 100 + seed).run();
            BodyEstimator estimator = fortyPercentOff(sitter, seed);
            for (int i = 0; i < 1800; i++) {
                BodyEstimate track = step(estimator, run, row);
                if (i >= 1200 && error(track, sitter) > 0.05) {
                    late.add(sitter + " at " + i / 60.0 + " s: " + error(track, sitter));
                    break;
                }
            }
            assertEquals(0, estimator.track().divergences(), sitter.toString());
        }
        assertEquals(List.of(), late);
    }

    @Tag("slow")
    @Test
    void aStiffnessStepOfTwentyFivePercentIsLearnedWithinFiveSeconds() {
        double change = 30;
        List<String> late = new ArrayList<>();
        double[] row = new double[3];
        for (int seed = 0; seed < SITTERS; seed++) {
            double factor = seed % 2 == 0 ? 1.25 : 0.75;
            SimulatedSitter before = SimulatedSitter.of(seed);
            SimulatedSitter after = before.withStiffness(factor);
            RigRun run = RigSpec.oneDof(before.damping(), before.frequency(), rms(seed), 45, 200 + seed)
                    .withStiffnessStep(factor, change).run();
            BodyEstimator estimator = fortyPercentOff(before, seed);
            for (int i = 0; i < 45 * 60; i++) {
                BodyEstimate track = step(estimator, run, row);
                if (i >= (change + 5) * 60 && error(track, after) > 0.05) {
                    late.add(after + " at " + i / 60.0 + " s: " + error(track, after));
                    break;
                }
            }
        }
        assertEquals(List.of(), late);
    }

    /** Ten minutes each: more than an hour in which nothing changes. */
    @Tag("slow")
    @Test
    void nothingIsCutWhereNothingChangesAndTheModelIsTheBody() {
        nothingIsCut(0, FIRST);
    }

    /** The others: more than eight hours in all. */
    @Test
    @Tag("exam")
    void nothingIsCutInEightHoursEither() {
        nothingIsCut(FIRST, SITTERS);
    }

    private static void nothingIsCut(int from, int to) {
        for (int seed = from; seed < to; seed++) {
            SimulatedSitter sitter = SimulatedSitter.of(seed);
            Motion motion = sitter.steady(rms(seed), 36000, seed).measured(Spec.noise(60), seed);
            BodyEstimator estimator = fortyPercentOff(sitter, seed);
            long heard = 0;
            for (int i = 0; i < motion.u().length; i++) {
                heard = Math.max(heard, estimator.step(motion.u()[i], motion.y()[i]).width());
            }
            assertEquals(0, estimator.track().cuts(), sitter.toString());
            assertTrue(heard > 30000, "the alarm listened to " + heard + " of 36000 samples");
            for (double f = 1; f <= 9; f += 0.25) {
                assertEquals(1, estimator.modulus(f) / sitter.transfer(f).abs(), 0.05, sitter + " at " + f + " Hz");
            }
        }
    }
}

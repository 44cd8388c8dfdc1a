package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.model.Spec;
import wbv.rig.RigRun;
import wbv.rig.RigSpec;

/**
 * The estimators over random sitters of the rig, ζ 0.2 to 0.6 and f0 3 to 7 Hz: a small draw of what {@code
 * wbv.bench.FilterProof} counts in full.
 */
class StartsAndStepsTest {

    private static final double RATE = 60;

    /** A sitter and where its estimator starts. */
    private record Draw(double frequency, double damping, double startFrequency, double startDamping, RigSpec spec) {

        static Draw of(int seed, double seconds) {
            SplittableRandom random = new SplittableRandom(500 + seed);
            double frequency = 3 + 4 * random.nextDouble();
            double damping = 0.2 + 0.4 * random.nextDouble();
            return new Draw(frequency, damping, 1 + 14 * random.nextDouble(), 0.05 + 0.9 * random.nextDouble(),
                    RigSpec.oneDof(damping, frequency, 0.8, seconds, 900 + seed));
        }

        double error(BodyEstimate track) {
            return Math.max(Math.abs(track.frequency() / frequency - 1), Math.abs(track.damping() / damping - 1));
        }
    }

    private static Estimator estimator(Method method, double frequency, double damping, long seed) {
        return EstimatorDesign.of(method).withParticles(400).withSeed(seed).estimator(Spec.at(RATE).startingAt(frequency, damping),
                () -> new AdwinAlarm(0.002));
    }

    /**
     * Starts anywhere, ζ 0.05 to 0.95 and f0 1 to 15 Hz. At a rate of failures of 1 %, more than two of forty are seen once in
     * 130.
     */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"EKF_ADWIN, 40, 2", "UNSCENTED, 20, 2", "CONSTRAINED, 20, 2", "PARTICLE, 8, 0", "FUSED, 8, 0"})
    void theBodyIsFoundFromAnywhereWithinThirtySeconds(Method method, int draws, int allowed) {
        List<String> failed = new ArrayList<>();
        double[] row = new double[3];
        for (int seed = 0; seed < draws; seed++) {
            Draw draw = Draw.of(seed, 30);
            Estimator estimator = estimator(method, draw.startFrequency, draw.startDamping, seed);
            RigRun run = draw.spec.run();
            while (run.read(row)) {
                estimator.step(row[1], row[2]);
            }
            if (!(draw.error(estimator.track()) <= 0.05)) {
                failed.add(draw + ": " + draw.error(estimator.track()));
            }
        }
        assertTrue(failed.size() <= allowed, failed.toString());
    }

    /** Stiffness steps of 15 %: the median is heard within half a second, nine of ten within one, and none before. */
    @ParameterizedTest
    @CsvSource({"EKF_ADWIN, 20", "UNSCENTED, 10", "FUSED, 4"})
    void aStiffnessStepOfFifteenPercentIsHeardWithinASecond(Method method, int draws) {
        double change = 25;
        List<Double> heard = new ArrayList<>();
        double[] row = new double[3];
        for (int seed = 0; seed < draws; seed++) {
            Draw draw = Draw.of(seed, 30);
            RigRun run = draw.spec.withStiffnessStep(seed % 2 == 0 ? 1.15 : 1 / 1.15, change).run();
            Estimator estimator = estimator(method, 5, 0.4, seed);
            double first = Double.POSITIVE_INFINITY;
            while (run.read(row)) {
                if (estimator.step(row[1], row[2]).changed() && row[0] > 15) {
                    first = Math.min(first, row[0] - change);
                }
            }
            assertTrue(first > 0, "heard before it happened, by " + first + " s");
            heard.add(first);
        }
        heard.sort(Double::compare);
        assertTrue(heard.get((draws - 1) / 2) < 0.5, "median " + heard);
        assertTrue(heard.get((int) (0.9 * (draws - 1))) <= 1, heard.toString());
    }

    @Test
    void aSitterWhoDoesNotChangeRaisesNoAlarm() {
        double[] row = new double[3];
        for (int seed = 0; seed < 2; seed++) {
            RigRun run = Draw.of(seed, 300).spec.run();
            Estimator estimator = estimator(Method.EKF_ADWIN, 5, 0.4, seed);
            long early = 0;
            while (run.read(row)) {
                early = row[0] < 30 ? estimator.track().changes() : early;
                estimator.step(row[1], row[2]);
            }
            assertEquals(early, estimator.track().changes());
        }
    }
}

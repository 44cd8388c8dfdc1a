package wbv.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** How sure the models that ship are, in and out of their domain. The full size stands in docs/thesis.md. */
class ReaderTest {

    @BeforeAll
    static void needsTheEngine() {
        WithEngine.orSkip();
    }

    @Test
    void inItsDomainIntervalsHoldAndHardlyAWindowIsUnlike() {
        for (Bodies bodies : List.of(Bodies.ONE_DOF, Bodies.TWO_DOF)) {
            Asked asked = new Asked(bodies, 150);
            for (int j = 0; j < 2 * bodies.modes(); j++) {
                // 90 % of 150 less and more three deviations
                assertTrue(asked.covered(false, j) > 0.82, bodies + ", network " + j + ": " + asked.covered(false, j));
                assertTrue(asked.covered(true, j) > 0.82, bodies + ", fitted " + j + ": " + asked.covered(true, j));
                assertTrue(asked.covered(true, j) < 0.98 && asked.covered(false, j) < 0.98, bodies + ", target " + j);
            }
            assertTrue(asked.unlike() <= 0.04, bodies + " " + asked.unlike());
        }
    }

    /** Noise and a second mode: told, and the deviation grows as the error does or more. */
    @Test
    void outOfItsDomainItSaysSo() {
        Asked usual = new Asked(Bodies.ONE_DOF, 60);
        for (Bodies bodies : List.of(Bodies.NOISY, Bodies.TWO_AS_ONE)) {
            Asked asked = new Asked(bodies, 60);
            assertTrue(asked.unlike() > 0.85, bodies + " " + asked.unlike());
            for (int j = 0; j < 2; j++) {
                double error = asked.score(false, j).rmse() / usual.score(false, j).rmse();
                double stated = asked.score(false, j).stated() / usual.score(false, j).stated();
                assertTrue(error > 2 && stated > 0.5 * error, bodies + ": error " + error + " times, stated " + stated);
                assertTrue(asked.covered(false, j) > 0.75, bodies + " " + asked.covered(false, j));
            }
        }
    }

    /** What the network says, as what is known beforehand, makes the fit of two modes better than either. */
    @Test
    void theFitIsBetterWithTheNetworkThanWithout() {
        Asked asked = new Asked(Bodies.TWO_DOF, 150);
        List<Estimate> alone = asked.trials.stream().map(trial -> Peers.fit(trial.motion(), 2)).toList();
        for (int j = 0; j < 4; j++) {
            assertTrue(asked.score(true, j).rmse() < 0.8 * asked.score(false, j).rmse(), "than the network, target " + j);
        }
        Score withNetwork = asked.score(true, 3);
        Score without = Score.of(3, asked.trials, alone, 0, 1);
        assertTrue(withNetwork.rmse() < 0.5 * without.rmse(), withNetwork.rmse() + " and " + without.rmse());
    }

    @Test
    void oneAtATimeAndAllAtOnceAreTheSame() {
        List<LabelledMotion> trials = RigTrials.of(Bodies.ONE_DOF, 3, 5, share -> {});
        try (Reader reader = new Reader(TrainedNetwork.shipped(1))) {
            List<Reading> all = reader.readAll(trials.stream().map(LabelledMotion::motion).toList());
            assertEquals(all.get(2).fitted().value()[1], reader.read(trials.get(2).motion()).fitted().value()[1], 1e-4);
        }
    }

    /** Trials of a seed of this test's own, and what the model that ships reads. */
    private static final class Asked {
        private final List<LabelledMotion> trials;
        private final List<Reading> readings;

        Asked(Bodies bodies, int count) {
            trials = RigTrials.of(bodies, count, 4242, share -> {});
            try (Reader reader = new Reader(TrainedNetwork.shipped(bodies.modes()))) {
                readings = reader.readAll(trials.stream().map(LabelledMotion::motion).toList());
            }
        }

        Score score(boolean fitted, int target) {
            return Score.of(target, trials, readings.stream().map(fitted ? Reading::fitted : Reading::network).toList(), 0, 1);
        }

        double covered(boolean fitted, int target) {
            return score(fitted, target).covered();
        }

        double unlike() {
            return readings.stream().filter(Reading::unlike).count() / (double) readings.size();
        }
    }
}

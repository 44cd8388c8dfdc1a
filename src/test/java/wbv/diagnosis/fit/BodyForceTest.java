package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** What is believed of a force that nobody measured: figures as recordings gave them whose cause is known. */
class BodyForceTest {

    @Test
    void aPushOnTheTrunkWhoseLevelIsItsOwnIsACause() {
        assertTrue(force(0.965, 0.09, 0.09, 0.167).independent());
    }

    @Test
    void whatFollowsTheRideIsNone() {
        assertFalse(force(0.965, 0.8, 0.09, 0.167).independent());
    }

    @Test
    void stiffnessThatBreathesUnderTheFirstBodyIsNotAPush() {
        // A force in the link below would do the same, and its level may follow the ride's as well as not.
        assertFalse(force(0.991, 0.35, 0.25, 0).independent());
        assertFalse(force(0.974, -0.16, 0.42, 0).independent());
        assertFalse(force(0.987, 0, Double.POSITIVE_INFINITY, 0).independent());
    }

    @Test
    void onTheFirstBodyTheLevelAloneMayTell() {
        assertTrue(force(0.99, 0.02, 0.08, 0).independent());
    }

    @Test
    void stiffnessThatMotionTakesAwayIsNotAPush() {
        // It is the less the rougher the ride, which no push knows.
        assertFalse(force(0.968, -0.46, 0.21, -0.018).independent());
    }

    @Test
    void whatALawThatWasFoundDoesBetterIsNoPush() {
        assertFalse(force(0.99, 0.02, 0.08, Double.NEGATIVE_INFINITY).independent());
    }

    @Test
    void onlyWhatIsKnownNotToFollowTheRideIsSteady() {
        assertTrue(force(0.99, -0.05, 0.14, 0.4).following().isSteady());
        assertFalse(force(0.99, 1, 0.14, 0.4).following().isSteady());
        assertFalse(force(0.99, 0, Double.POSITIVE_INFINITY, 0.4).following().isSteady());
    }

    @Test
    void aBandTakesItsOwnLevelWhereItShowsOneAndItsNeighboursElsewhere() {
        // Three bands show a force of 4 N² a line well; in the first the noise is a thousand times as strong, and its estimate 30 N² too
        // high.
        double[] noise = {4000, 0.1, 0.1, 0.1};
        double[] level = ForceBands.levels(new double[] {4034, 4.1, 4.1, 1.1}, noise, new int[] {100, 100, 100, 100});
        assertEquals(4, level[0], 1.5);
        assertEquals(4, level[1], 0.1);
        assertEquals(1, level[3], 0.1);
    }

    @Test
    void noiseAloneIsNoForce() {
        double[] level = ForceBands.levels(new double[] {0.9, 1, 0.98}, new double[] {1, 1, 1}, new int[] {50, 50, 50});
        assertArrayEquals(new double[3], level, 1e-12);
    }

    private static BodyForce force(double carried, double slope, double doubt, double lead) {
        return new BodyForce(1, new ForceBands(10, 10, new double[] {30}, new double[] {1}), carried,
                new LevelDependence(slope, doubt, slope), lead, 0);
    }
}

package wbv.diagnosis;

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
        assertTrue(force(0.99, -0.05, 0.14, 0.4).steady());
        assertFalse(force(0.99, 1, 0.14, 0.4).steady());
        assertFalse(force(0.99, 0, Double.POSITIVE_INFINITY, 0.4).steady());
    }

    private static BodyForce force(double carried, double slope, double doubt, double lead) {
        return new BodyForce(1, 10, 10, new double[] {30}, new double[] {1}, carried, slope, doubt, lead);
    }
}

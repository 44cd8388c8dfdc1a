package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Recordings of others, where they are at hand; {@link RealRun} has the whole table. */
class RealTest {

    @Test
    void theMagnetorheologicalDamperHasFriction() throws IOException {
        assumeTrue(RealRun.isThere(), "no recordings of others in " + RealRun.REAL);
        RealRun.Row row = RealRun.damper("validation");
        assertTrue(row.named().startsWith("friction.coulomb") || row.named().startsWith("hysteresis"), row.toString());
        assertTrue(row.error() <= 17, row.toString());
    }

    /** Beside the spring the losses are learned: what a noise of the input would pass for. */
    @Tag("slow")
    @Test
    void theSilverboxStiffensAndHasLossesOfItsOwn() throws IOException {
        assumeTrue(RealRun.isThere(), "no recordings of others in " + RealRun.REAL);
        RealRun.Row row = RealRun.silverbox().get(0);
        assertTrue(row.named().equals("stiffness.hardening"), row.toString());
        assertTrue(row.error() <= 0.26, row.toString());
    }

    /** Friction that engages again may be named or refused: the model with it comes, and foretells an earthquake that it has not seen. */
    @Tag("slow")
    @Test
    void whatComesNearestToTheFrictionDamperForetellsAnEarthquake() throws IOException {
        assumeTrue(RealRun.isThere(), "no recordings of others in " + RealRun.REAL);
        RealRun.Row row = RealRun.friction("KocaeliDBE");
        assertTrue(row.named().equals("contact.backlash"), row.toString());
        assertTrue(row.error() < 0.6 * 3131, row.toString());
    }

    @Tag("slow")
    @Test
    void theCoupledDrivesSpeedSensorLosesTheSign() throws IOException {
        assumeTrue(RealRun.isThere(), "no recordings of others in " + RealRun.REAL);
        RealRun.Row row = RealRun.drives("prbs1");
        assertTrue(row.named().startsWith("sensor.rectifying"), row.toString());
        assertTrue(row.error() < 0.28, row.toString());
    }

    /**
     * What loses the sign of a speed that hardly turns round cuts it off at nothing: no name is held, and if one is told it is a fault of
     * that sensor.
     */
    @Tag("slow")
    @Test
    void aSpeedThatHardlyTurnsRoundNamesNoLaw() throws IOException {
        assumeTrue(RealRun.isThere(), "no recordings of others in " + RealRun.REAL);
        RealRun.Row row = RealRun.drives("unif2");
        boolean ofSensor = List.of("sensor.clipping", "sensor.rectifying").contains(row.named());
        assertTrue(row.verdict().equals("unexplained") || row.verdict().equals("ambiguous") && ofSensor, row.toString());
    }
}

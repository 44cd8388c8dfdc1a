package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
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

    @Test
    void theCoupledDrivesSpeedSensorLosesTheSign() throws IOException {
        assumeTrue(RealRun.isThere(), "no recordings of others in " + RealRun.REAL);
        RealRun.Row row = RealRun.drives("prbs1");
        assertTrue(row.named().startsWith("sensor.rectifying"), row.toString());
        assertTrue(row.error() < 0.28, row.toString());
    }

    @Test
    void aSpeedThatHardlyTurnsRoundNamesNoLaw() throws IOException {
        assumeTrue(RealRun.isThere(), "no recordings of others in " + RealRun.REAL);
        assertEquals("unexplained", RealRun.drives("unif2").verdict());
    }
}

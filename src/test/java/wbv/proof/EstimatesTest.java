package wbv.proof;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class EstimatesTest {

    private static List<Estimates.Estimate> of(String mechanism, Map<String, Double> truth, String key, double value, double low,
            double high) {
        return Estimates.of(new Truth.Concealed(mechanism, "seat-torso", "", truth, 9),
                new ProofAnswer.Name(mechanism, "seat-torso", 0.9, Map.of(key, value), Map.of(key, low), Map.of(key, high), 1.5, 0));
    }

    @Test
    void anIntervalHoldsTheTruthOrNot() {
        assertTrue(of("friction.coulomb", Map.of("friction_N", 30.0), "friction_N", 32, 28, 36).get(0).covers());
        assertFalse(of("friction.coulomb", Map.of("friction_N", 40.0), "friction_N", 32, 28, 36).get(0).covers());
        assertTrue(of("friction.coulomb", Map.of("friction_N", 40.0), "friction_N", 32, 28,
                Double.POSITIVE_INFINITY).get(0).covers());
    }

    @Test
    void aKeyRoundsToFourDigits() {
        assertTrue(of("input.unmeasured", Map.of("frequency_hz", 8.515), "frequency_hz", 8.51479, 8.51476,
                8.51482).get(0).covers());
        assertFalse(of("input.unmeasured", Map.of("frequency_hz", 8.516), "frequency_hz", 8.51479, 8.51476,
                8.51482).get(0).covers());
    }

    /** Which way an arm points is a matter of axes. */
    @Test
    void anArmMayPointEitherWay() {
        Estimates.Estimate arm = of("coupling.rotation", Map.of("lever_arm_m", 0.17), "lever_arm_m on platform.gyr.y", -0.168,
                -0.18, -0.16)
                .get(0);
        assertEquals(0.168, arm.found());
        assertTrue(arm.covers());
        assertFalse(of("coupling.rotation", Map.of("lever_arm_m", 0.19), "lever_arm_m on platform.gyr.y", -0.168, -0.18,
                -0.16).get(0)
                .covers());
    }

    @Test
    void aHiddenMassIsToldByItsFrequencyAndDampingToo() {
        Map<String, Double> truth = Map.of("mass_kg", 4.0, "stiffness_N_per_m", 4 * Math.pow(2 * Math.PI * 5, 2),
                "damping_Ns_per_m",
                2 * 0.1 * 4 * 2 * Math.PI * 5);
        assertEquals(5, of("mode.hidden", truth, "frequency_hz", 5.1, 4.9, 5.3).get(0).truth(), 1e-9);
        assertEquals(0.1, of("mode.hidden", truth, "damping_ratio", 0.1, 0.09, 0.11).get(0).truth(), 1e-9);
    }

    @Test
    void onlyLawsInLinksHaveAnotherFormula() {
        assertTrue(of("mode.hidden", Map.of("mass_kg", 4.0), "mass_kg", 4, 3, 5).get(0).form());
        assertFalse(of("friction.coulomb", Map.of("friction_N", 30.0), "friction_N", 32, 28, 36).get(0).form());
    }
}

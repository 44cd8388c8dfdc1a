package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class AmountTest {

    @Test
    void keysBecomeWordsAndUsualUnits() {
        assertEquals(new Amount("knee", 1e3, "mm"), Amount.of("knee_m"));
        assertEquals(new Amount("stop stiffness", 1e-3, "kN/m"), Amount.of("stop_stiffness_N_per_m"));
        assertEquals(new Amount("damping", 1, "N·s/m"), Amount.of("damping_Ns_per_m"));
        assertEquals(new Amount("cubic stiffness", 1, "N/m³"), Amount.of("k3_N_per_m3"));
        assertEquals(new Amount("time", 1, "s"), Amount.of("time_s"));
        assertEquals(new Amount("delay", 1e3, "ms"), Amount.of("delay_s"));
        assertEquals(new Amount("lever arm on platform.gyr.y", 1e3, "mm"), Amount.of("lever_arm_m on platform.gyr.y"));
        assertEquals(new Amount("share", 1, ""), Amount.of("share"));
    }

    @Test
    void deviationsDecideTheDigits() {
        assertEquals("33.56 ± 0.11 N", new Amount("friction", 1, "N").text(33.5581, 0.0531));
        assertEquals("928 ± 68 kN/m", new Amount("stop stiffness", 1e-3, "kN/m").text(928.04, 34));
        assertEquals("7.0500 Hz", new Amount("frequency", 1, "Hz").text(7.0499989, 2.1e-6));
        assertEquals("−0.020 ± 0.012°", new Amount("tilt", 1, "°").text(-0.0201, 0.006));
        assertEquals("250 ms, not identifiable", new Amount("delay", 1e3, "ms").text(250.2, Double.POSITIVE_INFINITY));
        assertEquals("0.4395", new Amount("stiffness factor", 1, "").text(0.43951, Double.NaN));
    }
}

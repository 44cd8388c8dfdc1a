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
        assertEquals(new Amount("stiffness of the stop", 1e-6, "MN/m^1.5"), Amount.of("stop_N_per_m1_5"));
        assertEquals(new Amount("time", 1, "s"), Amount.of("time_s"));
        assertEquals(new Amount("delay", 1e3, "ms"), Amount.of("delay_s"));
        assertEquals(new Amount("lever arm on platform.gyr.y", 1e3, "mm"), Amount.of("lever_arm_m on platform.gyr.y"));
        assertEquals(new Amount("share", 1, ""), Amount.of("share"));
    }

    @Test
    void theWidthDecidesTheDigits() {
        assertEquals("33.56 N, 33.45 to 33.66", Amount.of("friction_N").text(33.5581, closed(33.4519, 33.6643)));
        assertEquals("928 kN/m, 860 to 1024", Amount.of("stop_stiffness_N_per_m").text(928040, closed(860200, 1.0241e6)));
        assertEquals("7.0500 Hz", Amount.of("frequency_hz").text(7.0499989, closed(7.0499947, 7.0500031)));
        assertEquals("0.4395", Amount.of("stiffness_factor").text(0.43951));
        assertEquals("0.5000 N", Amount.of("friction_N").text(0.5, closed(0.5, 0.5)));
    }

    @Test
    void anOpenEndIsNotIdentifiable() {
        double open = Double.POSITIVE_INFINITY;
        assertEquals("not identifiable, at most 260 ms", Amount.of("delay_s").text(0.2, closed(-open, 0.2602)));
        assertEquals("not identifiable, at least 0.30 kN/m", Amount.of("stiffness_N_per_m").text(900, closed(301, open)));
        assertEquals("not identifiable", Amount.of("delay_s").text(0.2, closed(-open, open)));
    }

    private static Interval closed(double low, double high) {
        return new Interval(low, high, Interval.Source.CURVATURE);
    }
}

package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class DisplayedNumberTest {

    @Test
    void keysBecomeWordsAndUsualUnits() {
        assertEquals(new DisplayedNumber("knee", 1e3, "mm"), DisplayedNumber.of("knee_m"));
        assertEquals(new DisplayedNumber("stop stiffness", 1e-3, "kN/m"), DisplayedNumber.of("stop_stiffness_N_per_m"));
        assertEquals(new DisplayedNumber("damping", 1, "N·s/m"), DisplayedNumber.of("damping_Ns_per_m"));
        assertEquals(new DisplayedNumber("cubic stiffness", 1, "N/m³"), DisplayedNumber.of("k3_N_per_m3"));
        assertEquals(new DisplayedNumber("stiffness of the stop", 1e-6, "MN/m^1.5"), DisplayedNumber.of("stop_N_per_m1_5"));
        assertEquals(new DisplayedNumber("time", 1, "s"), DisplayedNumber.of("time_s"));
        assertEquals(new DisplayedNumber("stiffness added in compression", 100, "%"), DisplayedNumber.of("compression_ratio"));
        assertEquals(new DisplayedNumber("reflex to stretch", 1e-3, "kN/m"), DisplayedNumber.of("reflex_N_per_m"));
        assertEquals(new DisplayedNumber("reflex to its speed", 1, "N·s/m"), DisplayedNumber.of("reflex_Ns_per_m"));
        assertEquals(new DisplayedNumber("delay", 1e3, "ms"), DisplayedNumber.of("delay_s"));
        assertEquals(new DisplayedNumber("lever arm on platform.gyr.y", 1e3, "mm"), DisplayedNumber.of("lever_arm_m on platform.gyr.y"));
        assertEquals(new DisplayedNumber("stiffness change at 21.8 °C of oil.temp.s", 100, "%"),
                DisplayedNumber.of("stiffness_change at 21.8 °C of oil.temp.s"));
        assertEquals(new DisplayedNumber("share", 1, ""), DisplayedNumber.of("share"));
    }

    @Test
    void theWidthDecidesTheDigits() {
        assertEquals("33.56 N, 33.45 to 33.66", DisplayedNumber.of("friction_N").text(33.5581, closed(33.4519, 33.6643)));
        assertEquals("928 kN/m, 860 to 1024", DisplayedNumber.of("stop_stiffness_N_per_m").text(928040, closed(860200, 1.0241e6)));
        assertEquals("7.0500 Hz", DisplayedNumber.of("frequency_hz").text(7.0499989, closed(7.0499947, 7.0500031)));
        assertEquals("0.4395", DisplayedNumber.of("stiffness_factor").text(0.43951));
        assertEquals("0.5000 N", DisplayedNumber.of("friction_N").text(0.5, closed(0.5, 0.5)));
    }

    @Test
    void nobodyCountsZeros() {
        assertEquals("6.19·10⁹ N/m³, 5.34·10⁹ to 7.10·10⁹",
                DisplayedNumber.of("k3_N_per_m3").text(6185189865.0, closed(5336037410.0, 7098583965.0)));
        assertEquals("1.93·10⁷ N/m², −0.01·10⁷ to 1.95·10⁷", DisplayedNumber.of("k2_N_per_m2").text(1.93e7, closed(-1e5, 1.95e7)));
        assertEquals("2.300·10⁻⁵ N", DisplayedNumber.of("friction_N").text(2.3e-5));
        assertEquals("123457 N", DisplayedNumber.of("friction_N").text(123456.7));
    }

    @Test
    void anOpenEndIsNotIdentifiable() {
        double open = Double.POSITIVE_INFINITY;
        assertEquals("not identifiable, at most 260 ms", DisplayedNumber.of("delay_s").text(0.2, closed(-open, 0.2602)));
        assertEquals("not identifiable, at least 0.30 kN/m", DisplayedNumber.of("stiffness_N_per_m").text(900, closed(301, open)));
        assertEquals("not identifiable, below −5.1 mm", DisplayedNumber.of("low_m").text(-0.02, closed(-open, -0.0051)));
        assertEquals("not identifiable, above −0.013", DisplayedNumber.of("low").text(-0.001, closed(-0.013, open)));
        assertEquals("not identifiable", DisplayedNumber.of("delay_s").text(0.2, closed(-open, open)));
    }

    private static Interval closed(double low, double high) {
        return new Interval(low, high, Interval.Source.CURVATURE);
    }
}

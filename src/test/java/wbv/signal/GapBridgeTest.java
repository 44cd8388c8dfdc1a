package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.junit.jupiter.api.Test;

class GapBridgeTest {

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void aCubicIsBridgedExactlyAndNothingElseChanges(int gap) {
        GapBridge bridge = new GapBridge(3);
        int n = 60;
        for (int i = 0; i < n + bridge.delay(); i++) {
            boolean missing = i >= 20 && i < 20 + gap;
            double out = bridge.accept(i >= n || missing ? Double.NaN : cubic(i));
            if (i >= bridge.delay()) {
                assertEquals(cubic(i - bridge.delay()), out, 1e-9);
            }
        }
        assertEquals(gap, bridge.bridged());
    }

    @Test
    void longGapsAndGapsAtTheStartStayMissing() {
        GapBridge bridge = new GapBridge(3);
        int missing = 0;
        for (int i = 0; i < 40 + bridge.delay(); i++) {
            boolean gap = i == 0 || i == 2 || i >= 20 && i < 24;
            double out = bridge.accept(gap || i >= 40 ? Double.NaN : cubic(i));
            missing += i >= bridge.delay() && Double.isNaN(out) ? 1 : 0;
        }
        assertEquals(5, missing);
        assertEquals(1, bridge.bridged(), "one sample before the gap is enough");
    }

    @Test
    void gapsWithASingleSampleBetweenThemAreBridged() {
        GapBridge bridge = new GapBridge(3);
        List<Double> out = new ArrayList<>();
        for (int i = 0; i < 60 + bridge.delay(); i++) {
            boolean gap = i == 20 || i == 22 || i == 30 || i == 31 || i == 33 || i >= 60;
            out.add(bridge.accept(gap ? Double.NaN : 1 + 0.5 * i));
        }
        for (int i = 0; i < 60; i++) {
            assertEquals(1 + 0.5 * i, out.get(i + bridge.delay()), 1e-12);
        }
        assertEquals(5, bridge.bridged());
    }

    @Test
    void aLongGapGetsAStraightLineWhereThatIsWanted() {
        GapBridge bridge = new GapBridge(3, 10);
        List<Double> out = new ArrayList<>();
        for (int i = 0; i < 60 + bridge.delay(); i++) {
            boolean gap = i >= 10 && i < 20 || i >= 30 && i < 41 || i >= 60;
            out.add(bridge.accept(gap ? Double.NaN : i % 2));
        }
        for (int i = 10; i < 20; i++) {
            assertEquals((20 - i + 0.0) / 11, out.get(i + bridge.delay()), 1e-12, "from 1 before the gap to 0 behind it");
        }
        for (int i = 30; i < 41; i++) {
            assertTrue(Double.isNaN(out.get(i + bridge.delay())), "eleven are too many");
        }
        assertEquals(10, bridge.bridged());
    }

    @Test
    void aSineOfSixHertzAtSixtySamplesIsBridgedWithinFivePercent() {
        GapBridge bridge = new GapBridge(3);
        double worst = 0;
        for (int i = 0; i < 600; i++) {
            double out = bridge.accept(i % 50 == 30 || i % 50 == 31 ? Double.NaN : Math.sin(2 * Math.PI * 0.1 * i));
            if (i > 20) {
                worst = Math.max(worst, Math.abs(out - Math.sin(2 * Math.PI * 0.1 * (i - bridge.delay()))));
            }
        }
        assertTrue(worst < 0.05, "worst " + worst);
    }

    private static double cubic(int i) {
        return 1 + 0.3 * i - 0.02 * i * i + 0.0004 * i * i * i;
    }
}

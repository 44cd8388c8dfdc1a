package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
        assertEquals(6, missing);
        assertEquals(0, bridge.bridged());
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

package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AdwinAlarmTest {

    @ParameterizedTest
    @ValueSource(doubles = {-0.25, 0.25})
    void aRiseAndAFallAreHeard(double step) {
        for (long seed = 0; seed < 20; seed++) {
            Random random = new Random(seed);
            AdwinAlarm alarm = new AdwinAlarm(0.002);
            for (int i = 0; i < 5000; i++) {
                assertFalse(alarm.feed(0.25 + 0.5 * random.nextDouble()), "nothing changed, seed " + seed);
            }
            assertEquals(5000, alarm.width());
            assertEquals(0.5, alarm.mean(), 0.01);
            int delay = 0;
            while (!alarm.feed(0.25 + step + 0.5 * random.nextDouble())) {
                delay++;
            }
            assertTrue(delay < 200, "heard after " + delay);
            assertTrue(alarm.width() < 5000);
        }
    }

    @Test
    void resetForgets() {
        AdwinAlarm alarm = new AdwinAlarm(0.01);
        for (int i = 0; i < 100; i++) {
            alarm.feed(1);
        }
        alarm.reset();
        assertEquals(0, alarm.width());
        assertEquals(0, alarm.mean(), 0);
        for (int i = 0; i < 1000; i++) {
            assertFalse(alarm.feed(0));
        }
    }

    @Test
    void deltaIsAProbability() {
        assertThrows(IllegalArgumentException.class, () -> new AdwinAlarm(0));
        assertThrows(IllegalArgumentException.class, () -> new AdwinAlarm(Double.NaN));
    }
}

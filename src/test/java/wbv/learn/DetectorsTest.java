package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.filter.drift.Alarm;

class DetectorsTest {

    /** Values until a rise of the mean from 0.3 to 0.7 after 2000 is heard; 10000 if it never is. */
    private static int delay(Alarm alarm) {
        Random random = new Random(4);
        for (int i = 0; i < 2000; i++) {
            assertFalse(alarm.feed(0.6 * random.nextDouble()), "nothing changed");
        }
        assertEquals(2000, alarm.width());
        double before = alarm.mean();
        for (int i = 0; i < 10000; i++) {
            if (alarm.feed(0.4 + 0.6 * random.nextDouble())) {
                assertTrue(alarm.mean() > before, "it rose");
                return i;
            }
        }
        return 10000;
    }

    @ParameterizedTest
    @ValueSource(strings = {"ADWINChangeDetector", "ADWINChangeDetector -a 0.1", "PageHinkleyDM",
        "moa.classifiers.core.driftdetection.CusumDM"})
    void detectorsOfMoaHearARise(String commandLine) {
        assertTrue(delay(Detectors.named(commandLine).get()) < 500);
    }

    @Test
    void deltaSaysHowSoon() {
        assertTrue(delay(Detectors.named("ADWINChangeDetector -a 0.01").get())
                < delay(Detectors.named("ADWINChangeDetector -a 1.0E-12").get()));
    }

    @Test
    void noneHearsNothing() {
        assertEquals(10000, delay(Detectors.named("none").get()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "NoSuchDetector", "ADWINChangeDetector -a 7", "moa.streams.generators.SEAGenerator",
        "SeqDrift1ChangeDetector", "SeqDrift2ChangeDetector", "SEEDChangeDetector"})
    void whatIsNoDetectorIsRefused(String commandLine) {
        assertTrue(assertThrows(IllegalArgumentException.class, () -> Detectors.named(commandLine)).getMessage()
                .contains("'" + commandLine + "'"));
    }

    @Test
    void alarmsOfOneNameAreApart() {
        var alarms = Detectors.named("PageHinkleyDM");
        Alarm first = alarms.get();
        first.feed(0.5);
        assertEquals(0, alarms.get().width());
        assertEquals(1, first.width());
    }
}

package wbv.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import wbv.recording.Channel;
import wbv.signal.Segmentation;

class PublishedRangeTest {

    private static final Segmentation FINE = new Segmentation(60, 1024, 0.5);

    private static Optional<PublishedRange> of(String input, String output) {
        return PublishedRange.of(Channel.parse(input), Channel.parse(output), FINE);
    }

    /** Least and greatest peak by the table of computed responses that the models were chosen by. */
    @Test
    void peaksAreThoseOfTheModels() {
        PublishedRange range = of("platform.acc.z", "head.acc.z").orElseThrow();
        assertEquals(8, range.peaks().length);
        assertEquals(1.18, range.leastPeak(), 0.01);
        assertEquals(1.80, range.greatestPeak(), 0.01);
        assertEquals(3.98, Arrays.stream(range.peaksAt()).min().orElseThrow(), 0.06);
        assertEquals(5.67, Arrays.stream(range.peaksAt()).max().orElseThrow(), 0.06);
        int five = (int) Math.round(5 / FINE.frequency(1));
        assertEquals(1.165, range.low()[five], 0.01);
        assertEquals(1.787, range.high()[five], 0.02);
        assertTrue(range.words().contains("assumed"), range.words());
    }

    @Test
    void onlyVerticalWaysFromBelowASitterToTheHeadHaveOne() {
        assertTrue(of("seat.acc.z", "head.acc.z").isPresent());
        assertTrue(of("platform.acc.x", "head.acc.z").isEmpty());
        assertTrue(of("platform.acc.z", "sternum.acc.z").isEmpty());
        assertTrue(of("axle.acc.z", "head.acc.z").isEmpty());
        assertTrue(of("platform.gyr.z", "head.gyr.z").isEmpty());
    }
}

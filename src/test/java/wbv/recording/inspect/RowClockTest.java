package wbv.recording.inspect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RowClockTest {

    /** Places all times as a live stream does. @return samples that each row is after the one before; -1 repeated, -2 late, -3 restarted */
    private static List<Long> placed(RowClock clock, double... times) {
        List<Double> waiting = new ArrayList<>();
        List<Long> placed = new ArrayList<>();
        boolean begun = false;
        for (double time : times) {
            if (!begun) {
                waiting.add(time);
                begun = clock.learn(time);
                if (begun) {
                    waiting.forEach(each -> placed.add(place(clock, each)));
                }
            } else {
                placed.add(place(clock, time));
            }
        }
        assertTrue(begun, "the rate was learned");
        return placed;
    }

    private static long place(RowClock clock, double time) {
        return switch (clock.place(time)) {
            case NEXT -> 1 + clock.missing();
            case REPEATED -> -1;
            case LATE -> -2;
            case RESTARTED -> -3;
        };
    }

    /** Whatever rounding, loss and start there are, the rate is the true one and every row falls on its own sample. */
    @ParameterizedTest
    @CsvSource({"60, 6", "100, 6", "60, 3", "120, 3", "51.2, 9", "1000, 6"})
    void rowsFallOnTheirSamples(double rate, int decimals) {
        for (int seed = 0; seed < 40; seed++) {
            Random random = new Random(seed);
            double start = 1000 * random.nextDouble();
            long[] samples = new long[2000];
            double[] times = new double[samples.length];
            for (int i = 0; i < times.length; i++) {
                samples[i] = i == 0 ? 0 : samples[i - 1] + 1 + (random.nextInt(50) == 0 ? 1 + random.nextInt(5) : 0);
                double scale = Math.pow(10, decimals);
                times[i] = Math.rint((start + samples[i] / rate) * scale) / scale;
            }
            RowClock clock = new RowClock(OptionalDouble.empty());
            List<Long> placed = placed(clock, times);
            assertEquals(rate, clock.rate(), 2e-4 * rate, "seed " + seed);
            for (int i = 1; i < times.length; i++) {
                assertEquals(samples[i] - samples[i - 1], placed.get(i), "seed " + seed + ", row " + i);
            }
        }
    }

    @Test
    void aQuartzThatIsOffIsFollowedForHours() {
        RowClock clock = new RowClock(OptionalDouble.empty());
        double[] times = new double[4 * 3600 * 60];
        for (int i = 0; i < times.length; i++) {
            times[i] = i / 60.0 * (1 + 50e-6);
        }
        List<Long> placed = placed(clock, times);
        assertEquals(60, clock.rate());
        assertTrue(placed.stream().allMatch(step -> step == 1));
        assertEquals(60 / (1 + 50e-6), clock.measured(), 1e-4);
    }

    @Test
    void whatComesTwiceOrLateIsToldApart() {
        RowClock clock = new RowClock(OptionalDouble.of(60));
        double[] times = new double[200];
        for (int i = 0; i < times.length; i++) {
            times[i] = i / 60.0;
        }
        times[150] = times[149];
        times[160] = times[158];
        List<Long> placed = placed(clock, times);
        assertEquals(-1, placed.get(150));
        assertEquals(2, placed.get(151));
        assertEquals(-2, placed.get(160));
        assertEquals(2, placed.get(161));
        assertEquals(198, placed.stream().filter(step -> step > 0).count());
    }

    /** A sensor that starts again is followed from its third row on; one wrong time does not mislead. */
    @Test
    void aSensorThatStartsAgainIsFollowed() {
        RowClock clock = new RowClock(OptionalDouble.empty());
        double[] times = new double[400];
        for (int i = 0; i < times.length; i++) {
            times[i] = i < 200 ? 50 + i / 60.0 : i / 60.0 - 200 / 60.0;
        }
        times[300] = 1e6;
        List<Long> placed = placed(clock, times);
        assertEquals(List.of(-2L, -2L, -3L, 1L), placed.subList(200, 204));
        assertEquals(List.of(-3L, -2L, -2L, -3L, 1L), placed.subList(300, 305));
        assertTrue(placed.subList(304, 400).stream().allMatch(step -> step == 1));
    }

    @Test
    void aStreamThatEndsEarlyIsLearnedFromWhatThereIs() {
        RowClock clock = new RowClock(OptionalDouble.empty());
        assertFalse(clock.learn(0));
        assertFalse(clock.learnNow());
        assertFalse(clock.learn(0.02));
        assertTrue(clock.learnNow());
        assertEquals(50, clock.rate(), 1e-9);
    }
}

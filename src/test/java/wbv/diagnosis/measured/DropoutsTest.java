package wbv.diagnosis.measured;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/** What a sensor lost is told from what rounding repeats. */
class DropoutsTest {

    private static final int N = 6000;
    private static final List<String> THREE = List.of("head.acc.x", "head.acc.y", "head.acc.z");
    private static final List<String> ONE = List.of("head.acc.z");

    @Test
    void aSensorThatSendsItsLastValueAgainLosesSamples() {
        Dropouts once = of(THREE, 0, x -> hold(x, 1000, 1));
        assertEquals(1, once.found());
        assertTrue(once.valid()[1001]);   // so little is let pass
        assertEquals(10, of(THREE, 0, x -> {
            for (int k = 0; k < 10; k++) {
                hold(x, 100 + 500 * k, 1);
            }
        }).found());
    }

    @Test
    void aSensorThatReadsZeroLosesSamples() {
        assertEquals(40, of(THREE, 0, x -> Arrays.fill(x, 3000, 3040, 0)).found());
    }

    @Test
    void aChannelAloneIsHeardWithThreeEqualSamples() {
        assertEquals(15, of(ONE, 0, x -> {
            for (int k = 0; k < 5; k++) {
                hold(x, 500 + 1000 * k, 2);
            }
        }).found());
    }

    @Test
    void aLongDropoutHidesNoShortOne() {
        assertEquals(101 + 3, of(ONE, 0, x -> {
            hold(x, 1000, 100);
            hold(x, 4000, 2);
        }).found());
    }

    @Test
    void whatIsRoundedRepeatsWithoutLosingAnything() {
        assertEquals(0, of(ONE, 0.5, x -> {}).found());
        assertEquals(0, of(THREE, 0.5, x -> {}).found());
    }

    @Test
    void aDropoutIsFoundAmongRoundedValuesToo() {
        Dropouts dropouts = of(THREE, 0.5, x -> hold(x, 1000, 60));
        assertTrue(dropouts.found() >= 60 && dropouts.found() < 70, String.valueOf(dropouts.found()));
        assertFalse(dropouts.valid()[1030]);
        assertTrue(dropouts.valid()[2000]);
    }

    private static void hold(double[] x, int from, int count) {
        Arrays.fill(x, from + 1, from + 1 + count, x[from]);
    }

    /** @param step to which values are rounded, of noise of variance 1; 0 for none @param change of every channel */
    private static Dropouts of(List<String> channels, double step, Consumer<double[]> change) {
        Random random = new Random(3);
        Map<Channel, double[]> values = new LinkedHashMap<>();
        for (String name : channels) {
            double[] x = random.doubles(N, -1, 1).map(v -> v + random.nextGaussian()).map(v -> step > 0 ? step * Math.round(v / step) : v)
                    .toArray();
            change.accept(x);
            values.put(Channel.parse(name), x);
        }
        return new Dropouts(new Recording(new Clock(0, 60), values, Metadata.NONE), Channel.parse("head.acc.z"));
    }
}

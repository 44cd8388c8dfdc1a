package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

class WaveletResponseTest {

    private static final double[] FREQUENCIES = {2, 3, 4, 4.5, 5, 5.5, 6, 8, 10};

    private static double[] values(Recording recording, String channel) {
        return recording.values(Channel.parse(channel));
    }

    /** (2ζωs + ω²) / (s² + 2ζωs + ω²), the wavelet's and the average's own spread apart. */
    @Test
    void aLinearBodyHasItsClosedForm() {
        Recording body = RigSpec.parse("sitter=one-dof zeta=0.35 f0=5 seconds=120 seed=3 noise=0").recording();
        WaveletResponse response = WaveletResponse.of(60, 0, values(body, "platform.acc.z"), values(body, "head.acc.z"), FREQUENCIES, 30);
        for (int k = 0; k < FREQUENCIES.length; k++) {
            double r = FREQUENCIES[k] / 5;
            double expected = Math.hypot(1, 0.7 * r) / Math.hypot(1 - r * r, 0.7 * r);
            for (int c = 5; c < 25; c++) {
                assertEquals(expected, response.modulus()[c][k], 0.12 * expected, FREQUENCIES[k] + " Hz at " + response.times()[c]);
                assertTrue(response.coherence()[c][k] > 0.9);
            }
        }
    }

    @Test
    void aSpringThatStiffensIsSeenWhenItDoes() {
        Recording body = RigSpec.parse("sitter=one-dof zeta=0.2 f0=4.5 step=1.44@60 seconds=120 seed=3").recording();
        double[] f = new double[49];
        Arrays.setAll(f, k -> 2 + 0.125 * k);
        double[] ridge = WaveletResponse.of(60, 0, values(body, "platform.acc.z"), values(body, "head.acc.z"), f, 60).ridge();
        double before = Arrays.stream(ridge, 5, 27).filter(Double::isFinite).average().orElseThrow();
        double after = Arrays.stream(ridge, 33, 55).filter(Double::isFinite).average().orElseThrow();
        assertEquals(1.2, after / before, 0.03);
    }

    /** The level of chance is exceeded once in twenty times: 60 pairs, 20 moments far enough apart, binomial error 0.6 %. */
    @Test
    void signalsWithoutRelationAreSeldomBacked() {
        int above = 0;
        int all = 0;
        for (int seed = 0; seed < 60; seed++) {
            Random random = new Random(seed);
            double[] x = random.doubles(7200, -1, 1).toArray();
            double[] y = random.doubles(7200, -1, 1).toArray();
            WaveletResponse none = WaveletResponse.of(60, 0, x, y, new double[] {6}, 20);
            for (int c = 1; c < 19; c++) {
                all++;
                above += none.coherence()[c][0] > WaveletResponse.CHANCE ? 1 : 0;
            }
        }
        assertEquals(0.05, (double) above / all, 0.025);
    }

    @Test
    void whatIsMissingIsAHole() {
        double[] x = new Random(1).doubles(3600, -1, 1).toArray();
        Arrays.fill(x, 1500, 2100, Double.NaN);
        WaveletResponse response = WaveletResponse.of(60, 0, x, x, new double[] {5, 6}, 36);
        assertTrue(Double.isNaN(response.modulus()[18][0]));
        assertEquals(1, response.modulus()[4][0], 1e-12);
        assertThrows(IllegalArgumentException.class, () -> WaveletResponse.of(60, 0, x, new double[7], new double[] {5}, 36));
    }
}

package wbv.diagnosis.surrogate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/** What a base's other channels do to an output is told apart from what its input does, however much they go together. */
class OtherInputsTest {

    private static final int N = 3000;
    private static final Channel INPUT = Channel.parse("platform.acc.z");
    private static final Channel PITCH = Channel.parse("platform.gyr.y");

    @Test
    void channelsThatGoWithTheInputTakeNothingOfWhatItDoes() {
        for (int seed = 1; seed <= 5; seed++) {
            Random random = new Random(seed);
            double[] z = smooth(random);
            double[] own = smooth(random);
            double[] pitch = new double[N];
            for (int i = 0; i < N; i++) {
                pitch[i] = 0.8 * z[i] + 0.3 * own[i];
            }
            double[] fromZ = answered(z, 0.9, 12);
            double[] fromPitch = answered(pitch, 0.8, 7);
            double[] y = new double[N];
            for (int i = 0; i < N; i++) {
                y[i] = fromZ[i] + fromPitch[i];
            }
            OtherInputs others = new OtherInputs(recording(Map.of(INPUT, z, PITCH, pitch)), INPUT);
            assertEquals(List.of(PITCH), others.channels());
            double[] found = others.partOf(y);
            assertTrue(Missed.share(fromPitch, found, 100) < 0.01, "seed " + seed + ": " + Missed.share(fromPitch, found, 100));
        }
    }

    @Test
    void aBaseThatOnlyMovesAlongItsInputAddsNothing() {
        double[] z = smooth(new Random(6));
        OtherInputs others = new OtherInputs(recording(Map.of(INPUT, z, PITCH, new double[N])), INPUT);
        assertEquals(List.of(), others.channels());
        assertArrayEquals(new double[N], others.partOf(answered(z, 0.9, 12)));
    }

    /** An impulse response that rings: decay a sample, period in samples. */
    private static double[] answered(double[] x, double decay, double period) {
        double[] out = new double[x.length];
        for (int i = 0; i < x.length; i++) {
            for (int k = 0; k <= Math.min(i, 50); k++) {
                out[i] += Math.pow(decay, k) * Math.cos(2 * Math.PI * k / period) * x[i - k];
            }
        }
        return out;
    }

    private static double[] smooth(Random random) {
        double[] out = new double[N];
        for (int i = 1; i < N; i++) {
            out[i] = 0.5 * out[i - 1] + random.nextGaussian();
        }
        return out;
    }

    private static Recording recording(Map<Channel, double[]> values) {
        return new Recording(new Clock(0, 60), new LinkedHashMap<>(values), Metadata.NONE);
    }
}

package wbv.diagnosis.measured;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import wbv.body.simulate.Stroke;
import wbv.diagnosis.Bench;

/** The force of a damper that is moved at random, which never quite comes back to where it was, with noise that is known. */
class RepeatableTest {

    private static final double RATE = 1000;
    private static final int SAMPLES = 20_000;
    private static final double NOISE = 6;

    /** @param force by speed in m/s [N] */
    private static double rest(long seed, DoubleUnaryOperator force) {
        Random random = new Random(seed);
        DoubleUnaryOperator motion = Bench.tones(40, 0.4, 0.5, 0.0006, random);
        double[] x = IntStream.range(0, SAMPLES).mapToDouble(i -> motion.applyAsDouble(i / RATE)).toArray();
        double[] v = new double[SAMPLES];
        for (int i = 1; i < SAMPLES - 1; i++) {
            v[i] = (x[i + 1] - x[i - 1]) / 2 * RATE;
        }
        double[] measured = Bench.noisy(Arrays.stream(v).map(force).toArray(), NOISE, random);
        boolean[] valid = new boolean[SAMPLES];
        Arrays.fill(valid, true);
        return Repeatable.rest(new Stroke(x, v, List.of()), measured, valid, SAMPLES);
    }

    /** What neighbours differ by because they lie apart is no noise, whatever the law. */
    @Test
    void whatDoesNotRepeatIsNoise() {
        DoubleUnaryOperator linear = v -> 2000 * v;
        DoubleUnaryOperator thinning = v -> 1800 * v + 400 * v / (1 + 16 * v * v);
        for (DoubleUnaryOperator law : new DoubleUnaryOperator[] {linear, thinning}) {
            double[] rests = IntStream.range(0, 8).mapToDouble(seed -> rest(seed, law)).sorted().toArray();
            assertTrue(rests[0] > 0.7 * NOISE && rests[7] < 1.7 * NOISE, Arrays.toString(rests));
        }
    }

    /** Where nothing but noise is there, it is told to what a quarter of three thousand pairs tell. */
    @Test
    void noiseByItself() {
        double mean = IntStream.range(0, 8).mapToDouble(seed -> rest(seed, v -> 0)).average().orElseThrow();
        assertEquals(NOISE, mean, 0.05 * NOISE);
    }
}

package wbv.identify;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class CrossMotionsTest {

    private static final int SAMPLES = 1203;
    private static final double RATE = 60;

    private final SplittableRandom random = new SplittableRandom(5);
    private final double[][] inputs = {noise(), noise()};
    private final CrossMotions crossing = new CrossMotions(RATE, inputs, SAMPLES);

    private double[] noise() {
        return random.doubles(SAMPLES, -1, 1).toArray();
    }

    private static double[] ones(int from, int to) {
        double[] weight = new double[SAMPLES];
        Arrays.fill(weight, from, to, 1);
        return weight;
    }

    /** Coefficients are those of samples that never counted. */
    @Test
    void withoutSomeSamplesItIsAsIfTheyHadNeverCounted() {
        double[] fewer = ones(100, 1100);
        for (int t = 150; t < 1100; t += 7) {
            fewer[t] = 0;
        }
        double[] x = noise();
        Arrays.setAll(x, t -> x[t] * fewer[t]);
        List<Integer> both = List.of(0, 1);
        assertArrayEquals(crossing.on(fewer).by(both).coefficients(x),
                crossing.on(ones(100, 1100)).only(fewer).by(both).coefficients(x), 1e-10);
    }

    @Test
    void twoStretchesTogetherAreTheWhole() {
        double[] x = noise();
        List<Integer> second = List.of(1);
        assertArrayEquals(crossing.on(ones(0, SAMPLES)).by(second).coefficients(x),
                crossing.on(ones(0, 700)).and(crossing.on(ones(700, SAMPLES))).by(second).coefficients(x), 1e-10);
    }

    /** What is a sum of the motions' own Laguerre functions goes, where it counts and nowhere else. */
    @Test
    void whatTheMotionsCauseIsTakenOut() {
        double pole = Math.exp(-17 / RATE);
        double[] caused = new double[SAMPLES];
        double state = 0;
        for (int t = 0; t < SAMPLES; t++) {
            state = pole * state + Math.sqrt(1 - pole * pole) * inputs[0][t];
            caused[t] = t < 800 ? 3 * state : 0;
        }
        double[] left = caused.clone();
        crossing.on(ones(0, 800)).by(List.of(0)).takeOut(left);
        assertArrayEquals(new double[SAMPLES], left, 1e-6);
    }
}

package wbv.diagnosis.measured;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RoundingTest {

    /** Written with four digits or with all, about a level of its own or about nothing. */
    @ParameterizedTest
    @CsvSource({"0.02, 0, 1", "0.02, 0.0137, 2", "5e-6, 0, 3", "0.1, 0.05, 4"})
    void theStepOfASeriesIsFound(double step, double level, long seed) {
        double[] x = new Random(seed).doubles(4000).map(v -> level + step * Math.rint(20 * (v - 0.5))).toArray();
        Rounding found = Rounding.of(x).orElseThrow();
        assertEquals(step, found.step(), 1e-6 * step);
        assertTrue(Rounding.coarse(x).isPresent());
    }

    @ParameterizedTest
    @CsvSource({"1", "2", "3"})
    void whatIsNotRoundedHasNoStep(long seed) {
        Random random = new Random(seed);
        assertEquals(Optional.empty(), Rounding.of(random.doubles(4000).toArray()));
        double[] twoSteps = random.doubles(4000).map(v -> v < 0.5 ? 0.02 * Math.rint(10 * v) : 0.013 * Math.rint(20 * v)).toArray();
        assertEquals(Optional.empty(), Rounding.of(twoSteps));
    }

    /** Sixteen bits over the range, of which a gap tells nothing. */
    @ParameterizedTest
    @CsvSource({"1"})
    void fineStepsAreNotCoarse(long seed) {
        double[] x = new Random(seed).doubles(400_000).map(v -> Math.rint(65536 * v) / 65536).toArray();
        x[7] = Double.NaN;
        assertTrue(Rounding.of(x).isPresent());
        assertEquals(Optional.empty(), Rounding.coarse(x));
        assertEquals(400_000, Arrays.stream(x).count());
    }

    /** Levels that somebody chose and that hold for 1 to 20 samples: a binary sequence, and one of more levels. */
    @ParameterizedTest
    @CsvSource({"2, 1", "3, 2", "5, 3", "9, 4"})
    void levelsThatWereChosenAreNotRounded(int levels, long seed) {
        Random random = new Random(seed);
        double[] x = new double[4000];
        for (int i = 0; i < x.length;) {
            double level = 0.5 * random.nextInt(levels) - 1;
            for (int end = Math.min(x.length, i + 1 + random.nextInt(20)); i < end; i++) {
                x[i] = level;
            }
        }
        assertEquals(Optional.empty(), Rounding.of(x));
    }

    /** Five steps either way: a slow sine stays at a level for many samples and leaves it for the next. */
    @ParameterizedTest
    @CsvSource({"0.001, 5", "0.02, 6"})
    void aSlowSignalIsRounded(double noise, long seed) {
        Random random = new Random(seed);
        double[] x = new double[4000];
        Arrays.setAll(x, i -> 0.02 * Math.rint((0.1 * Math.sin(0.01 * i) + noise * random.nextGaussian()) / 0.02));
        assertEquals(0.02, Rounding.of(x).orElseThrow().step(), 1e-9);
    }
}

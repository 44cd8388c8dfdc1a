package wbv.diagnosis.measured;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class NoiseLevelTest {

    private static final double NOISE = 0.02;

    /** The quietest of a dozen bands is the quieter the fewer blocks there are: those that lie in a hole are none. */
    @ParameterizedTest
    @ValueSource(ints = {0, 22_000})
    void aHoleMakesNoNoiseQuieter(int lost) {
        double mean = IntStream.range(0, 20).mapToDouble(seed -> {
            Random random = new Random(seed);
            double[] x = IntStream.range(0, 32_000).mapToDouble(i -> NOISE * random.nextGaussian() + Math.sin(0.1 * i)).toArray();
            Arrays.fill(x, 5_000, 5_000 + lost, Double.NaN);
            return new NoiseLevel().bound(x);
        }).average().orElseThrow();
        assertEquals(NOISE, mean, 0.025 * NOISE);
    }
}

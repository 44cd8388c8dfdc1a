package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.apache.commons.math3.stat.inference.KolmogorovSmirnovTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.diagnosis.measured.SmallError;

class SensorDelaysTest {

    private static final double SAMPLE = 0.01;

    /** Gain and delay of some sensors and of the input's. */
    private static List<SmallError> errors(int outputs) {
        return IntStream.range(SmallError.INPUT, outputs).boxed().flatMap(owner -> Stream
                .of(new SmallError(SmallError.Kind.GAIN, owner, ""), new SmallError(SmallError.Kind.DELAY, owner, ""))).toList();
    }

    private static double oddness(int outputs, Set<Integer> asked, double[] sizes) {
        return new SensorDelays(errors(outputs), SAMPLE).oddness(asked, sizes, new boolean[sizes.length]);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "3, 1", "5, 2"})
    void scatterIsOddAsChiSquaredIsDistributed(int outputs, int channels) {
        RandomGenerator random = new Well19937c(11);
        Set<Integer> device = IntStream.range(0, channels).boxed().collect(Collectors.toSet());
        double[] odd = IntStream.range(0, 2000).mapToDouble(draw -> oddness(outputs, device,
                IntStream.range(0, 2 * outputs + 2).mapToDouble(error -> random.nextGaussian()).toArray())).toArray();
        assertTrue(new KolmogorovSmirnovTest().kolmogorovSmirnovTest(new ChiSquaredDistribution(channels), odd) > 0.01);
    }

    @Test
    void oneSensorSharesWithTheInput() {
        // Half of a difference of five is the input's: 2.5² + 2.5².
        assertEquals(12.5, oddness(1, Set.of(0), new double[] {0, -2.5, 0, 2.5}), 1e-12);
        assertEquals(12.5, oddness(1, Set.of(0), new double[] {0, 0, 0, 5}), 1e-12);
    }

    @Test
    void allTogetherAreTheInputs() {
        assertTrue(oddness(3, Set.of(1), new double[] {0, 0, 0, 5, 0, 5, 0, 5}) < 3);
        assertTrue(oddness(3, Set.of(1), new double[] {0, 0, 0, 0, 0, 5, 0, 0}) > 18);
    }

    @Test
    void aSensorAtFaultIsNotAsked() {
        boolean[] off = new boolean[8];
        off[5] = true;
        assertEquals(0, new SensorDelays(errors(3), SAMPLE).oddness(Set.of(0), new double[] {0, 0, 0, 0, 0, 9, 0, 0}, off), 1e-12);
    }
}

package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.apache.commons.math3.stat.inference.KolmogorovSmirnovTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.diagnosis.measured.SmallError;

class SensorDelaysTest {

    private static final double SAMPLE = 0.01;

    /** Gain and delay of some sensors and of the input's. */
    private static List<SmallError> errors(int outputs) {
        return IntStream.range(SmallError.INPUT, outputs).boxed().flatMap(owner -> Stream
                .of(new SmallError(SmallError.Kind.GAIN, owner, ""), new SmallError(SmallError.Kind.DELAY, owner, ""))).toList();
    }

    private static SensorDelays delays(int outputs) {
        return new SensorDelays(errors(outputs), IntStream.range(0, outputs).boxed().toList(), SAMPLE);
    }

    private static double oddness(int outputs, int asked, double[] sizes) {
        return delays(outputs).oddness(List.of(asked), sizes, new boolean[sizes.length]);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3, 5})
    void scatterIsOddAsChiSquaredIsDistributed(int outputs) {
        RandomGenerator random = new Well19937c(11);
        double[] odd = IntStream.range(0, 2000).mapToDouble(draw -> oddness(outputs, 0,
                IntStream.range(0, 2 * outputs + 2).mapToDouble(error -> random.nextGaussian()).toArray())).toArray();
        assertTrue(new KolmogorovSmirnovTest().kolmogorovSmirnovTest(new ChiSquaredDistribution(1), odd) > 0.01);
    }

    @Test
    void channelsOfADeviceAreLateTogether() {
        SmallError clock = new SmallError(SmallError.Kind.DELAY, 0, "");
        SmallError other = new SmallError(SmallError.Kind.DELAY, 2, "");
        SensorDelays delays = new SensorDelays(List.of(clock, other), List.of(0, 0, 2), SAMPLE);
        double[] sizes = {2, 1};
        assertEquals(0.002, delays.of(1, sizes), 1e-15);
        assertEquals(delays.oddness(List.of(0), sizes, new boolean[2]), delays.oddness(List.of(0, 1), sizes, new boolean[2]), 0);
        double[] spectrum = {1, 0};
        Lateness late = delays.about(sizes).lateness(new double[] {100}, new boolean[2], 3);
        double[][] read = late.of(new double[][] {spectrum, spectrum, spectrum});
        assertArrayEquals(new double[] {Math.cos(0.2), -Math.sin(0.2)}, read[0], 1e-12);
        assertArrayEquals(read[0], read[1], 0);
        assertArrayEquals(new double[] {Math.cos(0.1), -Math.sin(0.1)}, read[2], 1e-12);
    }

    @Test
    void oneSensorSharesWithTheInput() {
        // Half of a difference of five is the input's: 2.5² + 2.5².
        assertEquals(12.5, oddness(1, 0, new double[] {0, -2.5, 0, 2.5}), 1e-12);
        assertEquals(12.5, oddness(1, 0, new double[] {0, 0, 0, 5}), 1e-12);
    }

    @Test
    void allTogetherAreTheInputs() {
        assertTrue(oddness(3, 1, new double[] {0, 0, 0, 5, 0, 5, 0, 5}) < 3);
        assertTrue(oddness(3, 1, new double[] {0, 0, 0, 0, 0, 5, 0, 0}) > 18);
    }

    @Test
    void aSensorAtFaultIsNotAsked() {
        boolean[] off = new boolean[8];
        off[5] = true;
        assertEquals(0, delays(3).oddness(List.of(0), new double[] {0, 0, 0, 0, 0, 9, 0, 0}, off), 1e-12);
    }
}

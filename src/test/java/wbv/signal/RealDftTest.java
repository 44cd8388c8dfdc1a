package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RealDftTest {

    @ParameterizedTest
    @ValueSource(ints = {2, 4, 6, 10, 16, 30, 60, 90, 96, 250, 360})
    void equalsTheDefinition(int n) {
        double[] x = new Random(n).doubles(n, -1, 1).toArray();
        double[] spectrum = new RealDft(n).forward(x);
        for (int k = 0; k <= n / 2; k++) {
            double re = 0;
            double im = 0;
            for (int i = 0; i < n; i++) {
                re += x[i] * Math.cos(2 * Math.PI * k * i / n);
                im -= x[i] * Math.sin(2 * Math.PI * k * i / n);
            }
            assertEquals(re, spectrum[2 * k], 1e-12 * n);
            assertEquals(im, spectrum[2 * k + 1], 1e-12 * n);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 4, 6, 10, 16, 30, 60, 90, 96, 250, 360, 1024, 6000})
    void theInverseGivesTheSequenceBack(int n) {
        double[] x = new Random(n).doubles(n, -1, 1).toArray();
        RealDft dft = new RealDft(n);
        double[] back = dft.inverse(dft.forward(x));
        for (int i = 0; i < n; i++) {
            assertEquals(x[i], back[i], 1e-13 * n);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 6, 30, 250, 1024})
    void firstLinesAndValuesAreThoseOfTheWhole(int n) {
        RealDft dft = new RealDft(n);
        double[] spectrum = dft.forward(Arrays.copyOf(new double[] {1, -2}, n));
        double[] sequence = dft.inverse(spectrum);
        for (int lines = 1; lines <= n / 2 + 1; lines++) {
            assertArrayEquals(Arrays.copyOf(spectrum, 2 * lines), dft.forward(new double[] {1, -2}, lines));
        }
        for (int count = 0; count <= n; count++) {
            assertArrayEquals(Arrays.copyOf(sequence, count), dft.inverse(spectrum, count));
        }
    }

    @Test
    void anObjectServesManyThreads() {
        RealDft dft = new RealDft(600);
        double[][] sequences = IntStream.range(0, 200).mapToObj(seed -> new Random(seed).doubles(600).toArray()).toArray(double[][]::new);
        double[][] alone = Arrays.stream(sequences).map(dft::forward).toArray(double[][]::new);
        double[][] together = Arrays.stream(sequences).parallel().map(dft::forward).toArray(double[][]::new);
        for (int i = 0; i < alone.length; i++) {
            assertArrayEquals(alone[i], together[i]);
        }
    }

    @Test
    void fittingLengthsHaveSmallFactorsOnly() {
        assertEquals(6000, RealDft.fitting(6001));
        assertEquals(5832, RealDft.fitting(5999 - 100));
        assertEquals(6000, RealDft.covering(5833));
        assertFalse(RealDft.fits(3));
        assertThrows(IllegalArgumentException.class, () -> new RealDft(14));
    }
}

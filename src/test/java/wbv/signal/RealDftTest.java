package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
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

    @Test
    void fittingLengthsHaveSmallFactorsOnly() {
        assertEquals(6000, RealDft.fitting(6001));
        assertEquals(5832, RealDft.fitting(5999 - 100));
        assertEquals(6000, RealDft.covering(5833));
        assertFalse(RealDft.fits(3));
        assertThrows(IllegalArgumentException.class, () -> new RealDft(14));
    }
}

package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TaperTest {

    /** Of half a cosine the square is 3/8 in the mean. */
    @ParameterizedTest
    @ValueSource(doubles = {1.0 / 16, 1.0 / 4, 1.0 / 2})
    void endsComeAndGo(double part) {
        Taper taper = Taper.ends(1600, part);
        assertEquals(0, taper.weight(0), 0);
        assertEquals(0.5, taper.weight((int) (800 * part)), 1e-12);
        assertEquals(1, taper.weight(800), 1e-12);
        assertEquals(taper.weight(17), taper.weight(1600 - 17), 1e-12);
        assertEquals(1600 * (1 - 2 * part + 2 * part * 3 / 8), taper.power(), 1e-9);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.1, 0.6, Double.NaN})
    void endsTakeNoMoreThanHalf(double part) {
        assertThrows(IllegalArgumentException.class, () -> Taper.ends(100, part));
    }
}

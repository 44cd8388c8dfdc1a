package wbv.pole;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PoleWindowsTest {

    /** Whatever a file of polygons says, a window's samples fit into memory. */
    @ParameterizedTest
    @CsvSource({"0, 5, 4", "25, 0, 4", "1e308, 5, 4", "25, 1e9, 4", "NaN, 5, 4", "25, 5, 1", "25, 5, 21"})
    void windowsOfNobodyAreRefused(double length, double hop, int poles) {
        assertTrue(assertThrows(IllegalArgumentException.class, () -> new PoleWindows(length, hop, poles)).getMessage()
                .startsWith("window and hop must be > 0 to 3600.0 s"));
    }
}

package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** How sharply evidence tells, held to its own definition. */
class CalibrationTest {

    private static final double STEP = 1e-3;

    private final Calibration calibration = Calibration.standard();

    /** By second differences of the evidence of a number that is off by so much, over those of half the sum of squares. */
    @ParameterizedTest
    @CsvSource({"88, 238", "3, 5000", "1.5, 4000", "1.01, 4000", "0.9, 700"})
    void numbersAreToldAsSharplyAsTheEvidenceFalls(double least, double degrees) {
        double curvature = 20;
        double left = least + curvature * STEP * STEP / degrees;
        double falls = -2 * (calibration.evidence(left, least) - calibration.evidence(least, least)) / (STEP * STEP);
        assertEquals(falls / curvature, calibration.sharpness(least, degrees), 1e-3 * falls / curvature);
    }

    /** However few data there are, they tell no more than if all that they leave were noise. */
    @Test
    void noiseAloneTellsMost() {
        assertEquals(1, calibration.sharpness(1.001, 20));
    }
}

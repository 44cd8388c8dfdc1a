package wbv.filter.drift;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ProbabilityTest {

    /** Quantiles of χ² with one degree of freedom from tables. */
    @ParameterizedTest
    @CsvSource({"0, 0", "0.00393214, 0.05", "0.10153104, 0.25", "0.45493642, 0.5", "1.32330370, 0.75", "3.84145882, 0.95",
        "6.63489660, 0.99", "10.8275662, 0.999", "1e300, 1"})
    void quantilesHaveTheirProbability(double quantile, double probability) {
        assertEquals(probability, Probability.chiSquare1(quantile), 3e-7);
    }
}

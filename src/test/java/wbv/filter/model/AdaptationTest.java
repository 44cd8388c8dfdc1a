package wbv.filter.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.apache.commons.math3.analysis.integration.SimpsonIntegrator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AdaptationTest {

    @Test
    void usualNumbersAreAccepted() {
        assertEquals(10, Adaptation.USUAL.wandering().ratio());
    }

    @Test
    void whatCannotBeIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new Adaptation.Scatter(0, 20));
        assertThrows(IllegalArgumentException.class, () -> new Adaptation.Scatter(3, Double.NaN));
        assertThrows(IllegalArgumentException.class, () -> new Adaptation.Prior(0.5, 1, 1, 0.9, 0.8), "the second mode below the first");
        assertThrows(IllegalArgumentException.class, () -> new Adaptation.Particles(1.1, 40, 0.25, 0.5, 0.5, 20, 0.03, 1.5));
        assertThrows(IllegalArgumentException.class, () -> new Adaptation.Particles(0.98, 40, 0.25, 0.5, 30, 20, 0.03, 1.5));
    }

    /** E[min(z², m)] of a standard normal z, by quadrature. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 2, 4, 8})
    void surpriseThatIsExpectedIsTheMeanOfALimitedSquare(double most) {
        double mean = 2 * new SimpsonIntegrator().integrate(10_000_000,
                z -> Math.min(z * z, most) * Math.exp(-z * z / 2) / Math.sqrt(2 * Math.PI), 0, 9);
        assertEquals(mean, new Adaptation.Wandering(0.5, 0.1, 60, 0.25, 10, 300, 3, 2, most).expectedSurprise(), 6e-5);
    }
}

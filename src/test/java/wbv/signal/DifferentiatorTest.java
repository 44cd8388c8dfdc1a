package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DifferentiatorTest {

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 2, 8, 15, 20, 24})
    void theDerivativeOfASineIsItsCosine(double f) {
        Differentiator derivative = new Differentiator(60);
        double w = 2 * Math.PI * f;
        for (int n = 0; n < 400; n++) {
            double found = derivative.accept(Math.sin(w * n / 60 + 0.3));
            if (n >= 2 * derivative.delay()) {
                assertEquals(Math.cos(w * (n - derivative.delay()) / 60 + 0.3), found / w, 1e-3);
            } else {
                assertTrue(Double.isNaN(found));
            }
        }
    }

    @Test
    void aMissingSampleIsMissedOnlyWithinReach() {
        Differentiator derivative = new Differentiator(100);
        for (int n = 0; n < 300; n++) {
            double found = derivative.accept(n == 150 ? Double.NaN : 3 * n / 100.0);
            int centre = n - derivative.delay();
            boolean near = Math.abs(centre - 150) <= derivative.delay() && centre != 150;
            if (n >= 2 * derivative.delay()) {
                assertEquals(near, Double.isNaN(found), "sample " + n);
                assertTrue(near || Math.abs(found - 3) < 3e-3);
            }
        }
    }
}

package wbv.filter.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class InterpolantTest {

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void aPolynomialOfItsDegreePassesUnchanged(int m) {
        double[] samples = new double[2 * m];
        for (int i = 0; i < samples.length; i++) {
            samples[i] = polynomial(i - m + 1, 2 * m - 1);
        }
        double[] c = new double[8];
        new Interpolant(m).coefficients(samples, 0, c);
        for (double s : new double[] {0, 0.3, 0.5, 1}) {
            double value = 0;
            for (int j = 7; j >= 0; j--) {
                value = value * s + c[j];
            }
            assertEquals(polynomial(s, 2 * m - 1), value, 1e-9 * Math.max(1, Math.abs(value)));
        }
    }

    private static double polynomial(double s, int degree) {
        double value = 0;
        for (int j = degree; j >= 0; j--) {
            value = value * s + (j % 3 - 0.7);
        }
        return value;
    }
}

package wbv.filter.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.complex.Complex;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TwoDegreesTest {

    private static final Spec SPEC = Spec.at(60).startingAt(5, 0.3);
    private static final double REFERENCE = 2 * Math.PI * 5;

    /** A chain of two masses: what the head's mass does when the platform moves, straight from Newton. */
    private static Complex chain(double f) {
        double m1 = 50.2;
        double k1 = 74300;
        double c1 = 2807;
        double m2 = 5.5;
        double k2 = 41000;
        double c2 = 318;
        Complex s = new Complex(0, 2 * Math.PI * f);
        Complex z1 = s.multiply(c1).add(k1);
        Complex z2 = s.multiply(c2).add(k2);
        Complex s2 = s.multiply(s);
        Complex a = s2.multiply(m1).add(z1).add(z2);
        Complex d = s2.multiply(m2).add(z2);
        return z1.multiply(z2).divide(a.multiply(d).subtract(z2.multiply(z2)));
    }

    /** The modal form has the numbers to be that chain exactly: poles, share and cross term solved from three frequencies. */
    @Test
    void aChainOfTwoMassesIsOneOfThese() {
        double[] xi = chainEstimate();
        TwoDegrees model = new TwoDegrees(SPEC, true);
        for (double f = 0.5; f < 25; f += 0.7) {
            assertEquals(chain(f).abs(), model.modulus(f, xi), 1e-6 * chain(f).abs(), f + " Hz");
        }
        assertEquals(1, model.modulus(1e-4, xi), 1e-6);
    }

    private static double[] chainEstimate() {
        double w1 = 36.86617461089239;
        double z1 = 0.6806834719039474;
        double w2 = 90.10005502267879;
        double z2 = 0.38779547002835263;
        // H = g H1 + (1 - g) H2 + h (C1 - C2): linear in g and h, from real and imaginary part at one frequency
        Complex s = new Complex(0, 2 * Math.PI * 8);
        Complex h1 = mode(s, w1, z1);
        Complex h2 = mode(s, w2, z2);
        Complex x = cross(s, w1, z1).subtract(cross(s, w2, z2));
        Complex left = chain(8).subtract(h2);
        Complex d = h1.subtract(h2);
        double determinant = d.getReal() * x.getImaginary() - d.getImaginary() * x.getReal();
        double g = (left.getReal() * x.getImaginary() - left.getImaginary() * x.getReal()) / determinant;
        double h = (d.getReal() * left.getImaginary() - d.getImaginary() * left.getReal()) / determinant;
        return new double[] {0, 0, 0, 0, Math.log(w1), Math.log(z1), Math.log(w2), Math.log(z2), g, h, 0};
    }

    private static Complex denominator(Complex s, double w, double z) {
        return s.multiply(s).add(s.multiply(2 * z * w)).add(w * w);
    }

    private static Complex mode(Complex s, double w, double z) {
        return s.multiply(2 * z * w).add(w * w).divide(denominator(s, w, z));
    }

    private static Complex cross(Complex s, double w, double z) {
        return s.multiply(w * w / REFERENCE).divide(denominator(s, w, z));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5})
    void slopesOfTheOutputAreItsDifferences(int parameter) {
        double[] xi = {0.01, -0.02, 0.004, 0.006, Math.log(30), Math.log(0.4), Math.log(80), Math.log(0.3), 0.7, 0.2, 0};
        TwoDegrees model = new TwoDegrees(SPEC, true);
        model.setOutput(xi);
        double slope = model.outputSlope(parameter, xi);
        double[] row = new double[4];
        model.outputRow(row);
        double sum = 0;
        for (int i = 0; i < 4; i++) {
            sum += row[i] * xi[i];
        }
        assertEquals(model.output(xi), sum, 1e-12);
        double step = 1e-6;
        double[] moved = xi.clone();
        moved[4 + parameter] += step;
        model.setOutput(moved);
        double after = model.output(moved);
        moved[4 + parameter] -= 2 * step;
        model.setOutput(moved);
        assertEquals((after - model.output(moved)) / (2 * step), slope, 1e-6 * (1 + Math.abs(slope)));
    }

    @Test
    void theSlowerModeComesFirst() {
        double[] xi = chainEstimate();
        double share = new TwoDegrees(SPEC, true).share(xi);
        double[] swapped = {0, 0, 0, 0, xi[6], xi[7], xi[4], xi[5], 1 - xi[8], -xi[9], 0};
        assertEquals(share, new TwoDegrees(SPEC, true).share(swapped), 1e-12);
        assertTrue(share > 0.5, "the torso's mode carries the head at rest: " + share);
    }
}

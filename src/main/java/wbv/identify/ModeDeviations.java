package wbv.identify;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.apache.commons.math3.complex.Complex;
import org.ejml.data.Complex_F64;

/**
 * Modes of a polynomial whose coefficients are known with a covariance, by linear propagation: a root z of
 * {@code p(z) = z^n + a_1 z^(n-1) + … + a_n} moves by {@code ∂z/∂a_i = -z^(n-i)/p'(z)}.
 */
final class ModeDeviations {

    private static final double REAL = 1e-9;

    private ModeDeviations() {}

    /**
     * Of the z-plane.
     *
     * @param rate [Hz]
     */
    static List<EquivalentBody.Mode> ofDiscrete(double[] a, double[][] covariance, double rate) {
        List<EquivalentBody.Mode> modes = new ArrayList<>();
        for (Complex z : above(a)) {
            if (z.abs() < 1) {
                Complex[] slopes = slopes(a, z);
                for (int i = 0; i < slopes.length; i++) {
                    slopes[i] = slopes[i].divide(z).multiply(rate); // s = rate ln z
                }
                modes.add(mode(z.log().multiply(rate), slopes, covariance));
            }
        }
        return sorted(modes);
    }

    /** Of the s-plane. */
    static List<EquivalentBody.Mode> ofContinuous(double[] a, double[][] covariance) {
        List<EquivalentBody.Mode> modes = new ArrayList<>();
        for (Complex s : above(a)) {
            if (s.getReal() < 0) {
                modes.add(mode(s, slopes(a, s), covariance));
            }
        }
        return sorted(modes);
    }

    private static List<EquivalentBody.Mode> sorted(List<EquivalentBody.Mode> modes) {
        modes.sort(Comparator.comparingDouble(EquivalentBody.Mode::frequency));
        return List.copyOf(modes);
    }

    /** Roots above the real axis. */
    private static List<Complex> above(double[] a) {
        List<Complex> found = new ArrayList<>();
        for (Complex_F64 root : Polynomial.roots(a)) {
            if (root.imaginary > REAL * root.getMagnitude()) {
                found.add(new Complex(root.real, root.imaginary));
            }
        }
        return found;
    }

    private static Complex[] slopes(double[] a, Complex z) {
        int n = a.length;
        Complex derivative = Complex.ZERO;
        Complex power = Complex.ONE; // z^(n-1-i), from the last coefficient up
        for (int i = n - 1; i >= 0; i--) {
            derivative = derivative.add(power.multiply((n - i) * (i == 0 ? 1 : a[i - 1])));
            power = power.multiply(z);
        }
        Complex[] slopes = new Complex[n];
        power = Complex.ONE;
        for (int i = n - 1; i >= 0; i--) {
            slopes[i] = power.divide(derivative).negate();
            power = power.multiply(z);
        }
        return slopes;
    }

    private static EquivalentBody.Mode mode(Complex s, Complex[] slopes, double[][] covariance) {
        double size = s.abs();
        int n = slopes.length;
        double[] frequency = new double[n];
        double[] damping = new double[n];
        for (int i = 0; i < n; i++) {
            double along = s.conjugate().multiply(slopes[i]).getReal() / size; // ∂|s|
            frequency[i] = along / (2 * Math.PI);
            damping[i] = (-slopes[i].getReal() + s.getReal() * along / size) / size;
        }
        return new EquivalentBody.Mode(size / (2 * Math.PI), deviation(frequency, covariance), -s.getReal() / size,
                deviation(damping, covariance));
    }

    private static double deviation(double[] slope, double[][] covariance) {
        double sum = 0;
        for (int i = 0; i < slope.length; i++) {
            for (int j = 0; j < slope.length; j++) {
                sum += slope[i] * covariance[i][j] * slope[j];
            }
        }
        return Math.sqrt(sum);
    }
}

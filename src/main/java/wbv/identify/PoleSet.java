package wbv.identify;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.ejml.data.Complex_F64;

/**
 * The poles of a model in the s-plane, sorted by what they are.
 *
 * @param modes   motions that oscillate and die away, lowest frequency first; one of each conjugate pair
 * @param decays  real poles [rad/s], slowest first: no modes
 * @param growing pairs and real poles on or right of the imaginary axis: what no seated body has
 * @param mapless real poles of the z-plane that are not positive, for which {@code s = ln(z)/T} has no real counterpart
 */
public record PoleSet(List<Pole> modes, List<Double> decays, List<Pole> growing, int mapless) {

    private static final double REAL = 1e-9;

    public PoleSet {
        modes = List.copyOf(modes);
        decays = List.copyOf(decays);
        growing = List.copyOf(growing);
    }

    /**
     * Of {@code 1 + a_1 z⁻¹ + … + a_n z⁻ⁿ}, through {@code s = ln(z)/T}.
     *
     * @param a    coefficients after the leading 1 [1], n long. Not modified.
     * @param rate 1/T [Hz]
     */
    public static PoleSet ofDiscrete(double[] a, double rate) {
        List<Pole> found = new ArrayList<>();
        int mapless = 0;
        for (Complex_F64 z : Polynomial.roots(a)) {
            boolean real = Math.abs(z.imaginary) < REAL * z.getMagnitude();
            if (z.imaginary < 0 && !real) {
                continue;
            }
            if (real && z.real <= 0 || z.getMagnitude() == 0) {
                mapless++;
            } else {
                found.add(new Pole(rate * Math.log(z.getMagnitude()), real ? 0 : rate * Math.atan2(z.imaginary, z.real)));
            }
        }
        return sorted(found, mapless);
    }

    /**
     * Of {@code s^n + p_1 s^(n-1) + … + p_n}.
     *
     * @param p coefficients after the leading 1, n long, p_i [(rad/s)^i]. Not modified.
     */
    public static PoleSet ofContinuous(double[] p) {
        List<Pole> found = new ArrayList<>();
        for (Complex_F64 s : Polynomial.roots(p)) {
            boolean real = Math.abs(s.imaginary) < REAL * s.getMagnitude();
            if (real || s.imaginary > 0) {
                found.add(new Pole(s.real, real ? 0 : s.imaginary));
            }
        }
        return sorted(found, 0);
    }

    private static PoleSet sorted(List<Pole> found, int mapless) {
        return new PoleSet(found.stream().filter(Pole::mode).sorted(Comparator.comparingDouble(Pole::frequency)).toList(),
                found.stream().filter(p -> p.im() == 0 && p.re() < 0).map(Pole::re).sorted(Comparator.reverseOrder()).toList(),
                found.stream().filter(p -> p.re() >= 0).toList(), mapless);
    }
}

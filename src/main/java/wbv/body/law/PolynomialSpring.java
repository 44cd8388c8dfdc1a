package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A spring that stiffens with deflection, more so one way: k2 r² + k3 r³.
 *
 * @param quadratic k2 [N/m²]
 * @param cubic k3 [N/m³], &gt;= 0, or the quadratic term would pull the ends apart
 */
public record PolynomialSpring(@Key("k2_N_per_m2") double quadratic, @Key("k3_N_per_m3") double cubic) implements Law {
    public PolynomialSpring {
        Check.finite("quadratic stiffness", "N/m²", quadratic);
        Check.notNegative("cubic stiffness", "N/m³", cubic);
    }

    @Override
    public String mechanism() {
        return "stiffness.hardening";
    }

    @Override
    public double force(LinkMotion m) {
        double r = m.displacement;
        return (quadratic + cubic * r) * r * r;
    }
}

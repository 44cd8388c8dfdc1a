package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A term that is even in the deflection, k2 r²: stiffer one way, softer the other.
 *
 * @param quadratic [N/m²]
 */
public record QuadraticSpring(@Key("k2_N_per_m2") double quadratic) implements Law {
    public QuadraticSpring {
        Check.finite("quadratic stiffness", "N/m²", quadratic);
    }

    @Override
    public String mechanism() {
        return "stiffness.asymmetric";
    }

    @Override
    public double force(LinkMotion m) {
        return quadratic * m.displacement * m.displacement;
    }
}

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * Quadratic damping c2 v |v|.
 *
 * @param quadratic [N s²/m²]
 */
public record QuadraticDamping(@Key("c2_Ns2_per_m2") double quadratic) implements Law {
    public QuadraticDamping {
        Check.finite("quadratic damping", "N s²/m²", quadratic);
    }

    @Override
    public String mechanism() {
        return "damping.quadratic";
    }

    @Override
    public double force(LinkMotion m) {
        return quadratic * m.velocity * Math.abs(m.velocity);
    }
}

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A cubic term k3 r³. A softening one stops at the deflection where the whole spring would lose its stiffness, and stays
 * at that force: beyond it the polynomial is no physics.
 *
 * @param cubic [N/m³], negative softens, positive hardens
 */
public record CubicSpring(@Key("k3_N_per_m3") double cubic) implements Law {
    public CubicSpring {
        Check.finite("cubic stiffness", "N/m³", cubic);
    }

    @Override
    public String mechanism() {
        return cubic < 0 ? "stiffness.softening" : "stiffness.hardening";
    }

    @Override
    public double force(LinkMotion m) {
        double r = m.displacement;
        if (cubic < 0 && 3 * -cubic * r * r > m.stiffness) {
            double flat = Math.copySign(Math.sqrt(m.stiffness / (-3 * cubic)), r);
            return m.stiffness * flat + cubic * flat * flat * flat - m.stiffness * r;
        }
        return cubic * r * r * r;
    }
}

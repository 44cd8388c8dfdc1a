package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * Dry friction F tanh(v / v0).
 *
 * @param friction F [N], &gt;= 0
 * @param transition velocity v0 below which it is viscous [m/s], &gt; 0
 */
public record CoulombFriction(@Key("friction_N") double friction, @Key("transition_m_per_s") double transition) implements Law {
    public CoulombFriction {
        Check.notNegative("friction", "N", friction);
        Check.positive("transition velocity", "m/s", transition);
    }

    @Override
    public String mechanism() {
        return "friction.coulomb";
    }

    @Override
    public double force(LinkMotion m) {
        return friction * tanh(m.velocity / transition);
    }

    /** With an absolute error of 2e-16; {@link Math#tanh}, which is right near 0 too, takes three times as long. */
    private static double tanh(double x) {
        double decay = Math.exp(-2 * Math.abs(x));
        return Math.copySign((1 - decay) / (1 + decay), x);
    }
}

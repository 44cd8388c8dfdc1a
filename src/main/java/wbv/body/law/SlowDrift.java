package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * Stiffness and damping drift with time t as 1 + g, g = linear t + quadratic t² (t in units of 100 s), never below 3 % of the
 * linear value.
 *
 * @param linear [1/(100 s)]
 * @param quadratic [1/(100 s)²]
 * @param dampingShare part of g that the damping follows [1]; it keeps at least 3 % of its value
 */
public record SlowDrift(@Key("linear_per_100s") double linear, @Key("quadratic_per_100s2") double quadratic,
        @Key("damping_share") double dampingShare) implements Law {
    private static final double FLOOR = -0.97;

    public SlowDrift {
        Check.finite("linear drift", "1/(100 s)", linear);
        Check.finite("quadratic drift", "1/(100 s)²", quadratic);
        Check.finite("share of the drift in the damping", "1", dampingShare);
    }

    @Override
    public String mechanism() {
        return "drift.slow";
    }

    @Override
    public double force(LinkMotion m) {
        double t = m.time / 100;
        double g = Math.max(FLOOR, linear * t + quadratic * t * t);
        double gc = Math.max(FLOOR, dampingShare * g);
        return g * m.stiffness * m.displacement + gc * m.damping * m.velocity;
    }
}

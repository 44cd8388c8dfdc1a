package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * Stiffness and damping settle from their values at the start to others, as what creeps or warms does: they change with time t as
 * {@code 1 + change (1 - e^(-t/τ))}.
 *
 * @param change       of the stiffness in the end, as a part of that at the start [1], &gt;= -0.97
 * @param settling τ [s], &gt; 0
 * @param dampingShare part of the change that the damping follows [1]; damping keeps at least 3 % of its value
 */
public record Settling(@Key("settled_change") double change, @Key("settling_s") double settling, @Key("damping_share") double dampingShare)
        implements Law {
    private static final double FLOOR = -0.97;

    public Settling {
        Check.within("settled change", "1", change, FLOOR, 1e3);
        Check.positive("settling time", "s", settling);
        Check.finite("share of the change in the damping", "1", dampingShare);
    }

    @Override
    public String mechanism() {
        return "drift.slow";
    }

    @Override
    public double force(LinkMotion m) {
        double g = change * -Math.expm1(-m.time / settling);
        return g * m.stiffness * m.displacement + Math.max(FLOOR, dampingShare * g) * m.damping * m.velocity;
    }
}

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A spring that turns from one stiffness to a higher one: added stiffness times {@code r³ / (r² + knee²)}, cubic at first, straight in the
 * end.
 *
 * @param added stiffness far beyond the knee, above the linear one [N/m], &gt;= 0
 * @param knee deflection at which half of it works [m], &gt; 0
 */
public record ProgressiveSpring(@Key("added_stiffness_N_per_m") double added, @Key("knee_m") double knee) implements Law {
    public ProgressiveSpring {
        Check.notNegative("added stiffness", "N/m", added);
        Check.positive("knee", "m", knee);
    }

    @Override
    public String mechanism() {
        return "stiffness.hardening";
    }

    @Override
    public double force(LinkMotion m) {
        double r = m.displacement;
        return added * r * r * r / (r * r + knee * knee);
    }
}

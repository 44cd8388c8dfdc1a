package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A spring that saturates: k r becomes k r / sqrt(1 + (r/knee)²).
 *
 * @param knee where softening sets in [m], &gt; 0
 */
public record SaturatingSpring(@Key("knee_m") double knee) implements Law {
    public SaturatingSpring {
        Check.positive("knee", "m", knee);
    }

    @Override
    public String mechanism() {
        return "stiffness.softening";
    }

    @Override
    public double force(LinkMotion m) {
        double r = m.displacement;
        double u = r / knee;
        return m.stiffness * r * (1 / Math.sqrt(1 + u * u) - 1);
    }
}

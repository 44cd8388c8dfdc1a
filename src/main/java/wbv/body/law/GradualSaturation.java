package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A spring that saturates sooner or later: k r becomes k r / (1 + |r/knee|ⁿ)^(1/n) (the backbone of Menegotto and Pinto 1973 without
 * hardening), of which {@link SaturatingSpring} is n = 2.
 *
 * @param knee where a spring as stiff as at rest would carry all that this one ever does [m], &gt; 0
 * @param sharpness n, how narrow the bend is [1], &gt; 0
 */
public record GradualSaturation(@Key("knee_m") double knee, @Key("sharpness") double sharpness) implements Law {
    public GradualSaturation {
        Check.positive("knee", "m", knee);
        Check.positive("sharpness", "1", sharpness);
    }

    @Override
    public String mechanism() {
        return "stiffness.softening";
    }

    @Override
    public double force(LinkMotion m) {
        double r = m.displacement;
        return m.stiffness * r * (Math.pow(1 + Math.pow(Math.abs(r) / knee, sharpness), -1 / sharpness) - 1);
    }
}

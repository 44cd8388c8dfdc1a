package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * Play in the joint: the spring is slack within the gap.
 *
 * @param gap half the play [m], &gt;= 0
 */
public record Backlash(@Key("gap_m") double gap) implements Law {
    public Backlash {
        Check.notNegative("gap", "m", gap);
    }

    @Override
    public String mechanism() {
        return "contact.backlash";
    }

    @Override
    public double force(LinkMotion m) {
        return -m.stiffness * Math.max(-gap, Math.min(gap, m.displacement));
    }
}

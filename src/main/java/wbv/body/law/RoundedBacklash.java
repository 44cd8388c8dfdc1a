package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Rounded;

/**
 * Play whose ends are soft: the spring takes hold over the width of the edge instead of at once, and what is slack damps less.
 *
 * @param gap half the play [m], &gt;= 0
 * @param edge width over which the spring takes hold [m], &gt; 0
 * @param slack part of the link's damping that goes with its stiffness, 0 to 1
 */
public record RoundedBacklash(@Key("gap_m") double gap, @Key("edge_m") double edge, @Key("slack_damping") double slack) implements Law {
    public RoundedBacklash {
        Check.notNegative("gap", "m", gap);
        Check.positive("edge", "m", edge);
        Check.within("slack damping", "1", slack, 0, 1);
    }

    @Override
    public String mechanism() {
        return "contact.backlash";
    }

    @Override
    public double force(LinkMotion m) {
        double r = m.displacement;
        double held = Rounded.slope(r - gap, edge) + Rounded.slope(-r - gap, edge);
        return -m.stiffness * (r - Rounded.ramp(r - gap, edge) + Rounded.ramp(-r - gap, edge))
                - slack * m.damping * m.velocity * (1 - held);
    }
}

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Rounded;

/**
 * Contact that is lost, and found again, over a range of force instead of at once, as a soft seat lets go.
 *
 * @param preload static force [N], &gt;= 0
 * @param edge range of force over which it lets go [N], &gt; 0
 */
public record RoundedContactLoss(@Key("preload_N") double preload, @Key("edge_N") double edge) implements Law {
    public RoundedContactLoss {
        Check.notNegative("preload", "N", preload);
        Check.positive("edge", "N", edge);
    }

    @Override
    public String mechanism() {
        return "contact.loss";
    }

    @Override
    public double force(LinkMotion m) {
        return -Rounded.ramp(m.stiffness * m.displacement + m.damping * m.velocity - preload, edge);
    }
}

package wbv.body;

/**
 * Play whose ends are soft: the spring takes hold over the width of the edge instead of at once.
 *
 * @param gap half the play [m], &gt;= 0 @param edge width over which the spring takes hold [m], &gt; 0
 */
public record RoundedBacklash(@Key("gap_m") double gap, @Key("edge_m") double edge) implements Law {
    public RoundedBacklash {
        Check.notNegative("gap", "m", gap);
        Check.positive("edge", "m", edge);
    }

    @Override
    public String mechanism() {
        return "contact.backlash";
    }

    @Override
    public double force(LinkMotion m) {
        double r = m.displacement;
        return -m.stiffness * (r - Rounded.ramp(r - gap, edge) + Rounded.ramp(-r - gap, edge));
    }
}

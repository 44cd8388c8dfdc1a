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
        return -m.stiffness * (r - beyond(r - gap) + beyond(-r - gap));
    }

    /** Nothing far below 0, x far above, a hyperbola between. */
    private double beyond(double x) {
        return (x + Math.sqrt(x * x + edge * edge)) / 2;
    }
}

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Rounded;

/**
 * A spring stiffer or softer in compression whose stiffness changes over a width instead of at once.
 *
 * @param ratio share of k added far in compression, &gt; -1
 * @param bend deflection over which it changes [m], &gt; 0
 */
public record BendingSpring(@Key("compression_ratio") double ratio, @Key("bend_m") double bend) implements Law {
    public BendingSpring {
        Check.above("compression ratio", "1", ratio, -1);
        Check.positive("bend", "m", bend);
    }

    @Override
    public String mechanism() {
        return "stiffness.asymmetric";
    }

    @Override
    public double force(LinkMotion m) {
        double r = m.displacement;
        return -ratio * m.stiffness * (Rounded.ramp(-r, bend) - bend / 2);
    }
}

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A rubber stop beyond a free travel: force over penetration to the power 3/2 (Hertz 1881).
 *
 * @param stop [N/m^1.5], &gt; 0
 *
 * @param gap free travel [m], &gt;= 0
 * @param side where
 */
public record HertzStop(@Key("stop_N_per_m1_5") double stop, @Key("gap_m") double gap, @Key("side") Law.Side side) implements Law {
    public HertzStop {
        Check.positive("stop stiffness", "N/m^1.5", stop);
        Check.notNegative("gap", "m", gap);
    }

    @Override
    public String mechanism() {
        return "contact.bumpstop";
    }

    @Override
    public double force(LinkMotion m) {
        double r = m.displacement;
        if (r < -gap && side != Law.Side.EXTENSION) {
            return -stop * Math.pow(-r - gap, 1.5);
        }
        return r > gap && side != Law.Side.COMPRESSION ? stop * Math.pow(r - gap, 1.5) : 0;
    }
}

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A stop beyond a free travel.
 *
 * @param stop stiffness of the stop [N/m], &gt; 0
 * @param gap free travel [m], &gt;= 0
 * @param side where
 */
public record BumpStop(@Key("stop_stiffness_N_per_m") double stop, @Key("gap_m") double gap, @Key("side") Law.Side side) implements Law {
    public BumpStop {
        Check.positive("stop stiffness", "N/m", stop);
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
            return stop * (r + gap);
        }
        return r > gap && side != Law.Side.COMPRESSION ? stop * (r - gap) : 0;
    }
}

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A share of the link's spring that gives way all at once, a Jenkins element (several side by side, Iwan 1966): share k (z - r), where z
 * follows r until it slips. Memory is z [m].
 *
 * @param share part of k that slides, 0 to 1
 * @param slip  deflection at which it slides [m], &gt; 0
 */
public record Slider(@Key("sliding_share") double share, @Key("slip_m") double slip) implements Law {
    public Slider {
        Check.within("sliding share", "1", share, 0, 1);
        Check.positive("slip deflection", "m", slip);
    }

    @Override
    public String mechanism() {
        return "hysteresis";
    }

    @Override
    public double force(LinkMotion m) {
        return share * m.stiffness * (remember(m) - m.displacement);
    }

    @Override
    public boolean hasMemory() {
        return true;
    }

    @Override
    public double remember(LinkMotion m) {
        return m.dragged(slip);
    }
}

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A spring beside the link's own that slides, a Jenkins element (several side by side, Iwan, Journal of Applied Mechanics 1966): h z, where
 * z follows r until it slips. Memory is z [m]. A {@link Slider} is the same as a part of the link's own spring.
 *
 * @param stiffness h while it sticks [N/m], &gt; 0
 * @param slip deflection at which it slides [m], &gt; 0
 */
public record JenkinsElement(@Key("sticking_N_per_m") double stiffness, @Key("slip_m") double slip) implements Law {
    public JenkinsElement {
        Check.positive("stiffness while it sticks", "N/m", stiffness);
        Check.positive("slip deflection", "m", slip);
    }

    @Override
    public String mechanism() {
        return "hysteresis";
    }

    @Override
    public double force(LinkMotion m) {
        return stiffness * remember(m);
    }

    @Override
    public double memoryOf(double force) {
        return Math.max(-slip, Math.min(slip, force / stiffness));
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

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A column of air that carries a load: k r becomes k h/n (1 - (1 + r/h)⁻ⁿ), n = 1.4 as heat has no time to leave (Poisson's adiabate). It
 * stiffens as it is compressed and softens as it is drawn out.
 *
 * @param column h, height of the column at rest [m], &gt; 0
 */
public record GasSpring(@Key("column_m") double column) implements Law {

    /** Ratio of the heat capacities of dry air at room temperature [1]. */
    private static final double ADIABATIC = 1.4;
    /** Part of its height to which a column can be compressed, and from which on it goes no further [1]: a guard. */
    private static final double LEAST = 0.05;

    public GasSpring {
        Check.positive("column", "m", column);
    }

    @Override
    public String mechanism() {
        return "stiffness.hardening";
    }

    @Override
    public double force(LinkMotion m) {
        double height = Math.max(LEAST, 1 + m.displacement / column);
        return m.stiffness * (column / ADIABATIC * (1 - Math.pow(height, -ADIABATIC)) - m.displacement);
    }
}

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A term of a law that was learned: a force on the relative acceleration of a link's ends (inerter: Smith 2002), by the trapezoidal rule.
 * Memory is the velocity that the link would have half-way through the step if its acceleration did not change.
 *
 * @param inertance [kg]
 */
public record LearnedInertance(@Key("inertance_kg") double inertance) implements Learned {
    public LearnedInertance {
        Check.finite("inertance", "kg", inertance);
    }

    @Override
    public double coefficient() {
        return inertance;
    }

    @Override
    public String unit() {
        return "kg";
    }

    @Override
    public String kind() {
        return "a";
    }

    @Override
    public double force(LinkMotion m) {
        return inertance * 2 * (m.velocity - m.memory) / m.step;
    }

    @Override
    public boolean isLinear() {
        return true;
    }

    @Override
    public void dynamicStiffness(double omega, double[] out) {
        out[0] = -omega * omega * inertance;
        out[1] = 0;
    }

    @Override
    public boolean hasMemory() {
        return true;
    }

    @Override
    public double remember(LinkMotion m) {
        return 2 * m.velocity - m.memory;
    }
}

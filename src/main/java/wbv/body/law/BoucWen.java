package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A share of the link's spring is elastoplastic (Bouc 1967, Wen 1976, with exponent 1 and β = γ = 1/2): share k (z - r) where
 * z follows r until it yields. Memory is z [m].
 *
 * @param share part of k that is hysteretic, 0 to 1
 * @param yield deflection at which it yields [m], &gt; 0
 */
public record BoucWen(@Key("share") double share, @Key("yield_m") double yield) implements Law {
    public BoucWen {
        Check.within("hysteretic share", "1", share, 0, 1);
        Check.positive("yield deflection", "m", yield);
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
        double travel = m.displacement - m.before;
        double z = m.memory;
        double sign = Math.signum(travel);
        if (z * sign < 0) {   // unloading is elastic until z passes zero
            double free = Math.min(Math.abs(z), Math.abs(travel));
            z += sign * free;
            travel -= sign * free;
        }
        double steady = sign * yield;
        return steady + (z - steady) * Math.exp(-Math.abs(travel) / yield);
    }
}

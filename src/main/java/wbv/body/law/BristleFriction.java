package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * Dry friction with elastic bristles and a Stribeck curve (Canudas de Wit, Olsson, Åström, Lischinsky 1995): memory is the
 * bristle deflection [m].
 *
 * @param friction kinetic friction [N]
 * @param breakaway static friction [N]
 * @param stribeck Stribeck velocity [m/s]
 * @param bristle bristle stiffness [N/m]
 */
public record BristleFriction(@Key("friction_N") double friction, @Key("breakaway_N") double breakaway,
        @Key("stribeck_m_per_s") double stribeck, @Key("bristle_N_per_m") double bristle) implements Law {
    public BristleFriction {
        Check.positive("friction", "N", friction);
        Check.positive("breakaway force", "N", breakaway);
        Check.positive("Stribeck velocity", "m/s", stribeck);
        Check.positive("bristle stiffness", "N/m", bristle);
    }

    @Override
    public String mechanism() {
        return "friction.coulomb";
    }

    @Override
    public double force(LinkMotion m) {
        return bristle * remember(m);
    }

    @Override
    public double memoryOf(double force) {
        return Math.max(-breakaway, Math.min(breakaway, force)) / bristle;
    }

    @Override
    public boolean hasMemory() {
        return true;
    }

    @Override
    public double remember(LinkMotion m) {
        // z' = v - |v| z σ0 / g(v) is linear in travelled distance at constant v: exact over a monotone step.
        double travel = m.displacement - m.before;
        double speed = travel / m.step;
        double g = friction + (breakaway - friction) * Math.exp(-(speed / stribeck) * (speed / stribeck));
        double steady = Math.copySign(g / bristle, travel);
        return steady + (m.memory - steady) * Math.exp(-Math.abs(travel) * bristle / g);
    }
}

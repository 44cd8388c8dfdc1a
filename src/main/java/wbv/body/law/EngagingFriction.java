package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * Dry friction that a reversal lets go and that has to build up again: self-energising contact, such as a band on a drum, whose pressure
 * grows with travel as a rope's pull on a capstan does (Euler 1769; Eytelwein 1808). Memory is the engagement z [m], which follows the
 * travel between ±{@code travel}; u = |z| / travel is how far that side has engaged, and the force is
 * F (e^(growth u) - 1) / (e^growth - 1). A great growth is play: no force over most of the travel.
 *
 * @param extension friction while the link extends [N], &gt;= 0
 * @param compression while it shortens [N], &gt;= 0
 * @param travel from disengaged to fully engaged [m], &gt; 0
 * @param growth [1], &gt; 0
 */
public record EngagingFriction(@Key("extension_friction_N") double extension, @Key("compression_friction_N") double compression,
        @Key("engagement_m") double travel, @Key("growth") double growth) implements Law {
    public EngagingFriction {
        Check.notNegative("friction in extension", "N", extension);
        Check.notNegative("friction in compression", "N", compression);
        Check.positive("engagement travel", "m", travel);
        Check.positive("growth", "1", growth);
    }

    @Override
    public String mechanism() {
        return "contact.backlash";
    }

    @Override
    public double force(LinkMotion m) {
        double z = remember(m);
        double engaged = Math.expm1(growth * Math.abs(z) / travel) / Math.expm1(growth);
        return z > 0 ? extension * engaged : -compression * engaged;
    }

    @Override
    public boolean hasMemory() {
        return true;
    }

    @Override
    public double remember(LinkMotion m) {
        return m.dragged(travel);
    }

    @Override
    public double memoryOf(double force) {
        double engaged = Math.min(1, Math.abs(force) / Math.max(force > 0 ? extension : compression, 1e-9));
        return Math.copySign(travel * Math.log1p(engaged * Math.expm1(growth)) / growth, force);
    }
}

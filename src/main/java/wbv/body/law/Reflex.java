package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * Muscle that answers the link's motion late: force at t from displacement and velocity at t - delay.
 *
 * @param stiffness [N/m]
 * @param damping [N s/m]
 * @param delay [s], &gt; 0
 */
public record Reflex(@Key("reflex_N_per_m") double stiffness, @Key("reflex_Ns_per_m") double damping,
        @Key("delay_s") double delay) implements Law {
    public Reflex {
        Check.finite("reflex stiffness", "N/m", stiffness);
        Check.finite("reflex damping", "N s/m", damping);
        Check.positive("delay", "s", delay);
    }

    @Override
    public String mechanism() {
        return "muscle.reflex";
    }

    @Override
    public double force(LinkMotion m) {
        return stiffness * m.lateDisplacement + damping * m.lateVelocity;
    }

    @Override
    public boolean isLinear() {
        return true;
    }

    @Override
    public void dynamicStiffness(double omega, double[] out) {
        double cos = Math.cos(omega * delay);
        double sin = Math.sin(omega * delay);
        out[0] = stiffness * cos + omega * damping * sin;
        out[1] = omega * damping * cos - stiffness * sin;
    }

    @Override
    public double lateness() {
        return delay;
    }
}

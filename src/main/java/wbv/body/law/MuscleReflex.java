package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * Muscle that answers the link's motion late, slowly, and only by pulling: what it is told, z, is displacement and velocity a delay ago,
 * low-passed by its twitch, and its force is z where that pulls its way; two that pull against each other do both. Memory is the low-passed
 * displacement q [m]: {@code z = k q + c (r - q) / twitch} with r a delay ago, so that no acceleration is asked for.
 *
 * @param stiffness [N/m], &gt;= 0
 * @param damping [N s/m], &gt;= 0
 * @param delay [s], &gt; 0
 * @param twitch time constant [s], &gt; 0
 * @param side which way of the two ends it answers
 */
public record MuscleReflex(@Key("reflex_N_per_m") double stiffness, @Key("reflex_Ns_per_m") double damping, @Key("delay_s") double delay,
        @Key("twitch_s") double twitch, @Key("side") Law.Side side) implements Law {
    public MuscleReflex {
        Check.notNegative("reflex stiffness", "N/m", stiffness);
        Check.notNegative("reflex damping", "N s/m", damping);
        Check.positive("delay", "s", delay);
        Check.positive("twitch", "s", twitch);
    }

    @Override
    public String mechanism() {
        return "muscle.reflex";
    }

    @Override
    public double force(LinkMotion m) {
        double q = remember(m);
        double told = stiffness * q + damping * (m.lateDisplacement - q) / twitch;
        return switch (side) {
            case EXTENSION -> Math.max(0, told);
            case COMPRESSION -> Math.min(0, told);
            case BOTH -> told;
        };
    }

    @Override
    public boolean isLinear() {
        return side == Side.BOTH;
    }

    @Override
    public void dynamicStiffness(double omega, double[] out) {
        if (!isLinear()) {
            Law.super.dynamicStiffness(omega, out);
        }
        // (k + jωc) e^(-jω delay) / (1 + jω twitch)
        double u = omega * twitch;
        double re = (stiffness + omega * damping * u) / (1 + u * u);
        double im = (omega * damping - stiffness * u) / (1 + u * u);
        double cos = Math.cos(omega * delay);
        double sin = Math.sin(omega * delay);
        out[0] = re * cos + im * sin;
        out[1] = im * cos - re * sin;
    }

    @Override
    public double lateness() {
        return delay;
    }

    @Override
    public boolean hasMemory() {
        return true;
    }

    @Override
    public double remember(LinkMotion m) {
        // q' = (r - q)/twitch, exact for a straight course of r over the step.
        double u = m.step / twitch;
        double decay = Math.exp(-u);
        double mean = -Math.expm1(-u) / u;
        double began = m.lateDisplacement - m.step * m.lateVelocity;
        return m.memory * decay + began * (mean - decay) + m.lateDisplacement * (1 - mean);
    }
}

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A spring and a dashpot in series beside the link. Memory is the arm's force [N].
 * Thesis: Eq. 2-44.
 *
 * @param arm stiffness of the arm's spring [N/m], &gt; 0
 * @param relaxation time in which a held force decays to 1/e [s], &gt; 0
 */
public record MaxwellArm(@Key("arm_stiffness_N_per_m") double arm, @Key("relaxation_s") double relaxation) implements Law {
    public MaxwellArm {
        Check.positive("arm stiffness", "N/m", arm);
        Check.positive("relaxation time", "s", relaxation);
    }

    @Override
    public String mechanism() {
        return "memory.viscoelastic";
    }

    @Override
    public double force(LinkMotion m) {
        return remember(m);
    }

    @Override
    public boolean isLinear() {
        return true;
    }

    @Override
    public void dynamicStiffness(double omega, double[] out) {
        double u = omega * relaxation;
        out[0] = arm * u * u / (1 + u * u);
        out[1] = arm * u / (1 + u * u);
    }

    @Override
    public boolean hasMemory() {
        return true;
    }

    @Override
    public double remember(LinkMotion m) {
        // f' = k v - f/τ, exact for the mean velocity of the step.
        double u = m.step / relaxation;
        double decay = Math.exp(-u);
        return m.memory * decay + arm * (m.displacement - m.before) * (-Math.expm1(-u) / u);
    }
}

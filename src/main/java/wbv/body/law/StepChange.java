package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * Stiffness and damping change at one moment.
 *
 * @param time when [s]
 * @param stiffnessFactor after over before, &gt; 0
 * @param dampingFactor likewise, &gt; 0
 */
public record StepChange(@Key("time_s") double time, @Key("stiffness_factor") double stiffnessFactor,
        @Key("damping_factor") double dampingFactor) implements Law {
    public StepChange {
        Check.finite("time", "s", time);
        Check.positive("stiffness factor", "1", stiffnessFactor);
        Check.positive("damping factor", "1", dampingFactor);
    }

    @Override
    public String mechanism() {
        return "drift.step";
    }

    @Override
    public double force(LinkMotion m) {
        // Within the step in which it happens the change counts in part, so that the force is continuous in its time.
        double share = Math.max(0, Math.min(1, (m.time - time) / m.step + 0.5));
        return changed(share, stiffnessFactor, dampingFactor, m);
    }

    /** @param share of the change that has happened [1] */
    private static double changed(double share, double stiffnessFactor, double dampingFactor, LinkMotion m) {
        return share * ((stiffnessFactor - 1) * m.stiffness * m.displacement + (dampingFactor - 1) * m.damping * m.velocity);
    }

    /**
     * The same in the course of some time, evenly.
     *
     * @param time when half of it is done [s]
     * @param stiffnessFactor after over before, &gt; 0
     * @param dampingFactor likewise, &gt; 0
     * @param duration how long it takes [s], &gt; 0
     */
    public record Gradual(@Key("time_s") double time, @Key("stiffness_factor") double stiffnessFactor,
            @Key("damping_factor") double dampingFactor, @Key("duration_s") double duration) implements Law {
        public Gradual {
            Check.finite("time", "s", time);
            Check.positive("stiffness factor", "1", stiffnessFactor);
            Check.positive("damping factor", "1", dampingFactor);
            Check.positive("duration", "s", duration);
        }

        @Override
        public String mechanism() {
            return "drift.step";
        }

        @Override
        public double force(LinkMotion m) {
            double share = Math.max(0, Math.min(1, (m.time - time) / duration + 0.5));
            return changed(share, stiffnessFactor, dampingFactor, m);
        }
    }
}

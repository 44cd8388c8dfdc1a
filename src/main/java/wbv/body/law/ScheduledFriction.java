package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Modulator;

/**
 * Dry friction F(u) tanh(v / v0) whose size goes by a measured channel, as the yield force of a damper goes by the voltage at its coil:
 * {@code F = F0 + a u + b u² + c u³ + d u⁴}, at least 0.
 *
 * @param by u, a {@link Modulator.Level}
 * @param middle F0 [N]
 * @param linear a [N]
 * @param square b [N]
 * @param cube c [N]
 * @param fourth d [N]
 * @param transition velocity v0 below which it is viscous [m/s], &gt; 0
 */
public record ScheduledFriction(@Key("modulator") Modulator by, @Key("middle_N") double middle, @Key("linear_N") double linear,
        @Key("square_N") double square,
        @Key("cube_N") double cube, @Key("fourth_N") double fourth, @Key("transition_m_per_s") double transition) implements Law {
    public ScheduledFriction {
        Modulator.Level.require(by);
        for (double force : new double[] {middle, linear, square, cube, fourth}) {
            Check.finite("friction", "N", force);
        }
        Check.positive("transition velocity", "m/s", transition);
    }

    @Override
    public String mechanism() {
        return "friction.scheduled";
    }

    @Override
    public Modulator modulator() {
        return by;
    }

    @Override
    public double force(LinkMotion m) {
        double u = m.modulation;
        return Math.max(0, middle + u * (linear + u * (square + u * (cube + u * fourth)))) * Math.tanh(m.velocity / transition);
    }
}

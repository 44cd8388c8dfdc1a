package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Modulator;

/**
 * A link whose stiffness or damping goes by a measured channel, the position of a roller, a coil's voltage, a temperature:
 * {@code 1 + a u + b u² + c u³ + d u⁴} times the link's own, which is what it is in the middle of the channel's range, and nowhere below 3
 * % of that.
 *
 * @param of what goes by the channel
 * @param by u, a {@link Modulator.Level}
 * @param linear a [1]
 * @param square b [1]
 * @param cube c [1]
 * @param fourth d [1]
 */
public record ScheduledLink(@Key("of") Of of, @Key("modulator") Modulator by, @Key("linear_change") double linear,
        @Key("square_change") double square,
        @Key("cube_change") double cube, @Key("fourth_change") double fourth) implements Law {
    private static final double FLOOR = -0.97;

    /** What goes by the channel. */
    public enum Of { STIFFNESS, DAMPING }

    public ScheduledLink {
        Modulator.Level.require(by);
        for (double change : new double[] {linear, square, cube, fourth}) {
            Check.finite("change", "1", change);
        }
    }

    @Override
    public String mechanism() {
        return of == Of.STIFFNESS ? "stiffness.scheduled" : "damping.scheduled";
    }

    @Override
    public Modulator modulator() {
        return by;
    }

    @Override
    public double force(LinkMotion m) {
        double u = m.modulation;
        double change = Math.max(FLOOR, u * (linear + u * (square + u * (cube + u * fourth))));
        return change * (of == Of.STIFFNESS ? m.stiffness * m.displacement : m.damping * m.velocity);
    }
}

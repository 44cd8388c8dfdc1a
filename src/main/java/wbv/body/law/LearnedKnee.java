package wbv.body.law;

import java.util.Locale;
import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.body.number.Units;

/**
 * A term of a law that was learned: it begins where the deflection or the speed goes beyond a knee, on one side or on both.
 *
 * @param of          {@code r} or {@code v}
 * @param side where it works
 * @param modulator   what it is multiplied by
 * @param coefficient slope beyond the knee [N/m or N s/m, per the modulator's unit]
 * @param knee        where it begins [m or m/s], &gt; 0
 */
public record LearnedKnee(@Key("beyond") Shape of, @Key("side") Side side, @Key("modulator") Modulator modulator,
        @Key("coefficient_N") double coefficient,
        @Key("knee") double knee) implements Learned {
    public LearnedKnee {
        if (!of.isLinear()) {
            throw new IllegalArgumentException("a knee is one of r or of v: '" + of + "'");
        }
        Check.finite("coefficient", "N", coefficient);
        Check.positive("knee", of.unit(), knee);
    }

    @Override
    public String unit() {
        return Units.newtonsPer(Units.product(of.unit(), modulator.unit()));
    }

    @Override
    public String kind() {
        return switch (side) {
            case BOTH -> "(|" + of + "| − knee)+ sign(" + of + ")";
            case EXTENSION -> "(" + of + " − knee)+";
            case COMPRESSION -> "−(−" + of + " − knee)+";
        };
    }

    @Override
    public String formula() {
        return kind().replace("knee", String.format(Locale.ROOT, "%.3g", 1e3 * knee) + (of.equals(Shape.SPEED) ? " mm/s" : " mm"));
    }

    @Override
    public double force(LinkMotion m) {
        double x = of.of(m.displacement, m.velocity);
        double beyond = x > knee && side != Side.COMPRESSION ? x - knee : x < -knee && side != Side.EXTENSION ? x + knee : 0;
        return coefficient * m.modulation * beyond;
    }
}

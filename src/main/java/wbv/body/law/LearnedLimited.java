package wbv.body.law;

import java.util.Locale;
import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.body.number.Units;

/**
 * A term of a law that was learned, with a modulator that works only so far: coefficient · shape · limit tanh(modulator/limit). Beyond what
 * was recorded it goes nowhere, where the modulator itself might turn a stiffness over.
 *
 * @param shape what it goes by
 * @param modulator what it is multiplied by
 * @param coefficient [N per the unit of both]
 * @param limit of the modulator, in its unit, &gt; 0
 */
public record LearnedLimited(@Key("shape") Shape shape, @Key("modulator") Modulator modulator, @Key("coefficient_N") double coefficient,
        @Key("limit") double limit) implements Learned {
    public LearnedLimited {
        Check.finite("coefficient", "N", coefficient);
        Check.positive("limit", modulator.unit(), limit);
    }

    @Override
    public String unit() {
        return Units.newtonsPer(Units.product(shape.unit(), modulator.unit()));
    }

    @Override
    public String kind() {
        return shape + " × limited";
    }

    @Override
    public String formula() {
        return shape + String.format(Locale.ROOT, " × up to %.3g %s of", limit, modulator.unit());
    }

    @Override
    public double force(LinkMotion m) {
        return coefficient * limit * Math.tanh(m.modulation / limit) * shape.of(m.displacement, m.velocity);
    }
}

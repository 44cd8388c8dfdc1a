package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.body.number.Units;

/**
 * A term of a law that was learned from a recording: coefficient · shape · modulator.
 *
 * @param shape what it goes by
 * @param modulator what it is multiplied by
 * @param coefficient [N per the unit of both]
 */
public record LearnedTerm(@Key("shape") Shape shape, @Key("modulator") Modulator modulator, @Key("coefficient_N") double coefficient)
        implements Learned {
    public LearnedTerm {
        Check.finite("coefficient", unit(shape, modulator), coefficient);
    }

    private static String unit(Shape shape, Modulator modulator) {
        return Units.newtonsPer(Units.product(shape.unit(), modulator.unit()));
    }

    @Override
    public String unit() {
        return unit(shape, modulator);
    }

    @Override
    public String kind() {
        return shape.toString();
    }

    @Override
    public double force(LinkMotion m) {
        return coefficient * m.modulation * shape.of(m.displacement, m.velocity);
    }
}

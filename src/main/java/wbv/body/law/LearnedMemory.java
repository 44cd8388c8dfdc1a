package wbv.body.law;

import java.util.Locale;
import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.body.number.Units;

/**
 * A term of a law that was learned, with a memory: y' = (of - y)/τ, and the force is coefficient · y · shape · modulator. Memory is y.
 *
 * @param of          what is remembered, of the motion
 * @param shape what the memory is multiplied by; {@link Shape#ONE} for nothing
 * @param modulator   what both are multiplied by
 * @param coefficient [N per the unit of all three]
 * @param memory τ [s], &gt; 0
 */
public record LearnedMemory(@Key("of") Shape of, @Key("shape") Shape shape, @Key("modulator") Modulator modulator,
        @Key("coefficient_N") double coefficient,
        @Key("memory_s") double memory) implements Learned {
    public LearnedMemory {
        Check.finite("coefficient", "N", coefficient);
        Check.positive("memory", "s", memory);
    }

    @Override
    public String unit() {
        return Units.newtonsPer(Units.product(Units.product(of.unit(), shape.unit()), modulator.unit()));
    }

    @Override
    public String kind() {
        return "memory(" + of + ")" + (shape.equals(Shape.ONE) ? "" : " " + shape);
    }

    @Override
    public String formula() {
        return kind().replace("memory(", String.format(Locale.ROOT, "memory of %.3g s(", memory));
    }

    @Override
    public double force(LinkMotion m) {
        return coefficient * m.modulation * remember(m) * shape.of(m.displacement, m.velocity);
    }

    @Override
    public boolean hasMemory() {
        return true;
    }

    @Override
    public double remember(LinkMotion m) {
        double decay = Math.exp(-m.step / memory);
        // Half-way through the step.
        return m.memory * decay + (1 - decay) * of.of((m.before + m.displacement) / 2, (m.displacement - m.before) / m.step);
    }
}

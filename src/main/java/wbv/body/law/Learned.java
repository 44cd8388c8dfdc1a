package wbv.body.law;

import java.util.Locale;
import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Shape;
import wbv.body.number.Units;

/** A term of a law that no library holds, learned from a recording. Several in one link add up to the law. */
public sealed interface Learned extends Law
        permits LearnedTerm, LearnedLimited, LearnedKnee, LearnedMemory, LearnedInertance, LearnedCourse, LearnedWave, LearnedTable,
        Learned.Thinning {

    /** The word that stands for all of them. */
    String MECHANISM = "learned";

    @Override
    default String mechanism() {
        return MECHANISM;
    }

    /** What multiplies the shape, in its own unit, {@link #unit}. */
    double coefficient();

    /** Unit of the coefficient. */
    String unit();

    /** What the coefficient multiplies but for the modulator, without numbers: {@code |v|v}. */
    String kind();

    /** The same with its numbers. */
    default String formula() {
        return kind();
    }

    /** Whether its numbers mean something by the clock alone. */
    default boolean byTheClock() {
        return false;
    }

    /**
     * Damping that speed thins (Cross 1965, for the viscosity of liquids): coefficient · v / (1 + |v/speed|ⁿ). Below n = 1 the force grows
     * ever more slowly, at 1 it comes to a limit, above it falls past a crest, as of eddy currents at n = 2.
     *
     * @param coefficient at rest [N s/m]
     * @param thinning n [1], &gt; 0
     * @param speed at which half of the damping is left [m/s], &gt; 0
     */
    record Thinning(@Key("coefficient_N") double coefficient, @Key("thinning") double thinning, @Key("speed_m_per_s") double speed)
            implements Learned {

        public Thinning {
            Check.finite("coefficient", "N s/m", coefficient);
            Check.positive("thinning", "1", thinning);
            Check.positive("speed", "m/s", speed);
        }

        @Override
        public String unit() {
            return Units.newtonsPer(Shape.SPEED.unit());
        }

        @Override
        public String kind() {
            return "v thinned";
        }

        @Override
        public String formula() {
            return String.format(Locale.ROOT, "v / (1 + |v / %.3g mm/s|^%.2g)", 1e3 * speed, thinning);
        }

        @Override
        public double force(LinkMotion m) {
            return coefficient * m.velocity / (1 + Math.pow(Math.abs(m.velocity) / speed, thinning));
        }
    }
}

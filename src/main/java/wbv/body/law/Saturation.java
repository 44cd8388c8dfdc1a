package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A spring that softens the farther it is bent: k r becomes k r (b + (1 - b) / (1 + |r/knee|ⁿ)^(1/n)) (Menegotto and Pinto 1973), with as
 * many of the three numbers as are known. The knee is the deflection at which what softens would carry all that it ever does if it stayed
 * as stiff as at rest.
 */
public sealed interface Saturation extends Law {

    @Override
    default String mechanism() {
        return "stiffness.softening";
    }

    /** {@code 1 / (1 + uⁿ)^(1/n) - 1}: the part of its force that a spring lacks [1]. */
    private static double lacking(double u, double n) {
        return Math.pow(1 + Math.pow(u, n), -1 / n) - 1;
    }

    /**
     * Over a bend of n = 2, and all of it: k r / sqrt(1 + (r/knee)²).
     *
     * @param knee [m], &gt; 0
     */
    record SaturatingSpring(@Key("knee_m") double knee) implements Saturation {
        public SaturatingSpring {
            Check.positive("knee", "m", knee);
        }

        @Override
        public double force(LinkMotion m) {
            double r = m.displacement;
            double u = r / knee;
            return m.stiffness * r * (1 / Math.sqrt(1 + u * u) - 1);
        }
    }

    /**
     * Sooner or later, and all of it.
     *
     * @param knee [m], &gt; 0
     * @param sharpness n, how narrow the bend is [1], &gt; 0
     */
    record GradualSaturation(@Key("knee_m") double knee, @Key("sharpness") double sharpness) implements Saturation {
        public GradualSaturation {
            Check.positive("knee", "m", knee);
            Check.positive("sharpness", "1", sharpness);
        }

        @Override
        public double force(LinkMotion m) {
            return m.stiffness * m.displacement * lacking(Math.abs(m.displacement) / knee, sharpness);
        }
    }

    /**
     * Sooner or later, and a part of it: foam keeps some of its stiffness, a spring that buckles less than none.
     *
     * @param knee [m], &gt; 0
     * @param sharpness n, how narrow the bend is [1], &gt; 0
     * @param kept b, stiffness far beyond the knee over that at rest [1], -1 to 1
     */
    record PartialSaturation(@Key("knee_m") double knee, @Key("sharpness") double sharpness, @Key("kept_share") double kept)
            implements Saturation {
        public PartialSaturation {
            Check.positive("knee", "m", knee);
            Check.positive("sharpness", "1", sharpness);
            Check.within("share of its stiffness that a spring keeps as it softens", "1", kept, -1, 1);
        }

        @Override
        public double force(LinkMotion m) {
            return (1 - kept) * m.stiffness * m.displacement * lacking(Math.abs(m.displacement) / knee, sharpness);
        }
    }
}

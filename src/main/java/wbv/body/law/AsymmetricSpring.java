package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * A spring stiffer or softer in compression: ratio k r where r &lt; 0.
 *
 * @param ratio share of k added in compression, &gt; -1
 */
public record AsymmetricSpring(@Key("compression_ratio") double ratio) implements Law {
    public AsymmetricSpring {
        Check.above("ratio of added compression stiffness", "1", ratio, -1);
    }

    @Override
    public String mechanism() {
        return "stiffness.asymmetric";
    }

    @Override
    public double force(LinkMotion m) {
        return m.displacement < 0 ? ratio * m.stiffness * m.displacement : 0;
    }
}

package wbv.body.law;

import wbv.body.number.Check;
import wbv.body.number.Key;

/**
 * The link can push but not pull more than its preload: contact is lost beyond.
 *
 * @param preload static force [N], &gt;= 0
 */
public record ContactLoss(@Key("preload_N") double preload) implements Law {
    public ContactLoss {
        Check.notNegative("preload", "N", preload);
    }

    @Override
    public String mechanism() {
        return "contact.loss";
    }

    @Override
    public double force(LinkMotion m) {
        return Math.min(0, preload - m.stiffness * m.displacement - m.damping * m.velocity);
    }
}

package wbv.body.law;

import java.util.Locale;
import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Shape;

/**
 * A term of a law that was learned as a table, where no formula carries it: forces at six deflections or speeds, three to either side of
 * none, where it is nothing; straight lines between them, and beyond the last as much as there.
 *
 * @param over {@code r} or {@code v}
 * @param step how far the six are apart [m or m/s], &gt; 0
 * @param third force three steps on the side of compression [N]
 * @param second two steps [N]
 * @param first one step [N]
 * @param next one step in extension [N]
 * @param further two steps [N]
 * @param furthest three steps [N]
 */
public record LearnedTable(@Key("over") Shape over, @Key("step") double step, @Key("at_minus_3_N") double third,
        @Key("at_minus_2_N") double second,
        @Key("at_minus_1_N") double first, @Key("at_1_N") double next, @Key("at_2_N") double further, @Key("at_3_N") double furthest)
        implements Learned {

    /** Steps to either side. */
    private static final int REACH = 3;

    public LearnedTable {
        if (!over.isLinear()) {
            throw new IllegalArgumentException("a table goes over r or over v: '" + over + "'");
        }
        Check.positive("step", over.unit(), step);
        for (double force : new double[] {third, second, first, next, further, furthest}) {
            Check.finite("force", "N", force);
        }
    }

    /** The greatest force of the table. */
    @Override
    public double coefficient() {
        return Math.max(Math.max(Math.max(Math.abs(third), Math.abs(second)), Math.max(Math.abs(first), Math.abs(next))),
                Math.max(Math.abs(further), Math.abs(furthest)));
    }

    @Override
    public String unit() {
        return "N";
    }

    @Override
    public String kind() {
        return "table over " + over;
    }

    @Override
    public String formula() {
        double most = Math.max(coefficient(), Double.MIN_NORMAL);
        StringBuilder out = new StringBuilder(kind()).append(" (");
        for (int at = -REACH; at <= REACH; at++) {
            out.append(at > -REACH ? ", " : "").append(String.format(Locale.ROOT, "%.2g", force(at) / most));
        }
        return out.append(String.format(Locale.ROOT, " from %.3g to %.3g ", -1e3 * REACH * step, 1e3 * REACH * step)).append("m")
                .append(over.unit()).append(")").toString();
    }

    @Override
    public double force(LinkMotion m) {
        double x = Math.max(-REACH, Math.min(REACH, over.of(m.displacement, m.velocity) / step));
        int below = Math.min(REACH - 1, (int) Math.floor(x));
        double share = x - below;
        return m.modulation * (force(below) * (1 - share) + force(below + 1) * share);
    }

    /** @param at which of them, 0 for none */
    private double force(int at) {
        return switch (at) {
            case -3 -> third;
            case -2 -> second;
            case -1 -> first;
            case 1 -> next;
            case 2 -> further;
            case 3 -> furthest;
            default -> 0;
        };
    }
}

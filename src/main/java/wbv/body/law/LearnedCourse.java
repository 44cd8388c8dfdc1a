package wbv.body.law;

import java.util.Locale;
import wbv.body.number.Check;
import wbv.body.number.Key;
import wbv.body.number.Shape;
import wbv.body.number.Units;

/**
 * A term of a law that was learned and comes, goes or changes once: coefficient · shape · course, where the course is 0 at the beginning of
 * the recording.
 *
 * @param shape what it goes by
 * @param course in time
 * @param coefficient [N per the shape's unit]
 * @param time of a step, or time constant [s], &gt; 0
 */
public record LearnedCourse(@Key("shape") Shape shape, @Key("course") Course course, @Key("coefficient_N") double coefficient,
        @Key("time_s") double time)
        implements Learned {

    /** How it comes: at once, or ever more slowly; or it grows all the time, by as much in every {@code time}. */
    public enum Course {
        STEP, SETTLING, GROWING
    }

    public LearnedCourse {
        Check.finite("coefficient", Units.newtonsPer(shape.unit()), coefficient);
        Check.positive("time", "s", time);
    }

    @Override
    public String unit() {
        return Units.newtonsPer(shape.unit());
    }

    @Override
    public String kind() {
        return shape + " × " + course.name().toLowerCase(Locale.ROOT);
    }

    @Override
    public String formula() {
        return shape + String.format(Locale.ROOT, switch (course) {
            case STEP -> " from %.4g s on";
            case SETTLING -> " × (1 − exp(−t/%.4g s))";
            case GROWING -> " × t/%.4g s";
        }, time);
    }

    @Override
    public boolean byTheClock() {
        return true;
    }

    @Override
    public double force(LinkMotion m) {
        double share = switch (course) {
            case STEP -> m.time >= time ? 1 : 0;
            case SETTLING -> -Math.expm1(-m.time / time);
            case GROWING -> m.time / time;
        };
        return coefficient * share * shape.of(m.displacement, m.velocity);
    }
}

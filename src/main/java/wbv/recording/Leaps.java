package wbv.recording;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;

/**
 * Where the time of a recording leaps ahead of its uniform clock, since it was laid together of pieces of a longer one.
 *
 * @param all in the order of their samples
 */
public record Leaps(List<Leap> all) implements Serializable {

    /** Of a recording in one piece. */
    public static final Leaps NONE = new Leaps(List.of());

    /**
     * One.
     *
     * @param sample the first after it
     * @param later  how much later than the clock says that sample, and those up to the next leap, were taken [s]
     */
    public record Leap(int sample, double later) implements Serializable {}

    public Leaps {
        all = List.copyOf(all);
        for (int i = 1; i < all.size(); i++) {
            if (!(all.get(i).sample() > all.get(i - 1).sample())) {
                throw new IllegalArgumentException("leaps must stand in the order of their samples: " + all);
            }
        }
    }

    /** How much later than the clock says a sample was taken [s]. */
    public double later(long sample) {
        double later = 0;
        for (int i = 0; i < all.size() && all.get(i).sample() <= sample; i++) {
            later = all.get(i).later();
        }
        return later;
    }

    /** The same at another rate: samples by a factor [1]. */
    Leaps slowed(double factor) {
        return new Leaps(all.stream().map(leap -> new Leap((int) Math.ceil(leap.sample() * factor), leap.later())).toList());
    }

    /** Those within a part from one sample to before another, whose own clock is right at its first. */
    Leaps within(int from, int to) {
        double before = later(from);
        List<Leap> out = new ArrayList<>();
        for (Leap leap : all) {
            if (leap.sample() > from && leap.sample() < to) {
                out.add(new Leap(leap.sample() - from, leap.later() - before));
            }
        }
        return new Leaps(out);
    }
}

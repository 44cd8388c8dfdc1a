package wbv.identify;

import java.util.List;

/**
 * The body of one or two modes that simulates an output from an input best, over a stretch of a recording: what a linear body in
 * the place of the sitter would have to be for this path. It is a property of the path and of the motion, not of the sitter
 * alone: of a sitter who softens with motion, or has many modes, another ride and another place show another body.
 *
 * <p>Deviations say where it would be found had the same ride gone on for ever. They count what the body does not explain.
 *
 * @param modes      slowest first; one or two
 * @param from       beginning of the stretch, from the first sample [s]
 * @param to         its end [s]
 * @param explained  share of the output's variance that the body simulates by itself [1], at most 1; below 0 it is worse than none
 * @param withOthers the same together with other motions of the base, where any were found to help
 * @param share      share that the body simulates of what those other motions leave [1]
 * @param others     indices of those motions
 */
public record EquivalentBody(List<Mode> modes, double from, double to, double explained, double withOthers, double share,
        List<Integer> others) {

    /** Least share that a body must simulate for its numbers to stand: with less, most of the motion is something else's. */
    public static final double LEAST_SHARE = 0.5;

    /**
     * One mode.
     *
     * @param frequency natural frequency [Hz]
     * @param frequencyDeviation half of the half width that holds it with 95 % [Hz]
     * @param damping   damping ratio [1]
     * @param dampingDeviation likewise [1]
     */
    public record Mode(double frequency, double frequencyDeviation, double damping, double dampingDeviation) {

        /** Whether it swings at all: at a damping ratio of 1 or more there is no natural frequency to be seen. */
        public boolean oscillates() {
            return damping < 1;
        }

        /** Whether both numbers are known to better than half of themselves. */
        public boolean determined() {
            return 2 * frequencyDeviation < frequency / 2 && 2 * dampingDeviation < damping / 2;
        }
    }

    public EquivalentBody {
        modes = List.copyOf(modes);
        others = List.copyOf(others);
        if (modes.isEmpty() || modes.size() > 2) {
            throw new IllegalArgumentException("an equivalent body has one or two modes: " + modes.size());
        }
    }

    /** Whether it simulates enough for its numbers to stand. */
    public boolean carries() {
        return share >= LEAST_SHARE;
    }
}

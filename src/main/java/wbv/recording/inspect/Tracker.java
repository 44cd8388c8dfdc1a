package wbv.recording.inspect;

/**
 * Numbers rows by their times: which sample of an even clock each row is. A slow phase-locked loop follows the clock, so that
 * neither drift nor times rounded more coarsely than the step are taken for gaps or duplicates.
 */
final class Tracker {

    /** The row repeats a time, or falls on a sample that is taken. */
    static final long REPEATED = 0;

    /** Samples that a hole is counted to, far more than any reader fills: so sums over holes stay within a long. */
    private static final long MOST_MISSING = 1L << 40;
    private static final double GAIN = 0.05;
    private static final double STEP_LIMIT = 0.02;

    private final Resolution resolution = new Resolution();
    private final double initialStep;
    private final double blur;
    private double step;
    private double phase;
    private double last = Double.NaN;
    private double rounding;
    private double residual;

    /** The tracker that a first look at the times suggests. */
    Tracker(Timing timing) {
        this.phase = timing.phase() - timing.step();
        this.step = timing.step();
        this.initialStep = timing.step();
        this.blur = timing.blur();
    }

    /**
     * Places a row; rows come in order of time.
     *
     * @return by how many samples it is after the row before: 1 for the next, more over a gap, {@link #REPEATED}
     */
    long place(double time) {
        rounding = error(resolution.of(time), initialStep);
        if (Double.isNaN(last)) {
            phase += step;
            last = time;
            residual = time - phase;
            return 1;
        }
        double tolerance = Math.max(rounding, blur) / 2 + step * (0.5 + 1e-6);
        double ahead = time - (phase + step);
        if (ahead < -tolerance) {
            return REPEATED;
        }
        // Of rows that share a rounded time the first is the earliest; how coarse times of a new magnitude are is not known at once.
        boolean shared = resolution.settled() && blur <= rounding;
        long missing = ahead <= tolerance ? 0 : shared ? (long) Math.ceil((ahead - tolerance) / step) : Math.round(ahead / step);
        missing = Math.min(missing, MOST_MISSING);
        residual = ahead - missing * step;
        phase += (1 + missing) * step;
        if (missing > 0 && Math.max(rounding, blur) < step / 10) {
            phase += residual;
        } else {
            follow();
        }
        last = time;
        return 1 + missing;
    }

    /** By how much times written to a resolution are off [s]: not at all where the step is a whole number of it. */
    static double error(double resolution, double step) {
        double steps = step / resolution;
        return steps > 0.5 && Math.abs(steps - Math.rint(steps)) < 1e-3 ? 0 : resolution;
    }

    private void follow() {
        double gain = GAIN / (1 + 2 * Math.max(rounding, blur) / step);
        phase += gain * residual;
        double next = step + gain * gain / 2 * residual;
        step = Math.max(initialStep * (1 - STEP_LIMIT), Math.min(initialStep * (1 + STEP_LIMIT), next));
    }

    /** By how much rounding may put the last time off [s]. */
    double rounding() {
        return rounding;
    }

    /** True once the rounding of times as great as the last one is known. */
    boolean settled() {
        return resolution.settled();
    }

    /** The coarsest that times are written up to now [s]. */
    double coarsest() {
        return resolution.coarsest();
    }

    /** How late the last row was against the clock followed [s]. */
    double residual() {
        return residual;
    }
}

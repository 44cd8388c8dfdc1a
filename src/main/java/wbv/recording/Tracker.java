package wbv.recording;

/**
 * Numbers rows by their times: which sample of an even clock each row is. A slow phase-locked loop follows the clock, so that
 * neither drift nor times rounded more coarsely than the step are taken for gaps or duplicates.
 */
final class Tracker {

    /** The row repeats a time, or falls on a sample that is taken. */
    static final long REPEATED = 0;
    /** The row's time lies before the last one's. */
    static final long BACKWARDS = -1;

    private static final double GAIN = 0.05;
    private static final double STEP_LIMIT = 0.02;

    private final Resolution resolution = new Resolution();
    private final double initialStep;
    private double step;
    private double phase;
    private double last = Double.NaN;
    private double rounding;
    private double residual;

    /** @param phase expected time of the first row [s] @param step expected time between samples [s] */
    Tracker(double phase, double step) {
        this.phase = phase - step;
        this.step = step;
        this.initialStep = step;
    }

    /** The tracker that a first look at the times suggests. */
    Tracker(Timing timing) {
        this(timing.phase(), timing.step());
    }

    /**
     * Places a row.
     *
     * @return by how many samples it is after the row before: 1 for the next, more over a gap, {@link #REPEATED} or {@link #BACKWARDS}
     */
    long place(double time) {
        rounding = resolution.of(time);
        if (Double.isNaN(last)) {
            phase += step;
            last = time;
            residual = time - phase;
            return 1;
        }
        if (time < last) {
            return BACKWARDS;
        }
        double tolerance = rounding / 2 + step * (0.5 + 1e-6);
        double ahead = time - (phase + step);
        if (ahead < -tolerance) {
            return REPEATED;
        }
        long missing = ahead > tolerance ? (long) Math.ceil((ahead - tolerance) / step) : 0;
        residual = ahead - missing * step;
        phase += (1 + missing) * step;
        if (missing > 0 && rounding < step / 10) {
            phase += residual;
        } else {
            follow();
        }
        last = time;
        return 1 + missing;
    }

    private void follow() {
        double gain = GAIN / (1 + 2 * rounding / step);
        phase += gain * residual;
        double next = step + gain * gain / 2 * residual;
        step = Math.max(initialStep * (1 - STEP_LIMIT), Math.min(initialStep * (1 + STEP_LIMIT), next));
    }

    /** How the times are rounded at the last row [s]. */
    double rounding() {
        return rounding;
    }

    /** The coarsest that times were rounded up to now [s]. */
    double coarsest() {
        return resolution.coarsest();
    }

    /** How late the last row was against the clock followed [s]. */
    double residual() {
        return residual;
    }
}

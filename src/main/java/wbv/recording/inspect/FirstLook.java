package wbv.recording.inspect;

import java.util.Arrays;
import java.util.OptionalDouble;

/**
 * Step, phase and jitter of a clock from the first few hundred times of a recording, whatever gaps, rounding and jitter they
 * have.
 */
final class FirstLook {

    /** Share by which a measured step may miss a stated one, or a whole number of it, and mean it. */
    private static final double NEAR = 0.03;
    private static final double FEW = 0.05;
    /** Median departure, in steps, beyond which counting differences one by one counts some twice. */
    private static final double MISFIT = 0.15;

    private final double[] times;
    private final double[] differences;
    private final double resolution;

    /** @param times increasing weakly, two or more, the last later than the first */
    FirstLook(double[] times) {
        this.times = times;
        this.differences = new double[times.length - 1];
        Resolution written = new Resolution();
        double last = 0;
        for (int i = 0; i < times.length; i++) {
            last = written.of(times[i]);
            if (i > 0) {
                differences[i - 1] = times[i] - times[i - 1];
            }
        }
        this.resolution = Math.max(written.coarsest(), last);
    }

    /**
     * What was seen.
     *
     * @param nominal rate that is stated [Hz]
     */
    Timing timing(OptionalDouble nominal) {
        double step = measured();
        if (nominal.isPresent()) {
            double mean = (times[times.length - 1] - times[0]) / differences.length * nominal.getAsDouble();
            double ratio = step * nominal.getAsDouble();
            double near = Tracker.error(resolution, step) > step / 10 ? 4 * NEAR : NEAR;
            boolean meant = Math.abs(mean - 1) < NEAR || ratio < 10
                    && Math.abs(ratio - Math.rint(ratio)) < near * Math.rint(ratio);
            step = meant ? 1 / nominal.getAsDouble() : step;
        }
        double phase = line(step).intercept(step);
        return new Timing(Math.abs(phase - times[0]) < Math.max(step, resolution) ? phase : times[0], step, blur(step), 0, 0,
                false);
    }

    /** The step by counting differences in it; by wide spans where they jitter so much that counting would be biased. */
    private double measured() {
        double step = line(typical()).slope();
        if (still(step) > FEW * differences.length) {
            return step;
        }
        for (int i = 0; i < 3; i++) {
            step = line(step).slope();
        }
        double misfit = departure(step);
        return misfit <= Math.max(Tracker.error(resolution, step), MISFIT * step) || times.length < 32 ? step : wide();
    }

    /** The median difference, or a shorter one that is frequent and goes into it: then most rows come after a loss. */
    private double typical() {
        double[] sorted = Arrays.stream(differences).filter(difference -> difference > 0).sorted().toArray();
        double median = sorted[(sorted.length - 1) / 2];
        double low = sorted[sorted.length / 20];
        long frequent = Arrays.stream(sorted).filter(difference -> Math.abs(difference - low) <= 0.02 * low + resolution).count();
        double ratio = median / low;
        boolean lossy = low > 4 * resolution && frequent >= Math.max(2, sorted.length / 10) && ratio > 1.5
                && Math.abs(ratio - Math.rint(ratio)) < NEAR;
        return lossy ? low : median;
    }

    /** Times over samples, counted difference by difference. */
    private Line line(double step) {
        double error = Tracker.error(resolution, step);
        boolean duplicates = still(step) <= FEW * differences.length && error < step / 10;
        Line line = new Line();
        line.accept(0, times[0]);
        long sample = 0;
        for (int i = 0; i < differences.length; i++) {
            boolean repeated = duplicates && differences[i] < step / 4;
            sample += repeated ? 0 : Math.max(1, Math.round((differences[i] - error) / step));
            if (!repeated) {
                line.accept(sample, times[i + 1]);
            }
        }
        return line;
    }

    /** Rows that hardly differ in time from the one before. */
    private long still(double step) {
        return Arrays.stream(differences).filter(difference -> difference < step / 4).count();
    }

    /** The median over spans of sixteen, refined over spans that double. */
    private double wide() {
        int span = Math.min(16, differences.length / 2);
        double[] spans = new double[times.length - span];
        for (int i = 0; i < spans.length; i++) {
            spans[i] = (times[i + span] - times[i]) / span;
        }
        Arrays.sort(spans);
        double step = spans[(spans.length - 1) / 2];
        for (int length = 2 * span; length < 2 * times.length; length *= 2) {
            Line line = new Line();
            for (int i = 0; i < Math.min(length, times.length); i++) {
                line.accept(Math.rint((times[i] - times[0]) / step), times[i]);
            }
            step = line.slope();
        }
        return step;
    }

    /** Median departure of a difference from a whole number of steps, one at least [s]. */
    private double departure(double step) {
        double[] departures = Arrays.stream(differences)
                .map(difference -> Math.abs(difference - step * Math.max(1, Math.rint(difference / step)))).sorted().toArray();
        return departures[departures.length / 2];
    }

    /**
     * From the earliest to the latest that a single time is off, were the jitter normal: eight standard deviations. 0 where
     * rounding explains the departures.
     */
    private double blur(double step) {
        double median = departure(step);
        boolean real = median > Math.max(Tracker.error(resolution, step), 0.02 * step) && differences.length > 16;
        return real ? 8 * 1.4826 / Math.sqrt(2) * median : 0;
    }
}

package wbv.recording;

import java.util.Arrays;
import java.util.OptionalDouble;

/** Step and phase of a clock from the first few hundred times of a recording, whatever gaps, rounding and jitter they have. */
final class FirstLook {

    private static final double NEAR = 0.03;

    private FirstLook() { }

    /** Step between samples [s]. @param times increasing weakly, two or more @param nominal rate that is stated [Hz] */
    static double step(double[] times, OptionalDouble nominal) {
        double step = measured(times);
        if (nominal.isPresent()) {
            double ratio = step * nominal.getAsDouble();
            if (Math.abs(ratio - Math.rint(ratio)) < NEAR * Math.rint(ratio) && ratio < 10) {
                return 1 / nominal.getAsDouble();
            }
        }
        return step;
    }

    private static double measured(double[] times) {
        int span = Math.max(1, Math.min(16, (times.length - 1) / 4));
        double[] wide = new double[times.length - span];
        for (int i = 0; i < wide.length; i++) {
            wide[i] = (times[i + span] - times[i]) / span;
        }
        Arrays.sort(wide);
        double median = wide[(wide.length - 1) / 2];
        double[] steps = new double[times.length - 1];
        for (int i = 0; i < steps.length; i++) {
            steps[i] = times[i + 1] - times[i];
        }
        Arrays.sort(steps);
        double low = steps[steps.length / 20];
        double sum = 0;
        int cluster = 0;
        for (double each : steps) {
            if (Math.abs(each - low) <= 0.02 * low) {
                sum += each;
                cluster++;
            }
        }
        boolean lossy = low > 0 && cluster >= steps.length / 10 && cluster >= 2 && median > 1.2 * low;
        return lossy ? sum / cluster : median > 0 ? median : (times[times.length - 1] - times[0]) / (times.length - 1);
    }

    /**
     * From the earliest to the latest that a single time is off, were the jitter normal: eight standard deviations, by the median
     * departure of a difference from a whole number of steps. 0 where rounding explains it.
     */
    static double blur(double[] times, double step) {
        Resolution resolution = new Resolution();
        double[] departures = new double[times.length - 1];
        resolution.of(times[0]);
        for (int i = 0; i < departures.length; i++) {
            resolution.of(times[i + 1]);
            double steps = (times[i + 1] - times[i]) / step;
            departures[i] = Math.abs(steps - Math.max(1, Math.rint(steps))) * step;
        }
        Arrays.sort(departures);
        double median = departures[departures.length / 2];
        boolean real = median > Math.max(Tracker.error(resolution.coarsest(), step), 0.02 * step) && departures.length > 16;
        return real ? 8 * 1.4826 / Math.sqrt(2) * median : 0;
    }

    /** Time of the first sample [s]: by the median over the first rows, so that neither rounding nor a gap weighs much. */
    static double phase(double[] times, double step) {
        double[] departures = new double[Math.min(33, times.length)];
        for (int i = 0; i < departures.length; i++) {
            departures[i] = times[i] - times[0] - i * step;
        }
        Arrays.sort(departures);
        double median = departures[departures.length / 2];
        return times[0] + (Math.abs(median) < step / 2 ? median : 0);
    }
}

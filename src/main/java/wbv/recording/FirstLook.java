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
        double median = wide[wide.length / 2];
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

    /** Time of the first sample [s]: the mean over the first rows without a gap, so that rounding weighs little. */
    static double phase(double[] times, double step) {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < Math.min(16, times.length); i++) {
            double departure = times[i] - times[0] - i * step;
            if (Math.abs(departure) > 1.5 * step) {
                break;
            }
            sum += departure;
            count++;
        }
        double mean = sum / count;
        return times[0] + (Math.abs(mean) < step / 2 ? mean : 0);
    }
}

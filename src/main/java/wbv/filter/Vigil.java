package wbv.filter;

import java.io.Serializable;

/**
 * Watches whether innovations are what the filter expects. The {@link Alarm} hears the probability of each ν²/S under a right
 * model, uniform in [0, 1]; it listens only after they have been consistent for a while. Beside it, Page's test (Biometrika
 * 1954) hears a change that is large or plain within less time than a window needs: it sums the log likelihood ratio of
 * innovations with {@value #LARGER} times the variance over those expected. {@link StepTest} hears what noise hides from both.
 */
final class Vigil implements Serializable {

    private static final long serialVersionUID = 1;
    private static final double SETTLING = 5;
    private static final double MEMORY = 3;
    private static final double LONG_MEMORY = 10;
    /** Innovations are consistent if the mean of ν²/S is about one, or less but steady: the sensor is better than was said. */
    private static final double LEAST_CONSISTENT = 0.75;
    private static final double STEADY = 0.25;
    private static final double MOST_CONSISTENT = 1.5;
    /** A mean ν²/S that no adapting noise could leave. */
    private static final double HOPELESS = 30;
    private static final double MOST_COUNTED = 100;
    private static final double LONGEST_USELESS = 5;
    private static final double LARGER = 4;
    /** ν²/S counts as this at most, so that no single shock is a change. */
    private static final double MOST_IN_SUM = 9;
    /** Page's sum at which the body has changed, for each second's worth of samples. */
    private static final double LARGEST_SUM = 0.4;

    /** What an innovation means. */
    enum Verdict {
        /** Nothing yet, the alarm does not listen. */
        UNSETTLED,
        /** All as expected. */
        QUIET,
        /** The innovations have become smaller than expected. */
        CALMER,
        /** The innovations have become larger: the body has changed. */
        CHANGED,
        /** The model has nothing to do with the output. */
        LOST
    }

    private final double rate;
    private final Alarm alarm;
    private final StepTest step = new StepTest();
    private double mean;
    private double longMean;
    private double untilSettled;
    private double useless;
    private double sum;
    private boolean settled;

    Vigil(double rate, Alarm alarm) {
        this.rate = rate;
        this.alarm = alarm;
        restart();
    }

    void restart() {
        mean = 1;
        longMean = 1;
        useless = 0;
        unsettle();
    }

    private void unsettle() {
        untilSettled = SETTLING;
        settled = false;
        sum = 0;
        step.restart();
        alarm.reset();
    }

    boolean settled() {
        return settled;
    }

    long width() {
        return alarm.width();
    }

    /**
     * Hears a sample that tells about the parameters.
     *
     * @param nis             ν²/S
     * @param normalised      ν/√S, S as large as correlated innovations make it
     * @param slope           how much the output depends on ln ω, over the same √S
     * @param explainsNothing whether ν is as large as the output
     */
    Verdict hear(double nis, double normalised, double slope, boolean explainsNothing) {
        mean += (Math.min(nis, MOST_COUNTED) - mean) / (MEMORY * rate);
        useless = explainsNothing ? useless + 1 / rate : 0;
        if (mean > HOPELESS || useless > LONGEST_USELESS) {
            return Verdict.LOST;
        }
        longMean += (mean - longMean) / (LONG_MEMORY * rate);
        boolean steady = Math.abs(mean - longMean) < STEADY * longMean;
        boolean consistent = mean < MOST_CONSISTENT && (mean > LEAST_CONSISTENT || steady);
        untilSettled = consistent ? untilSettled - 1 / rate : SETTLING;
        settled |= untilSettled <= 0;
        if (!settled) {
            return Verdict.UNSETTLED;
        }
        double before = alarm.mean();
        double probability = Probability.chiSquare1(nis);
        double ratio = 0.5 * (Math.min(nis, MOST_IN_SUM) * (1 - 1 / LARGER) - Math.log(LARGER));
        sum = Math.max(0, sum + ratio);
        boolean cut = alarm.feed(probability);
        boolean leapt = step.hear(normalised, slope) | sum > LARGEST_SUM * rate;
        if (!cut && !leapt) {
            return Verdict.QUIET;
        }
        boolean rose = leapt || alarm.mean() > before;
        unsettle();
        return rose ? Verdict.CHANGED : Verdict.CALMER;
    }
}

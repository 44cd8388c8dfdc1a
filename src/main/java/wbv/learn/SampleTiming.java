package wbv.learn;

import java.io.Serializable;

/**
 * What the times of instances say about sampling: the rate, from the first two, and how many samples are missing before an
 * instance.
 */
final class SampleTiming implements Serializable {

    private static final long serialVersionUID = 1;

    private final double assumedRate;
    private double rate;
    private double last = Double.NaN;
    private long count;

    /** @param assumedRate where there are no times [Hz] */
    SampleTiming(double assumedRate) {
        this.assumedRate = assumedRate;
        this.rate = assumedRate;
    }

    double rate() {
        return rate;
    }

    /**
     * Takes the time of the next instance.
     *
     * @param time [s]; NaN where there is none
     * @return true if the rate is not what it was assumed to be, which only the second instance can show
     */
    boolean learnsRate(double time) {
        count++;
        if (count != 2 || !(time > last)) {
            return false;
        }
        rate = 1 / (time - last);
        return Math.abs(rate / assumedRate - 1) > 1e-9;
    }

    /** Samples that lie between the last instance and this one, 0 where there are no times. Call once for each instance. */
    long missingBefore(double time) {
        double steps = (time - last) * rate;
        last = time;
        return steps > 1.5 ? Math.round(steps) - 1 : 0;
    }
}

package wbv.recording.inspect;

/** How many samples a channel has and lacks, their mean, scatter and range (Welford 1962). */
final class Distribution {

    private long count;
    private long missing;
    private double mean;
    private double squares;
    private double min = Double.POSITIVE_INFINITY;
    private double max = Double.NEGATIVE_INFINITY;

    void missed() {
        missing++;
    }

    void accept(double x) {
        count++;
        double d = x - mean;
        mean += d / count;
        squares += d * (x - mean);
        min = x <= min ? x : min;
        max = x >= max ? x : max;
    }

    /** Samples that are there. */
    long count() {
        return count;
    }

    long rows() {
        return count + missing;
    }

    Summary summary() {
        return count == 0 ? new Summary(0, missing, Double.NaN, Double.NaN, Double.NaN, Double.NaN)
                : new Summary(count, missing, mean, Math.sqrt(squares / count), min, max);
    }
}

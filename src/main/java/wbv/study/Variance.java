package wbv.study;

/** Mean and variance of numbers one after another (Welford 1962). */
final class Variance {

    private long count;
    private double mean;
    private double sum;

    void add(double value) {
        count++;
        double before = value - mean;
        mean += before / count;
        sum += before * (value - mean);
    }

    /** NaN if there was no number. */
    double value() {
        return count == 0 ? Double.NaN : sum / count;
    }
}

package wbv.recording.inspect;

/** The straight line through points that come one by one, by least squares (updated means and moments, Welford 1962). */
final class Line {

    private long count;
    private double meanX;
    private double meanY;
    private double sxx;
    private double sxy;

    void accept(double x, double y) {
        count++;
        double dx = x - meanX;
        meanX += dx / count;
        meanY += (y - meanY) / count;
        sxx += dx * (x - meanX);
        sxy += dx * (y - meanY);
    }

    /** NaN with fewer than two different x. */
    double slope() {
        return sxx > 0 ? sxy / sxx : Double.NaN;
    }

    /** Where a line of this slope through the points' mean is at x = 0. */
    double intercept(double slope) {
        return meanY - slope * meanX;
    }
}

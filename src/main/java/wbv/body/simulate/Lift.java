package wbv.body.simulate;

import java.util.Arrays;

/**
 * How far the lower ends of links are lifted beside the motion of the bodies, which a link is the shorter by: what laws see of it, and
 * what they do to a free run. It begins from nothing.
 *
 * @param height      [m], by link and sample; empty where nothing lifts
 * @param rate        of that [m/s], likewise
 * @param heightSlope derivative of the height [m per the parameter's unit], by parameter, link and sample; empty where there is none
 * @param rateSlope   derivative of the rate, likewise. None copied
 */
record Lift(double[][] height, double[][] rate, double[][][] heightSlope, double[][][] rateSlope) {

    /** Nothing is lifted. */
    static Lift none(int links, int parameters) {
        return new Lift(new double[links][0], new double[links][0], new double[parameters][links][0], new double[parameters][links][0]);
    }

    /** One of as many samples, to be filled. */
    Lift ofLength(int samples) {
        return new Lift(like(height, samples), like(rate, samples),
                Arrays.stream(heightSlope).map(each -> like(each, samples)).toArray(double[][][]::new),
                Arrays.stream(rateSlope).map(each -> like(each, samples)).toArray(double[][][]::new));
    }

    private static double[][] like(double[][] series, int samples) {
        return Arrays.stream(series).map(each -> new double[each.length == 0 ? 0 : samples]).toArray(double[][]::new);
    }

    /** Height of a link at a sample [m]. */
    double height(int link, int j) {
        return at(height[link], j);
    }

    /** Rate of a link at a sample [m/s]. */
    double rate(int link, int j) {
        return at(rate[link], j);
    }

    static double at(double[] series, int j) {
        return series.length == 0 ? 0 : series[j];
    }
}

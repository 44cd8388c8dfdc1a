package wbv.pole;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import wbv.identify.Pole;

/**
 * Comparable coordinates of the s-plane: decay and pulsation, each less its median and over its spread, so that a distance means
 * the same in both directions. The spread is the median distance from the median times 1.4826, a standard deviation where values
 * are normal (Hampel 1974).
 *
 * @param centreRe [rad/s]
 * @param spreadRe [rad/s], &gt; 0
 * @param centreIm [rad/s]
 * @param spreadIm [rad/s], &gt; 0
 */
public record PolePlane(double centreRe, double spreadRe, double centreIm, double spreadIm) implements Serializable {

    private static final double NORMAL = 1.4826;
    /** Least spread as a share of the centre: values that agree to the last digit have none of their own. */
    private static final double LEAST = 1e-3;

    public PolePlane {
        if (!(spreadRe > 0 && spreadIm > 0)) {
            throw new IllegalArgumentException("spreads must be > 0 rad/s: " + spreadRe + ", " + spreadIm);
        }
    }

    /** Fitted to poles, at least one. */
    public static PolePlane of(List<Pole> poles) {
        double[] re = poles.stream().mapToDouble(Pole::re).toArray();
        double[] im = poles.stream().mapToDouble(Pole::im).toArray();
        return new PolePlane(median(re), spread(re), median(im), spread(im));
    }

    /** Coordinates of a pole, two long [spreads]. */
    public double[] coordinates(Pole pole) {
        return new double[] {(pole.re() - centreRe) / spreadRe, (pole.im() - centreIm) / spreadIm};
    }

    /** Coordinates of poles [spreads], by pole, two long each. */
    public double[][] coordinates(List<Pole> poles) {
        return poles.stream().map(this::coordinates).toArray(double[][]::new);
    }

    static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int n = sorted.length;
        return n % 2 == 1 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
    }

    static double spread(double[] values) {
        double median = median(values);
        double spread = NORMAL * median(Arrays.stream(values).map(value -> Math.abs(value - median)).toArray());
        return Math.max(spread, Math.max(LEAST * Math.abs(median), Double.MIN_NORMAL));
    }
}

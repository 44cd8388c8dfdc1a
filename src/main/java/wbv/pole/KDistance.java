package wbv.pole;

import java.util.Arrays;

/**
 * How far every point is from its k-th neighbour, itself counted, in rising order (Ester et al. 1996), and the epsilon that its
 * knee suggests: the point furthest below the line from the first to the last, both axes scaled to one (Satopää et al. 2011).
 *
 * @param k        neighbours, the point itself counted
 * @param distance by point, in the unit of their coordinates, rising. Not copied: read-only.
 * @param knee     index of the knee
 */
public record KDistance(int k, double[] distance, int knee) {

    /**
     * The curve of some points.
     *
     * @param points by row, at least k, all coordinates of one unit. Not modified.
     */
    public static KDistance of(double[][] points, int k) {
        double[] curve = core(points, k);
        Arrays.sort(curve);
        int knee = curve.length - 1;
        double furthest = 0;
        double rise = curve[curve.length - 1] - curve[0];
        for (int i = 0; i < curve.length && rise > 0; i++) {
            double below = i / (curve.length - 1.0) - (curve[i] - curve[0]) / rise;
            if (below > furthest) {
                furthest = below;
                knee = i;
            }
        }
        return new KDistance(k, curve, knee);
    }

    /** Distance of every point, in the order of points, to its k-th neighbour: infinite where there are fewer. */
    static double[] core(double[][] points, int k) {
        double[] core = new double[points.length];
        double[] all = new double[points.length];
        for (int i = 0; i < points.length; i++) {
            for (int j = 0; j < points.length; j++) {
                double sum = 0;
                for (int d = 0; d < points[i].length; d++) {
                    sum += (points[i][d] - points[j][d]) * (points[i][d] - points[j][d]);
                }
                all[j] = sum;
            }
            Arrays.sort(all);
            core[i] = k <= all.length ? Math.sqrt(all[k - 1]) : Double.POSITIVE_INFINITY;
        }
        return core;
    }

    /** The distance at the knee, in the unit of the points' coordinates. */
    public double epsilon() {
        return distance[knee];
    }
}

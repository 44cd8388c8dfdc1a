package wbv.diagnosis.measured;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import wbv.body.simulate.Stroke;

/**
 * How much the force of a driven link differs where its stroke repeats itself: chatter, stick-slip, what changes from cycle to
 * cycle. No law of the stroke can explain that, and a sensor's own noise is far below it.
 *
 * <p>Half the mean square difference between nearest neighbours (Rice 1984), as it would be at no distance, in a space of position,
 * velocity and stop operators of several widths (Prandtl 1928), which stand for what the link remembers. Only the closest quarter of the
 * neighbours counts: the others have not really come back.
 */
public final class Repeatable {

    private static final int MOST = 3000;
    private static final double CLOSEST = 0.25;
    private static final double[] WIDTHS = {0.5, 0.2, 0.08, 0.03};
    private static final double POSITION = 0.3;

    private Repeatable() {}

    /**
     * Standard deviation of what does not repeat [N]; 0 where the record is too short to tell.
     *
     * @param force measured, by sample [N]. Not modified.
     * @param valid samples that count. Not modified.
     * @param to end of what is looked at
     */
    public static double rest(Stroke stroke, double[] force, boolean[] valid, int to) {
        double[][] state = states(stroke, to);
        int step = Math.max(1, to / MOST);
        int apart = apart(stroke.velocity(), to);
        List<Integer> looked = new ArrayList<>();
        for (int j = 0; j < to; j += step) {
            if (valid[j]) {
                looked.add(j);
            }
        }
        List<double[]> pairs = new ArrayList<>();
        for (int j : looked) {
            double nearest = Double.POSITIVE_INFINITY;
            int with = -1;
            for (int i : looked) {
                if (Math.abs(i - j) > apart) {
                    double distance = distance(state[i], state[j], nearest);
                    if (distance < nearest) {
                        nearest = distance;
                        with = i;
                    }
                }
            }
            if (with >= 0) {
                pairs.add(new double[] {nearest, (force[j] - force[with]) * (force[j] - force[with])});
            }
        }
        pairs.sort(Comparator.comparingDouble(pair -> pair[0]));
        return Math.sqrt(atNone(pairs.subList(0, (int) (CLOSEST * pairs.size()))));
    }

    /**
     * Half the mean square difference that is left where neighbours come together: the distance between them makes the rest of it, which
     * for a force without steps goes with the square of that (the nugget of a variogram: Matheron, Economic Geology 1963).
     *
     * @param pairs squared distance and squared difference of each. Not modified.
     */
    private static double atNone(List<double[]> pairs) {
        SimpleRegression line = new SimpleRegression();
        pairs.forEach(pair -> line.addData(pair[0], pair[1] / 2));
        double mean = pairs.stream().mapToDouble(pair -> pair[1] / 2).average().orElse(0);
        return line.getSlope() > 0 ? Math.max(0, line.getIntercept()) : mean;
    }

    private static double[][] states(Stroke stroke, int to) {
        double[] x = stroke.position();
        double[] v = stroke.velocity();
        double range = 2 * largest(x, to);
        double speed = largest(v, to);
        double[] stop = new double[WIDTHS.length];
        double[][] out = new double[to][2 + WIDTHS.length];
        for (int j = 0; j < to; j++) {
            out[j][0] = POSITION * x[j] / range;
            out[j][1] = v[j] / speed;
            for (int i = 0; i < stop.length; i++) {
                double moved = j == 0 ? 0 : (x[j] - x[j - 1]) / (WIDTHS[i] * range);
                stop[i] = Math.max(-1, Math.min(1, stop[i] + moved));
                out[j][2 + i] = stop[i];
            }
        }
        return out;
    }

    /** Half the mean time between reversals, in samples: closer in time two states are the same visit. */
    private static int apart(double[] v, int to) {
        int reversals = 1;
        for (int j = 1; j < to; j++) {
            reversals += v[j] * v[j - 1] < 0 ? 1 : 0;
        }
        return to / reversals / 2;
    }

    private static double distance(double[] a, double[] b, double beyond) {
        double sum = 0;
        for (int i = 0; i < a.length && sum < beyond; i++) {
            sum += (a[i] - b[i]) * (a[i] - b[i]);
        }
        return sum;
    }

    private static double largest(double[] x, int to) {
        return Math.max(1e-12, Arrays.stream(x, 0, to).map(Math::abs).max().orElse(0));
    }
}

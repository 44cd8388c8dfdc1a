package wbv.network;

import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The linear body that explains a window best, from a start that is known to some deviation or to none.
 *
 * <p>Modes are found by Levenberg and Marquardt's method; whatever else is free is linear and fitted anew at every step
 * (Golub and Pereyra 1973; {@link FrequencyModel}). What is known beforehand counts as much as its deviation says beside what the
 * window leaves unexplained: the mode of the posterior, and its curvature as deviation. Not for several threads.
 */
final class FrequencyFit {

    /** Lines are weighted anew by what the first pass found. */
    private static final int PASSES = 2;
    private static final int MOST_STEPS = 12;
    private static final double SMALL_STEP = 1e-4;
    private static final double LONGEST_STEP = 0.7;
    private static final double DIFFERENCE = 1e-5;
    private static final double TAU = 2 * Math.PI;
    /** Bounds of logarithms of damping ratios and pulsations: 0.003 to 3, 0.3 to 50 Hz. */
    private static final double[] LOW = {Math.log(0.003), Math.log(TAU * 0.3)};
    private static final double[] HIGH = {Math.log(3), Math.log(TAU * 50)};

    private final int n;
    private final FrequencyModel model;
    private final DMatrixRMaj curvature;
    private final double[] downhill;

    /**
     * What was found.
     *
     * @param value     damping ratio and natural pulsation [rad/s] of each mode, slowest first
     * @param deviation standard deviation of each, if what is left unexplained is noise
     * @param left      the noise that both sensors would need to have for what is left unexplained where there is shaking [m/s²]
     * @param coloured  the same over that where there is none: 1 if noise explains what is left
     * @param moved     how far it went from the start: root mean square over targets, in the deviations known beforehand
     */
    record Found(double[] value, double[] deviation, double left, double coloured, double moved) {}

    /**
     * Of a body that its excitation alone moves.
     *
     * @param modes of the body, 1 or more
     */
    FrequencyFit(int modes) {
        this(modes, 0);
    }

    /**
     * @param modes of the body, 1 or more
     * @param others motions of the base that move it as well
     */
    FrequencyFit(int modes, int others) {
        n = 2 * modes;
        model = new FrequencyModel(modes, others);
        curvature = new DMatrixRMaj(n, n);
        downhill = new double[n];
    }

    /**
     * Fits.
     *
     * @param motion excitation, answer and the others, as a network reads them; what follows is not looked at. Not modified.
     * @param start  where to begin, and what is known of it; a deviation that is no number says that nothing is
     */
    Found from(double[][] motion, Estimate start) {
        double[] prior = new double[n];
        double[] precision = new double[n];
        for (int j = 0; j < n; j++) {
            prior[j] = bounded(j, Math.log(Math.max(Double.MIN_NORMAL, start.value()[j])));
            double relative = start.deviation()[j] / Math.exp(prior[j]);
            precision[j] = relative > 0 ? 1 / (relative * relative) : 0;
        }
        model.look(motion);
        double[] at = prior.clone();
        for (int pass = 0; pass < PASSES; pass++) {
            model.weigh(at);
            at = descended(at, prior, precision);
        }
        double squares = model.explain(at);
        describe(at, prior, precision, noise(squares));
        model.explain(at);
        return found(at, Math.sqrt(surprise(at, prior, precision) / n));
    }

    private double[] descended(double[] from, double[] prior, double[] precision) {
        double[] at = from;
        double squares = model.explain(at);
        double damping = 1e-3;
        for (int step = 0; step < MOST_STEPS; step++) {
            double noise = noise(squares);
            describe(at, prior, precision, noise);
            double cost = squares / noise + surprise(at, prior, precision);
            double longest = 0;
            while (longest == 0 && damping < 1e6) {
                double[] next = stepped(at, damping);
                double found = model.explain(next);
                if (found / noise + surprise(next, prior, precision) < cost) {
                    for (int j = 0; j < n; j++) {
                        longest = Math.max(longest, Math.abs(next[j] - at[j]));
                    }
                    at = next;
                    squares = found;
                    damping = Math.max(1e-9, damping / 10);
                } else {
                    damping *= 10;
                }
            }
            if (longest < SMALL_STEP) {
                break;
            }
        }
        return at;
    }

    /** Variance of what is left, weighted. */
    private double noise(double squares) {
        return Math.max(Double.MIN_NORMAL, squares / (model.equations() - n));
    }

    private Found found(double[] at, double moved) {
        DMatrixRMaj covariance = new DMatrixRMaj(n, n);
        boolean known = CommonOps_DDRM.invert(curvature, covariance);
        int[] order = IntStream.range(0, n / 2).boxed().sorted(Comparator.comparingDouble(m -> at[2 * m + 1]))
                .mapToInt(m -> m).toArray();
        double[] value = new double[n];
        double[] deviation = new double[n];
        for (int j = 0; j < n; j++) {
            int from = 2 * order[j / 2] + j % 2;
            double variance = known ? covariance.get(from, from) : Double.NaN;
            value[j] = Math.exp(at[from]);
            deviation[j] = value[j] * Math.sqrt(variance >= 0 ? variance : Double.POSITIVE_INFINITY);
        }
        double left = model.leftWhereShaken();
        double quiet = model.leftWhereQuiet();
        return new Found(value, deviation, left, quiet > 0 ? left / quiet : 1, moved);
    }

    /** Curvature and descent of half the cost, by Gauss and Newton. */
    private void describe(double[] at, double[] prior, double[] precision, double noise) {
        model.explain(at);
        double[] here = model.rest().clone();
        double[][] slope = new double[n][here.length];
        Arrays.fill(downhill, 0);
        for (int j = 0; j < n; j++) {
            double[] beside = at.clone();
            beside[j] += DIFFERENCE;
            model.explain(beside);
            double[] there = model.rest();
            for (int i = 0; i < here.length; i++) {
                slope[j][i] = (there[i] - here[i]) / DIFFERENCE;
                downhill[j] -= slope[j][i] * here[i] / noise;
            }
        }
        for (int a = 0; a < n; a++) {
            for (int b = 0; b <= a; b++) {
                double sum = 0;
                for (int i = 0; i < here.length; i++) {
                    sum += slope[a][i] * slope[b][i];
                }
                curvature.set(a, b, sum / noise);
                curvature.set(b, a, sum / noise);
            }
            double ratio = Math.exp(at[a] - prior[a]);
            curvature.add(a, a, precision[a] * ratio * ratio);
            downhill[a] -= precision[a] * (ratio - 1) * ratio;
        }
    }

    private double[] stepped(double[] at, double damping) {
        DMatrixRMaj damped = curvature.copy();
        for (int j = 0; j < n; j++) {
            damped.add(j, j, damping * curvature.get(j, j) + Double.MIN_NORMAL);
        }
        DMatrixRMaj step = new DMatrixRMaj(n, 1);
        boolean solved = CommonOps_DDRM.solve(damped, DMatrixRMaj.wrap(n, 1, downhill.clone()), step);
        double[] next = at.clone();
        for (int j = 0; j < n && solved; j++) {
            next[j] = bounded(j, at[j] + Math.max(-LONGEST_STEP, Math.min(LONGEST_STEP, step.data[j])));
        }
        return next;
    }

    /** Squares of how far the values, not their logarithms, are from what was known, in deviations. */
    private static double surprise(double[] at, double[] prior, double[] precision) {
        double sum = 0;
        for (int j = 0; j < at.length; j++) {
            double away = Math.exp(at[j] - prior[j]) - 1;
            sum += precision[j] * away * away;
        }
        return sum;
    }

    private static double bounded(int target, double logarithm) {
        return Math.max(LOW[target % 2], Math.min(HIGH[target % 2], logarithm));
    }
}

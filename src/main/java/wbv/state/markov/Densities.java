package wbv.state.markov;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.state.mixture.CovarianceShape;
import wbv.state.mixture.Gaussian;
import wbv.state.mixture.Mixture;

/**
 * The densities of a chain's states, each asked for once a row however many states have it: states of one jolt differ in what they
 * are called, not in what they look like. Three dimensions with whole covariances, which motion states have, lie in flat arrays
 * by component, for which the processor takes several at once. Every number is that of {@link Gaussian#logDensity}.
 */
final class Densities implements Serializable {

    private static final long serialVersionUID = 2;
    private static final int FLAT = 3;
    /** Logarithm of the least number above 0, and a little: the exponential of anything below is 0. */
    static final double NOTHING = -746;
    /** Logarithm of what 1 and a sum of it with thousands of the like are the same number. */
    private static final double LOST = -46;

    private final Gaussian[] components;
    private final double[][] logWeights;
    /** Components of each mixture of several. */
    private final int[][] parts;
    /** Where a state's density is found: a component's, or behind them a mixture's. */
    private final int[] source;
    /** Of component m: means, rows of L⁻¹ and scale, one behind the other by what they are. Empty where nothing is flat. */
    private final double[] flat;

    Densities(HiddenMarkov model) {
        Map<List<Object>, Integer> known = new LinkedHashMap<>();
        Map<List<Object>, Integer> mixtures = new LinkedHashMap<>();
        List<Gaussian> all = new ArrayList<>();
        List<double[]> weights = new ArrayList<>();
        List<int[]> places = new ArrayList<>();
        int[] mixtureOf = new int[model.states()];
        source = new int[mixtureOf.length];
        for (int k = 0; k < source.length; k++) {
            Mixture mixture = model.emissions().get(k);
            int[] own = new int[mixture.size()];
            for (int m = 0; m < own.length; m++) {
                Gaussian each = mixture.components().get(m);
                own[m] = known.computeIfAbsent(key(each), none -> {
                    all.add(each);
                    return all.size() - 1;
                });
            }
            if (own.length == 1) {
                source[k] = own[0];
                mixtureOf[k] = -1;
                continue;
            }
            List<Object> same = List.of(Arrays.stream(own).boxed().toList(), Arrays.stream(mixture.weights()).boxed().toList());
            mixtureOf[k] = mixtures.computeIfAbsent(same, none -> {
                weights.add(Arrays.stream(mixture.weights()).map(Math::log).toArray());
                places.add(own);
                return places.size() - 1;
            });
        }
        components = all.toArray(Gaussian[]::new);
        for (int k = 0; k < source.length; k++) {
            source[k] = mixtureOf[k] < 0 ? source[k] : components.length + mixtureOf[k];
        }
        logWeights = weights.toArray(double[][]::new);
        parts = places.toArray(int[][]::new);
        boolean whole = all.stream().allMatch(each -> each.dimensions() == FLAT && each.shape() == CovarianceShape.FULL);
        flat = whole ? flat() : new double[0];
    }

    private static List<Object> key(Gaussian each) {
        return List.of(each.shape(), Arrays.stream(each.mean()).boxed().toList(), Arrays.stream(each.covariance()).boxed().toList());
    }

    private double[] flat() {
        int count = components.length;
        double[] all = new double[10 * count];
        for (int m = 0; m < count; m++) {
            double[] numbers = components[m].numbers();
            for (int i = 0; i < numbers.length; i++) {
                all[i * count + m] = numbers[i];
            }
        }
        return all;
    }

    /**
     * ln p(row) for every state.
     *
     * @param row length d, complete. Not modified.
     * @param work at least {@link #work} long. Modified.
     * @param logs K long. Modified.
     */
    void of(double[] row, double[] work, double[] logs) {
        int count = components.length;
        if (flat.length > 0) {
            flat(row, work);
        } else {
            for (int m = 0; m < count; m++) {
                work[m] = components[m].logDensity(row, work, count + parts.length);
            }
        }
        for (int i = 0; i < parts.length; i++) {
            work[count + i] = mixed(parts[i], logWeights[i], work);
        }
        for (int k = 0; k < source.length; k++) {
            logs[k] = work[source[k]];
        }
    }

    /**
     * Numbers that {@link #of} needs room for.
     *
     * @param d dimensions of a row
     */
    int work(int d) {
        return components.length + parts.length + d;
    }

    private void flat(double[] row, double[] into) {
        int n = components.length;
        double x = row[0];
        double y = row[1];
        double z = row[2];
        double[] g = flat;
        for (int m = 0; m < n; m++) {
            double dx = x - g[m];
            double dy = y - g[n + m];
            double dz = z - g[2 * n + m];
            double a = g[3 * n + m] * dx;
            double b = g[4 * n + m] * dx + g[5 * n + m] * dy;
            double c = g[6 * n + m] * dx + g[8 * n + m] * dz + g[7 * n + m] * dy;
            into[m] = g[9 * n + m] - 0.5 * (a * a + b * b + c * c);
        }
    }

    /** The logarithm of a sum that may be too small for a number. */
    private static double mixed(int[] own, double[] logWeight, double[] logs) {
        double most = Double.NEGATIVE_INFINITY;
        for (int m = 0; m < own.length; m++) {
            most = Math.max(most, logWeight[m] + logs[own[m]]);
        }
        double sum = 0;
        for (int m = 0; m < own.length; m++) {
            double value = logWeight[m] + logs[own[m]] - most;
            sum += value >= LOST ? Math.exp(value) : 0;
        }
        return most + Math.log(sum);
    }
}

package wbv.signal;

import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.analysis.solvers.BrentSolver;
import org.apache.commons.math3.special.Beta;
import org.apache.commons.math3.special.Erf;
import org.apache.commons.math3.util.ResizableDoubleArray;

/**
 * How an estimated coherence scatters about the true one.
 *
 * <p>From n independent averages of Gaussian segments and m inputs, the estimate is a mixture of Beta(m + j, n - m) with the
 * negative binomial weights {@code C(n+j-1, j) γ^{2j} (1-γ²)^n}, j = 0, 1, … With one input this is the distribution of Carter,
 * Knapp and Nuttall (IEEE Trans. Audio Electroacoust. 21, 1973, 337), with several that of Goodman's multiple coherence (Ann. Math.
 * Stat. 34, 1963, 152). Where nothing is related it is Beta(m, n - m): m/n on average, which is the estimate's bias.
 *
 * @param averages number of independent averages n, more than the inputs; not necessarily whole
 * @param inputs   number of inputs m, at least 1
 */
public record CoherenceDistribution(double averages, int inputs) {

    /** Weight of the mixture that may be left out. */
    private static final double NEGLIGIBLE = 1e-10;
    private static final double CLOSE = 1e-9;
    /** Looks at most: halving alone needs 30 to come so close. */
    private static final int LOOKS = 200;
    /**
     * Averages from which on Fisher's z = artanh γ is normal enough: mean bias 1/(2n - 2) for each input, variance 1/(2n - 2)
     * (Enochson and Goodman, AFFDL TR-65-57, 1965); the mixture has as many terms as averages.
     */
    static final double MANY = 500;

    public CoherenceDistribution {
        if (inputs < 1) {
            throw new IllegalArgumentException("a coherence needs at least 1 input: " + inputs);
        }
        if (!(averages > inputs) || Double.isInfinite(averages)) {
            throw new IllegalArgumentException("independent averages must be more than the " + inputs + " inputs: " + averages);
        }
    }

    /** Coherence that chance alone gives on average where nothing is related: m/n. */
    public double byChance() {
        return inputs / averages;
    }

    /**
     * The chance that an estimate is at most a value.
     *
     * @param estimate estimated coherence, 0 to 1
     * @param truth    true coherence γ², 0 to less than 1
     */
    public double cumulative(double estimate, double truth) {
        requireShare("estimate", estimate, 1);
        return of(truth).applyAsDouble(estimate);
    }

    /**
     * The estimate that is not exceeded with a given chance.
     *
     * @param chance probability, more than 0, less than 1
     * @param truth  true coherence γ², 0 to less than 1
     */
    public double quantile(double chance, double truth) {
        if (!(chance > 0 && chance < 1)) {
            throw new IllegalArgumentException("chance must be between 0 and 1: " + chance);
        }
        DoubleUnaryOperator cumulative = of(truth);
        return new BrentSolver(CLOSE).solve(LOOKS, x -> cumulative.applyAsDouble(x) - chance, 0, 1);
    }

    /** The chance that an estimate is at most a value, of one true coherence. */
    private DoubleUnaryOperator of(double truth) {
        requireShare("true coherence", truth, Math.nextDown(1.0));
        DoubleUnaryOperator within = truth > 0 && averages > MANY ? estimate -> normal(estimate, truth) : mixture(truth);
        return estimate -> estimate == 0 || estimate == 1 ? estimate : within.applyAsDouble(estimate);
    }

    private double normal(double estimate, double truth) {
        double z = atanh(Math.sqrt(estimate)) - atanh(Math.sqrt(truth)) - inputs / (2 * averages - 2);
        return 0.5 * Erf.erfc(-z * Math.sqrt(averages - 1));
    }

    private DoubleUnaryOperator mixture(double truth) {
        double[] weights = weights(truth);
        double b = averages - inputs;
        return x -> {
            // Upwards the weights, downwards the distributions: I_x(a, b) = I_x(a+1, b) + x^a (1-x)^b / (a B(a, b)), all positive.
            double a = inputs + weights.length - 1.0;
            double beta = Beta.regularizedBeta(x, a, b);
            double step = a * Math.log(x) + b * Math.log1p(-x) - Math.log(a) - Beta.logBeta(a, b);
            double sum = weights[weights.length - 1] * beta;
            for (int j = weights.length - 2; j >= 0; j--) {
                step += Math.log(a / (x * (a - 1 + b)));
                a--;
                beta += Math.exp(step);
                sum += weights[j] * beta;
            }
            return Math.min(1, sum);
        };
    }

    private static double atanh(double x) {
        return 0.5 * (Math.log1p(x) - Math.log1p(-x));
    }

    /** The negative binomial weights, until what is left of them is negligible. */
    private double[] weights(double truth) {
        if (truth == 0) {
            return new double[] {1};
        }
        ResizableDoubleArray out = new ResizableDoubleArray();
        double mode = averages * truth / (1 - truth);
        double log = averages * Math.log1p(-truth);
        double weight = Math.exp(log);
        double left = 1;
        for (int j = 0; left > NEGLIGIBLE && (j < mode || weight > NEGLIGIBLE * (1 - truth)); j++) {
            out.addElement(weight);
            left -= weight;
            log += Math.log(truth * (averages + j) / (j + 1));
            weight = Math.exp(log);
        }
        return out.getElements();
    }

    private static void requireShare(String what, double value, double most) {
        if (!(value >= 0 && value <= most)) {
            throw new IllegalArgumentException(what + " must be 0 to 1: " + value);
        }
    }
}

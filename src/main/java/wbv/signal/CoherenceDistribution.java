package wbv.signal;

import org.apache.commons.math3.special.Beta;
import org.apache.commons.math3.special.Erf;
import org.apache.commons.math3.special.Gamma;

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
        requireShare("true coherence", truth, Math.nextDown(1.0));
        if (estimate == 0 || estimate == 1) {
            return estimate;
        }
        if (truth > 0 && averages > MANY) {
            double z = atanh(Math.sqrt(estimate)) - atanh(Math.sqrt(truth)) - inputs / (2 * averages - 2);
            return 0.5 * Erf.erfc(-z * Math.sqrt(averages - 1));
        }
        // Upwards the weights, downwards the distributions: I_x(a, b) = I_x(a+1, b) + x^a (1-x)^b / (a B(a, b)), all positive.
        int last = truth == 0 ? 0 : lastTerm(truth);
        double b = averages - inputs;
        double beta = Beta.regularizedBeta(estimate, inputs + last, b);
        double sum = 0;
        for (int j = last; j >= 0; j--) {
            sum += weight(j, truth) * beta;
            if (j > 0) {
                double a = inputs + j - 1;
                beta += Math.exp(a * Math.log(estimate) + b * Math.log1p(-estimate) - Math.log(a) - Beta.logBeta(a, b));
            }
        }
        return Math.min(1, sum);
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
        double low = 0;
        double high = 1;
        while (high - low > CLOSE) {
            double middle = (low + high) / 2;
            if (cumulative(middle, truth) < chance) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return (low + high) / 2;
    }

    private static double atanh(double x) {
        return 0.5 * (Math.log1p(x) - Math.log1p(-x));
    }

    /** The negative binomial weight of term j. */
    private double weight(int j, double truth) {
        return truth == 0 ? 1 : Math.exp(Gamma.logGamma(averages + j) - Gamma.logGamma(averages) - Gamma.logGamma(j + 1.0)
                + j * Math.log(truth) + averages * Math.log1p(-truth));
    }

    private int lastTerm(double truth) {
        int j = 0;
        double left = 1;
        double mode = averages * truth / (1 - truth);
        while (left > NEGLIGIBLE && (j < mode || weight(j, truth) > NEGLIGIBLE * (1 - truth))) {
            left -= weight(j, truth);
            j++;
        }
        return j;
    }

    private static void requireShare(String what, double value, double most) {
        if (!(value >= 0 && value <= most)) {
            throw new IllegalArgumentException(what + " must be 0 to 1: " + value);
        }
    }
}

package wbv.state.markov;

/**
 * What a hidden Markov model says of one sequence: its likelihood, the probability of every state at every row given all rows
 * (scaled forward-backward, L. R. Rabiner, Proc. IEEE 77 (1989) 257-286, section V.A), and the likeliest path (Viterbi).
 *
 * <p>A row with a missing value says nothing of the state, so it is bridged by the transitions.
 */
public final class Trellis {

    private final HiddenMarkov model;
    private final int k;
    private final int length;
    /** Densities of rows in states, each row over its greatest. */
    private final double[][] density;
    private final double[][] forward;
    private final double[][] posterior;
    private final double[] scale;
    private final boolean[] missing;
    private final double logLikelihood;

    /**
     * Goes over a sequence forwards and backwards.
     *
     * @param rows T by d, each column in its own unit, T &gt;= 1. Not modified.
     */
    public Trellis(HiddenMarkov model, double[][] rows) {
        this(model, rows, new double[0][]);
    }

    /**
     * With what else is known of the states at every row.
     *
     * @param rows T by d, each column in its own unit, T &gt;= 1. Not modified.
     * @param evidence T by K, logarithms that are added to those of the densities, or none. Not modified.
     */
    public Trellis(HiddenMarkov model, double[][] rows, double[][] evidence) {
        this.model = model;
        this.k = model.states();
        this.length = rows.length;
        if (length == 0) {
            throw new IllegalArgumentException("a sequence needs at least one row");
        }
        density = new double[length][k];
        forward = new double[length][k];
        posterior = new double[length][k];
        scale = new double[length];
        missing = new boolean[length];
        double offset = evaluate(rows, evidence);
        double sum = offset;
        for (int t = 0; t < length; t++) {
            forward(t);
            sum += Math.log(scale[t]);
        }
        logLikelihood = sum;
        backward();
    }

    private double evaluate(double[][] rows, double[][] evidence) {
        double[] logs = new double[model.mostComponents()];
        double[] scratch = new double[model.dimensions()];
        double offset = 0;
        for (int t = 0; t < length; t++) {
            missing[t] = !Rows.complete(rows[t]);
            double greatest = Double.NEGATIVE_INFINITY;
            for (int j = 0; j < k; j++) {
                density[t][j] = missing[t] ? 0 : model.emissions().get(j).logDensity(rows[t], logs, scratch)
                        + (evidence.length == 0 ? 0 : evidence[t][j]);
                greatest = Math.max(greatest, density[t][j]);
            }
            missing[t] |= greatest == Double.NEGATIVE_INFINITY; // too far from everything for a double
            for (int j = 0; j < k; j++) {
                density[t][j] = missing[t] ? 1 : Math.exp(density[t][j] - greatest);
            }
            offset += missing[t] ? 0 : greatest;
        }
        return offset;
    }

    /** α_t(j) = b_j(x_t) Σ_i α_{t-1}(i) A_ij / c_t. */
    private void forward(int t) {
        double[] now = forward[t];
        if (t == 0) {
            System.arraycopy(model.initial(), 0, now, 0, k);
        } else {
            double[] before = forward[t - 1];
            for (int i = 0; i < k; i++) {
                double[] row = model.transition()[i];
                for (int j = 0; j < k; j++) {
                    now[j] += before[i] * row[j];
                }
            }
        }
        double sum = 0;
        for (int j = 0; j < k; j++) {
            now[j] *= density[t][j];
            sum += now[j];
        }
        if (!(sum > 0)) {
            // No state that can be reached has any density here: the row says nothing.
            for (int j = 0; j < k; j++) {
                density[t][j] = 1;
                now[j] = 0;
            }
            missing[t] = true;
            forward(t);
            scale[t] = Math.max(Double.MIN_NORMAL, scale[t]) * Double.MIN_NORMAL;
            return;
        }
        scale[t] = sum;
        for (int j = 0; j < k; j++) {
            now[j] /= sum;
        }
    }

    /** γ_t = α_t β_t; β in the posterior's place until it is used up. */
    private void backward() {
        double[] beta = new double[k];
        double[] next = new double[k];
        java.util.Arrays.fill(beta, 1);
        System.arraycopy(forward[length - 1], 0, posterior[length - 1], 0, k);
        for (int t = length - 2; t >= 0; t--) {
            double sum = 0;
            for (int i = 0; i < k; i++) {
                next[i] = 0;
                double[] row = model.transition()[i];
                for (int j = 0; j < k; j++) {
                    next[i] += row[j] * density[t + 1][j] * beta[j];
                }
                sum += next[i];
            }
            double whole = 0;
            for (int i = 0; i < k; i++) {
                beta[i] = next[i] / sum;
                posterior[t][i] = forward[t][i] * beta[i];
                whole += posterior[t][i];
            }
            for (int i = 0; i < k; i++) {
                posterior[t][i] /= whole;
            }
        }
    }

    /** ln p of the sequence [nat]. */
    public double logLikelihood() {
        return logLikelihood;
    }

    /** γ_t(j), probability P(state j at row t | all rows), T by K. Not a copy. */
    public double[][] posterior() {
        return posterior;
    }

    /** Probability P(state j at row t | rows up to t), T by K. Not a copy. */
    public double[][] filtered() {
        return forward;
    }

    /** Whether a row said something of its state. */
    boolean told(int t) {
        return !missing[t];
    }

    /**
     * Adds the expected number of transitions.
     * Thesis: Eq. 7-6.
     *
     * @param counts K by K. Modified.
     */
    void addTransitions(double[][] counts) {
        double[] beta = new double[k];
        double[] ahead = new double[k];
        for (int t = 1; t < length; t++) {
            // β_t up to a factor is γ_t / α_t, so ξ_t(i, j) ∝ α_{t-1}(i) A_ij b_j(x_t) γ_t(j) / α_t(j).
            double whole = 0;
            for (int j = 0; j < k; j++) {
                beta[j] = forward[t][j] > 0 ? posterior[t][j] / forward[t][j] : 0;
                ahead[j] = density[t][j] * beta[j];
            }
            for (int i = 0; i < k; i++) {
                double from = forward[t - 1][i];
                double[] row = model.transition()[i];
                for (int j = 0; j < k; j++) {
                    whole += from * row[j] * ahead[j];
                }
            }
            for (int i = 0; i < k && whole > 0; i++) {
                double from = forward[t - 1][i] / whole;
                double[] row = model.transition()[i];
                for (int j = 0; j < k; j++) {
                    counts[i][j] += from * row[j] * ahead[j];
                }
            }
        }
    }

    /** The likeliest path of states (A. J. Viterbi, IEEE Trans. Inf. Theory 13 (1967) 260-269). */
    public int[] path() {
        double[][] logs = new double[k][k];
        for (int i = 0; i < k; i++) {
            for (int j = 0; j < k; j++) {
                logs[i][j] = Math.log(model.transition()[i][j]);
            }
        }
        int[][] from = new int[length][k];
        double[] best = new double[k];
        double[] next = new double[k];
        for (int j = 0; j < k; j++) {
            best[j] = Math.log(model.initial()[j]) + Math.log(density[0][j]);
        }
        for (int t = 1; t < length; t++) {
            for (int j = 0; j < k; j++) {
                int chosen = 0;
                for (int i = 1; i < k; i++) {
                    chosen = best[i] + logs[i][j] > best[chosen] + logs[chosen][j] ? i : chosen;
                }
                from[t][j] = chosen;
                next[j] = best[chosen] + logs[chosen][j] + Math.log(density[t][j]);
            }
            double[] swap = best;
            best = next;
            next = swap;
        }
        int[] path = new int[length];
        for (int j = 1; j < k; j++) {
            path[length - 1] = best[j] > best[path[length - 1]] ? j : path[length - 1];
        }
        for (int t = length - 1; t > 0; t--) {
            path[t - 1] = from[t][path[t]];
        }
        return path;
    }
}

package wbv.filter;

import java.io.Serializable;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.distribution.TDistribution;
import wbv.filter.model.Spec;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * How far an estimate really scatters, whatever its filter believes. A filter takes what its model leaves for white noise; what a
 * real body does beside one mode follows itself for seconds and knows the input, so that corrections add up where the filter
 * counts on their cancelling.
 *
 * <p>Over a batch of some seconds the move D of a parameter and the factor C by which the filter forgets its error are known:
 * {@code θ ← C θ + (1 - C) z}, where z is what the batch alone says. So an estimate is the mean {@code θ = Σ w z} of what all batches said
 * and of what was known before, with weights that sum to one, and its variance is the sum of what leaving out one batch would move it:
 * {@code V = Σ (w (z - θ) / (1 - w))²}, the jackknife (Tukey 1958; for least squares MacKinnon and White, Journal of Econometrics 29, 1985,
 * HC3), by batches, so that noise may follow itself within each. What was learned early is no scatter where all batches agree on it. Since
 * few batches tell V but roughly, it is raised by the square of Student's quantile over the normal one, for as many degrees of freedom as
 * their weights leave: {@code (Σ w)²/Σ w² - 1}. Where there is no room for one more, the two neighbours of least weight become one.
 */
final class ObservedScatter implements Serializable, Snapshot {

    private static final long serialVersionUID = 2;
    /** Square of Student's quantile of 97.5 % over the normal one, by degrees of freedom; the last for all above. */
    private static final double[] STUDENT = student(100);
    /** Version of saved states from which on they hold batches; before it they held means of moves. */
    private static final int WITH_BATCHES = 4;
    /** That which held one number more than those before. */
    private static final int WITH_MORE = 3;

    private final int length;
    /** Of each batch, earliest first: its weight w, and w (z - θ). */
    private final double[] weight;
    private final double[] pull;
    private int batches;
    /** Variance of what was known before, and of what may have drifted unseen, as it still counts. */
    private double known;
    private double told;
    private double sum;
    private double left;
    private int samples;
    private double own;

    /** @param spec rate and adaptation */
    ObservedScatter(Spec spec) {
        this.length = (int) Math.max(1, Math.round(spec.adaptation().scatter().batch() * spec.rate()));
        this.weight = new double[(int) spec.adaptation().scatter().batches()];
        this.pull = new double[weight.length];
    }

    private static double[] student(int most) {
        double normal = new NormalDistribution(null, 0, 1).inverseCumulativeProbability(0.975);
        double[] factors = new double[most + 1];
        for (int k = 1; k <= most; k++) {
            double t = new TDistribution(null, k).inverseCumulativeProbability(0.975);
            factors[k] = t * t / (normal * normal);
        }
        return factors;
    }

    /** The parameter is known this well, and nothing of how it scatters. */
    void restart(double variance) {
        known = variance;
        own = variance;
        told = 0;
        batches = 0;
        begin();
    }

    private void begin() {
        sum = 0;
        left = 1;
        samples = 0;
    }

    /**
     * Hears a sample that could tell about the parameter.
     *
     * @param move of the parameter since the last sample
     * @param before the filter's variance of it before the correction
     * @param after and after it
     */
    void hear(double move, double before, double after) {
        if (!(before > 0) || !Double.isFinite(move)) {
            return;
        }
        own = after;
        sum += move;
        left *= after / before;
        samples++;
        if (samples < length) {
            return;
        }
        take(Math.min(1, left));
        begin();
    }

    /** @param kept C of the batch that ends */
    private void take(double kept) {
        if (batches == weight.length) {
            merge();
        }
        for (int b = 0; b < batches; b++) {
            pull[b] = kept * (pull[b] - weight[b] * sum);
            weight[b] *= kept;
        }
        weight[batches] = 1 - kept;
        pull[batches] = kept * sum;
        batches++;
        known *= kept * kept;
        told = scatter();
    }

    private void merge() {
        int least = 0;
        for (int b = 1; b + 1 < batches; b++) {
            least = weight[b] + weight[b + 1] < weight[least] + weight[least + 1] ? b : least;
        }
        weight[least] += weight[least + 1];
        pull[least] += pull[least + 1];
        batches--;
        System.arraycopy(weight, least + 2, weight, least + 1, batches - least - 1);
        System.arraycopy(pull, least + 2, pull, least + 1, batches - least - 1);
    }

    private double scatter() {
        double all = 0;
        double squares = 0;
        double variance = 0;
        for (int b = 0; b < batches; b++) {
            all += weight[b];
            squares += weight[b] * weight[b];
            double moved = pull[b] / Math.max(1 - weight[b], Double.MIN_NORMAL);
            variance += moved * moved;
        }
        int free = squares > 0 ? (int) Math.round(all * all / squares) - 1 : 0;
        return variance * STUDENT[Math.max(1, Math.min(free, STUDENT.length - 1))];
    }

    /**
     * Nothing was learned: what the parameter may have drifted adds to what is unknown of it.
     *
     * @param now the filter's variance
     */
    void miss(double now) {
        known += Math.max(0, now - own);
        own = now;
    }

    /**
     * Variance of the parameter.
     *
     * @param filters the filter's own, which counts if it is more
     */
    double variance(double filters) {
        return Math.max(filters, known + told);
    }

    @Override
    public void save(StateWriter out) {
        out.put(batches);
        for (int b = 0; b < batches; b++) {
            out.put(weight[b]);
            out.put(pull[b]);
        }
        out.put(known);
        out.put(told);
        out.put(sum);
        out.put(left);
        out.put(samples);
        out.put(own);
    }

    @Override
    public void load(StateReader in) {
        boolean whole = in.version() >= WITH_BATCHES;
        batches = whole ? in.integer(0, weight.length, "batches") : 0;
        for (int b = 0; b < batches; b++) {
            weight[b] = in.number();
            pull[b] = in.number();
        }
        known = in.number();
        told = whole || in.version() == WITH_MORE ? in.number() : 0;
        sum = in.number();
        left = in.number();
        samples = in.integer();
        if (!whole) { // how it scatters is found anew
            told = 0;
            in.number();
            in.number();
        }
        own = in.number();
    }
}

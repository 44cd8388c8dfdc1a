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
 * <p>Over a batch of some seconds the move D of a parameter and the factor C by which the filter forgets its error are known. The
 * error goes as {@code e ← C e + D'}, so that a filter that is right has {@code P' = C² P + W}, W what the noise of the batch moved, and
 * {@code E[D²] = (1 - C)² P + W}. That D² is λ times that, in the mean of the last batches, says that noise moves the estimate by λ W:
 * of the filter's variance the part A that is left of what was not known at first counts once, the rest λ times. What the filter expected
 * to learn is no scatter, so that the seconds in which a body is found count as any other. λ is one at least, and raised by the square of
 * Student's quantile over the normal one, since it is the mean of few (batch means; the recursive form of White's sandwich, Econometrica
 * 50, 1982).
 */
final class ObservedScatter implements Serializable, Snapshot {

    private static final long serialVersionUID = 2;
    /** Square of Student's quantile of 97.5 % over the normal one, by degrees of freedom; the last for all above. */
    private static final double[] STUDENT = student(100);
    /** Version of saved states from which on they hold λ; before it was the mean of D². */
    private static final int WITH_RATIO = 3;

    private final int length;
    private final double memory;
    /** A. */
    private double prior;
    private double begun;
    private double sum;
    private double left;
    private int samples;
    private double ratio;
    private double batches;
    private double own;

    /** @param spec rate and adaptation */
    ObservedScatter(Spec spec) {
        this.length = (int) Math.max(1, Math.round(spec.adaptation().scatter().batch() * spec.rate()));
        this.memory = spec.adaptation().scatter().batches();
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
    void restart(double known) {
        prior = known;
        own = known;
        ratio = 0;
        batches = 0;
        begin();
    }

    private void begin() {
        begun = own;
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
        left *= Math.min(1, after / before);
        samples++;
        if (samples < length) {
            return;
        }
        double forgotten = left * left;
        double expected = (1 - left) * (1 - left) * begun + Math.max(0, after - forgotten * begun);
        if (expected > 0) {
            batches++;
            ratio += (sum * sum / expected - ratio) / Math.min(batches, memory);
            prior *= forgotten;
        }
        begin();
    }

    /**
     * Nothing was learned: what the parameter may have drifted adds to what is unknown of it.
     *
     * @param now the filter's variance
     */
    void miss(double now) {
        double drifted = Math.max(0, now - own);
        prior += drifted;
        begun += drifted;
        own = now;
    }

    /**
     * Variance of the parameter: what was known of it until a batch has told how it scatters.
     *
     * @param filters the filter's own, the least that it can be
     */
    double variance(double filters) {
        if (batches == 0) {
            return Math.max(filters, prior);
        }
        double student = STUDENT[(int) Math.min(Math.min(batches, memory), STUDENT.length - 1)];
        double more = Math.max(1, student * ratio) - 1;
        return filters + more * Math.max(0, filters - left * left * prior);
    }

    @Override
    public void save(StateWriter out) {
        out.put(prior);
        out.put(begun);
        out.put(sum);
        out.put(left);
        out.put(samples);
        out.put(ratio);
        out.put(batches);
        out.put(own);
    }

    @Override
    public void load(StateReader in) {
        boolean told = in.version() >= WITH_RATIO;
        prior = in.number();
        begun = told ? in.number() : 0;
        sum = in.number();
        left = in.number();
        samples = in.integer();
        ratio = in.number();
        batches = in.number();
        own = in.number();
        if (!told) { // how it scatters is found anew
            ratio = 0;
            batches = 0;
            begin();
        }
    }
}

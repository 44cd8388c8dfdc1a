package wbv.filter;

import java.io.Serializable;
import java.util.Arrays;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** Weights of particles, kept as logarithms so that none underflows. */
final class ParticleWeights implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final double[] logs;
    private final double[] weights;

    ParticleWeights(int count) {
        this.logs = new double[count];
        this.weights = new double[count];
        equal();
    }

    void equal() {
        Arrays.fill(logs, -Math.log(logs.length));
        Arrays.fill(weights, 1.0 / weights.length);
    }

    /** Adds a log likelihood to one; {@link #normalise} before weights are asked for. */
    void add(int particle, double logLikelihood) {
        logs[particle] += logLikelihood;
    }

    /** Makes them sum to one. Returns the effective number of particles, {@code 1 / Σ w²}. */
    double normalise() {
        double largest = Double.NEGATIVE_INFINITY;
        for (double log : logs) {
            largest = Math.max(largest, log);
        }
        double sum = 0;
        for (int k = 0; k < logs.length; k++) {
            weights[k] = Math.exp(logs[k] - largest);
            sum += weights[k];
        }
        double shift = largest + Math.log(sum);
        double squares = 0;
        for (int k = 0; k < logs.length; k++) {
            weights[k] /= sum;
            logs[k] -= shift;
            squares += weights[k] * weights[k];
        }
        return 1 / squares;
    }

    double of(int particle) {
        return weights[particle];
    }

    /** All of them. Not to be modified. */
    double[] all() {
        return weights;
    }

    @Override
    public void save(StateWriter out) {
        out.put(logs);
        out.put(weights);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(logs);
        in.numbers(weights);
    }
}

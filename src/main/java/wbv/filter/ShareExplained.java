package wbv.filter;

import java.io.Serializable;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * What the predictions of a body learner explain of the output, each made before its output was seen: over all samples,
 * {@code 1 - Σ(y - ŷ)² / Σ(y - ȳ)²}, and where lately they explain nothing.
 *
 * <p>A sample is lost where something excites the body and, over the last {@value #MEMORY} s, the predictions err no less than the
 * output's own mean would. An estimator may be sure of itself and explain nothing all the same: it only diverges when it finds out.
 */
public final class ShareExplained implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;
    /** Memory of what is lost [s]: what an estimator gives itself to find out. */
    private static final double MEMORY = 5;

    private double samples;
    private double mean;
    private double total;
    private double errors;
    private double lateMean;
    private double latePower;
    private double lateError;
    private long lost;

    /**
     * Takes a prediction and what came; missing values are left out.
     *
     * @param prediction in the output's unit
     * @param output     likewise
     * @param rate       [Hz]
     * @param excited    whether something excites the body
     */
    public void accept(double prediction, double output, double rate, boolean excited) {
        if (!Double.isFinite(prediction) || !Double.isFinite(output)) {
            return;
        }
        samples++;
        double from = output - mean;
        mean += from / samples;
        total += from * (output - mean);
        double error = (output - prediction) * (output - prediction);
        errors += error;
        double weight = 1 / Math.min(samples, MEMORY * rate);
        double late = output - lateMean;
        lateMean += weight * late;
        latePower += weight * ((1 - weight) * late * late - latePower);
        lateError += weight * (error - lateError);
        if (excited && samples >= MEMORY * rate && lateError >= latePower) {
            lost++;
        }
    }

    /**
     * Share of the output's variance that the predictions explain, at most 1; below 0 they are worse than its mean. NaN before it moves.
     */
    public double share() {
        return total > 0 ? 1 - errors / total : Double.NaN;
    }

    /** Samples at which the predictions explained nothing of the last seconds. */
    public long lost() {
        return lost;
    }

    @Override
    public void save(StateWriter out) {
        out.put(samples);
        out.put(mean);
        out.put(total);
        out.put(errors);
        out.put(lateMean);
        out.put(latePower);
        out.put(lateError);
        out.put(lost);
    }

    @Override
    public void load(StateReader in) {
        samples = in.number();
        mean = in.number();
        total = in.number();
        errors = in.number();
        lateMean = in.number();
        latePower = in.number();
        lateError = in.number();
        lost = in.count();
    }
}

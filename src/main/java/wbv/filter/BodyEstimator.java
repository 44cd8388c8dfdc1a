package wbv.filter;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.util.Arrays;

/**
 * Natural frequency and damping ratio of a body, sample by sample, from the acceleration that shakes it and its own: an extended
 * Kalman filter on motion and parameters together ({@link JointFilter}), whose noise adapts to what it meets
 * ({@link OutputNoise}, {@link ParameterNoise}) and which an {@link Alarm} tells when the body has changed.
 *
 * <p>The step is exact for the input that {@link InputWindow} reads between samples, so the estimate is
 * {@value InputWindow#LATENCY} samples behind the present; {@link #predict} brings it up to date. Gravity and bias of the sensors
 * may be in both signals. Missing samples are bridged, and after a long gap the motion is found again. An estimate that
 * leaves the bounds of {@link Spec}, or explains nothing, begins anew, each time with more patience.
 */
public final class BodyEstimator implements Serializable {

    private static final long serialVersionUID = 1;
    /** Time for which parameters are held after a start, while the motion is found [s]. */
    private static final double PATIENCE = 0.5;
    private static final double PATIENCE_AFTER_DIVERGENCE = 5;
    private static final double LONGEST_PATIENCE = 60;
    private static final double LONGEST_GAP = 0.5;

    private final Spec spec;
    private final Track track = new Track();
    private final Baseline baseline;
    private final InputWindow window;
    private final JointFilter filter;
    private final OutputNoise noise;
    private final Vigil vigil;
    private final double[] delayedOutput = new double[InputWindow.LATENCY + 1];
    private double withoutInput;
    private double moving;
    private double patience;

    /** @param alarm hears the innovations; owned by the estimator from now on */
    public BodyEstimator(Spec spec, Alarm alarm) {
        this.spec = spec;
        this.baseline = new Baseline(spec.rate());
        this.window = new InputWindow(spec.rate());
        this.filter = new JointFilter(spec, baseline.decay());
        this.noise = new OutputNoise(spec.rate(), spec.outputNoise());
        this.vigil = new Vigil(spec.rate(), alarm);
        reset();
    }

    public Spec spec() {
        return spec;
    }

    /** What is known after the last sample. The same object always. */
    public Track track() {
        return track;
    }

    /** Covariance of [v, w, ln ω, ln ζ, d] in m/s, 1 and m/s², 5 by 5, row by row. A copy. */
    public double[] covariance() {
        return filter.covariance();
    }

    /** |H(f)| of the body as now known. @param f [Hz] */
    public double modulus(double f) {
        return OneDegree.modulus(track.frequency, track.damping, f);
    }

    /** As before the first sample. */
    public void reset() {
        baseline.reset();
        window.reset();
        track.clear();
        patience = PATIENCE;
        beginAnew();
        publish();
    }

    /** An estimator that continues as this one would, independent of it. */
    public BodyEstimator copy() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(this);
            out.flush();
            return (BodyEstimator) new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())).readObject();
        } catch (IOException | ClassNotFoundException impossible) {
            throw new IllegalStateException("estimator or its alarm does not serialise", impossible);
        }
    }

    /**
     * The output that goes with the next input sample, from everything before it. Changes nothing.
     *
     * @param u input [m/s²]; NaN if missing
     * @return predicted output [m/s²]; NaN before the first sample if the input is missing
     */
    public double predict(double u) {
        if (!baseline.started()) {
            return u;
        }
        double input = Double.isFinite(u) ? baseline.input(u) : 0;
        return baseline.rawOutput(filter.foresee(window, input));
    }

    /**
     * Takes the next sample.
     *
     * @param u acceleration of the base [m/s²]; NaN if missing
     * @param y acceleration of the body [m/s²]; NaN if missing
     * @return {@link #track}
     */
    public Track step(double u, double y) {
        boolean hasInput = Double.isFinite(u);
        boolean hasOutput = Double.isFinite(y);
        track.prediction = predict(u);
        track.nis = Double.NaN;
        track.cut = false;
        track.changed = false;
        track.missing += hasInput && hasOutput ? 0 : 1;
        if (!baseline.started() && hasInput && hasOutput) {
            baseline.start(u, y);
        }
        if (baseline.started() && !inGap(hasInput)) {
            push(u, hasInput, y, hasOutput);
            advance();
            publish();
        }
        return track;
    }

    private boolean inGap(boolean hasInput) {
        boolean before = withoutInput > LONGEST_GAP;
        withoutInput = hasInput ? 0 : withoutInput + 1 / spec.rate();
        boolean now = withoutInput > LONGEST_GAP;
        if (now && !before) {
            track.gaps++;
            restartMotion();
        }
        return now;
    }

    private void push(double u, boolean hasInput, double y, boolean hasOutput) {
        window.push(hasInput ? baseline.input(u) : 0, hasInput);
        System.arraycopy(delayedOutput, 1, delayedOutput, 0, InputWindow.LATENCY);
        delayedOutput[InputWindow.LATENCY] = hasOutput ? baseline.output(y) : Double.NaN;
        if (hasInput && hasOutput) {
            double surprise = JointFilter.limited(y - track.prediction, noise.variance());
            baseline.advance(u, vigil.settled() ? track.prediction + surprise : y);
        }
    }

    private void advance() {
        moving += 1 / spec.rate();
        boolean gapped = window.gapped();
        filter.advance(window, gapped || moving < patience);
        boolean lost = false;
        double y = delayedOutput[0];
        if (Double.isFinite(y)) {
            double variance = noise.variance();
            filter.correct(y, variance, noise.samplesInOne());
            double s = filter.predictedVariance() + variance;
            track.nis = filter.innovation() * filter.innovation() / s;
            noise.hear(y - filter.innovation() + filter.believed() - filter.offset());
            if (!gapped) {
                noise.learn(filter.innovation(), filter.predictedVariance());
                lost = filter.informed() && judge(track.nis, filter.believed() / Math.sqrt(s));
            }
        }
        if (lost || !filter.sane()) {
            track.divergences++;
            patience = Math.min(LONGEST_PATIENCE, Math.max(PATIENCE_AFTER_DIVERGENCE, 2 * patience));
            beginAnew();
        }
    }

    /** True if the filter is lost. */
    private boolean judge(double nis, double normalised) {
        Vigil.Verdict verdict = vigil.hear(nis, noise.explainsNothing());
        switch (verdict) {
            case CALMER -> noise.relearn();
            case CHANGED -> {
                noise.doubt();
                filter.doubt();
                track.changed = true;
                track.changes++;
            }
            default -> { }
        }
        if (verdict == Vigil.Verdict.CALMER || verdict == Vigil.Verdict.CHANGED) {
            track.cut = true;
            track.cuts++;
        }
        if (verdict == Vigil.Verdict.QUIET) {
            patience = PATIENCE;
            noise.correlate(normalised);
            filter.learnDrift(vigil.width());
        }
        return verdict == Vigil.Verdict.LOST;
    }

    /** Parameters and their uncertainty as at the start, motion unknown, statistics empty. */
    private void beginAnew() {
        filter.start();
        noise.reset();
        vigil.restart();
        restartMotion();
    }

    private void restartMotion() {
        window.restart();
        filter.restartMotion();
        Arrays.fill(delayedOutput, Double.NaN);
        moving = 0;
    }

    private void publish() {
        track.frequency = filter.frequency();
        track.damping = filter.damping();
        track.frequencyDeviation = track.frequency * filter.deviation(0);
        track.dampingDeviation = track.damping * filter.deviation(1);
        track.outputNoise = Math.sqrt(noise.variance());
        track.settled = vigil.settled();
        track.width = vigil.width();
    }
}

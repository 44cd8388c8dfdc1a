package wbv.filter;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Natural frequency and damping ratio of a body from the acceleration that shakes it and its own: an extended Kalman filter
 * on the joint state {@code ξ = [v, w, ln ω, ln ζ, d]} of {@link OneDegree}, where d is the offset between the two sensors
 * that {@link Baseline} has not yet forgotten.
 *
 * <p>The step is exact for the input that {@link InputWindow} reads between samples, so the filter corrects
 * {@value InputWindow#LATENCY} samples behind the present:
 * {@code ξ⁻ = g(ξ, u)}, {@code P⁻ = F P Fᵀ + Q}, {@code ν = y - h(ξ⁻)}, {@code S = H P⁻ Hᵀ + R}, {@code K = P⁻ Hᵀ / S},
 * {@code P = (I - KH) P⁻ (I - KH)ᵀ + K R Kᵀ}.
 *
 * <ul>
 * <li>While parameters are uncertain, R is raised by a share of {@code H P⁻ Hᵀ} for what the linearisation leaves out
 * (underweighting: Zanetti, DeMars and Bishop, J. Guidance, Control and Dynamics 2010).</li>
 * <li>A parameter to which the output is not sensitive just now is held and only considered (Schmidt, 1966).</li>
 * <li>The {@link Alarm} hears the probability of each ν²/S under a right model, uniform in [0, 1]. If it cuts because that rose,
 * the body has changed: the parameters become uncertain, together with the motion that followed from them.</li>
 * </ul>
 */
public final class BodyEstimator implements Serializable {

    private static final long serialVersionUID = 1;
    private static final int N = 5;
    private static final int PARAMETERS = 2;
    private static final int FIRST = 2;
    private static final int OFFSET = 4;

    /** Standard deviations at the start: parameters (ln), acceleration of the unknown motion and offset [m/s²]. */
    private static final double START = 0.5;
    private static final double START_MOTION = 1;
    private static final double START_OFFSET = 1;
    /** Standard deviation that a change adds to the parameters (ln). */
    private static final double CHANGE = 0.25;
    private static final double UNDERWEIGHT = 1;
    /** Largest normalised innovation that is believed: what is beyond counts as this much. */
    private static final double LARGEST_INNOVATION = 5;
    /** The output must move by this many times the sensor's noise when a parameter doubles, for it to be estimated. */
    private static final double SENSITIVE = 5;
    private static final double SENSITIVITY_MEMORY = 1;
    /** Time for which parameters are held after a start, while the motion is found [s]. */
    private static final double FINDING_MOTION = 0.5;
    private static final double PATIENCE_AFTER_DIVERGENCE = 5;
    private static final double LONGEST_PATIENCE = 60;
    private static final double SETTLING = 10;
    private static final double SETTLING_AFTER_CHANGE = 5;
    private static final double LONGEST_GAP = 0.5;
    private static final double NIS_MEMORY = 3;
    private static final double LEAST_SETTLED_NIS = 0.75;
    private static final double MOST_SETTLED_NIS = 1.5;
    private static final double LONGEST_USELESS = 5;
    private static final double MOST_NIS = 30;

    private final Spec spec;
    private final Alarm alarm;
    private final Track track = new Track();
    private final double omegaReference;

    private final Baseline baseline;
    private final InputWindow window;
    private final OutputNoise noise;
    private final ParameterNoise[] drift;
    private final OneDegree model;

    private final double[] x = new double[N];
    private final double[][] sensitivity = new double[PARAMETERS][2];
    private final double[] sensitivityPower = new double[PARAMETERS];
    private final double[] delayedOutput = new double[InputWindow.LATENCY + 1];
    private final DMatrixRMaj p = new DMatrixRMaj(N, N);

    private final DMatrixRMaj f = new DMatrixRMaj(N, N);
    private final DMatrixRMaj h = new DMatrixRMaj(1, N);
    private final DMatrixRMaj k = new DMatrixRMaj(N, 1);
    private final DMatrixRMaj keep = new DMatrixRMaj(N, N);
    private final DMatrixRMaj work = new DMatrixRMaj(N, N);
    private final double[] c = new double[InputWindow.POINTS];
    private final double[] ahead = new double[2];

    private boolean modelIsCurrent;
    private long sinceInput;
    private long moving;
    private double patience;
    private double untilSettled;
    private long useless;
    private boolean settled;
    private double meanNis;

    /** @param alarm hears the innovations; owned by the estimator from now on */
    public BodyEstimator(Spec spec, Alarm alarm) {
        this.spec = spec;
        this.alarm = alarm;
        this.omegaReference = 2 * Math.PI * spec.frequency();
        this.baseline = new Baseline(spec.rate());
        this.window = new InputWindow(spec.rate());
        this.noise = new OutputNoise(spec.rate(), spec.outputNoise());
        this.drift = new ParameterNoise[] {
            new ParameterNoise(spec.drift(), spec.rate()), new ParameterNoise(spec.drift(), spec.rate())};
        this.model = new OneDegree(omegaReference, spec.rate());
        reset();
    }

    public Spec spec() {
        return spec;
    }

    /** What is known after the last sample. The same object always. */
    public Track track() {
        return track;
    }

    /** Covariance of [v, w, ln ω, ln ζ, d] in m/s, 1 and m/s², 5 by 5. A copy. */
    public double[] covariance() {
        return p.data.clone();
    }

    /** |H(f)| of the body as now known. @param f [Hz] */
    public double modulus(double f) {
        return OneDegree.modulus(track.frequency, track.damping, f);
    }

    /** As before the first sample. */
    public void reset() {
        baseline.reset();
        window.reset();
        track.cuts = 0;
        track.changes = 0;
        track.divergences = 0;
        track.gaps = 0;
        track.missing = 0;
        track.prediction = Double.NaN;
        patience = FINDING_MOTION;
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
     * @return predicted output [m/s²]
     */
    public double predict(double u) {
        if (!baseline.started()) {
            return u;
        }
        double present = Double.isNaN(u) ? 0 : baseline.input(u);
        refreshModel();
        ahead[0] = x[0];
        ahead[1] = x[1];
        double offset = x[OFFSET];
        for (int lookAhead = InputWindow.LATENCY; lookAhead >= 0; lookAhead--) {
            window.coefficientsBefore(present, lookAhead, c);
            model.advance(c, ahead);
            offset *= baseline.decay();
        }
        return baseline.rawOutput(model.output(ahead[0], ahead[1]) + offset);
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
        if (!hasInput || !hasOutput) {
            track.missing++;
        }
        sinceInput = hasInput ? 0 : sinceInput + 1;
        if (!baseline.started()) {
            if (!hasInput || !hasOutput) {
                return track;
            }
            baseline.start(u, y);
        }
        if (sinceInput > LONGEST_GAP * spec.rate()) {
            if (sinceInput - 1 <= LONGEST_GAP * spec.rate()) {
                track.gaps++;
            }
            restartMotion();
            return track;
        }
        window.push(hasInput ? baseline.input(u) : 0, hasInput);
        System.arraycopy(delayedOutput, 1, delayedOutput, 0, InputWindow.LATENCY);
        delayedOutput[InputWindow.LATENCY] = hasOutput ? baseline.output(y) : Double.NaN;
        if (hasInput && hasOutput) {
            baseline.advance(u, y);
        }
        advance();
        if (Double.isFinite(delayedOutput[0])) {
            correct(delayedOutput[0]);
        }
        if (diverged()) {
            track.divergences++;
            beginAnew();
            patience = Math.min(LONGEST_PATIENCE, Math.max(PATIENCE_AFTER_DIVERGENCE, 2 * patience));
        }
        publish();
        return track;
    }

    /** ξ⁻ = g(ξ, u), P⁻ = F P Fᵀ + Q. */
    private void advance() {
        refreshModel();
        moving++;
        ExactStep step = model.step();
        window.coefficients(c);
        fillTransition(step);
        for (int i = 0; i < PARAMETERS; i++) {
            advanceSensitivity(step, i);
        }
        model.advance(c, x);
        x[OFFSET] *= baseline.decay();

        CommonOps_DDRM.mult(f, p, work);
        CommonOps_DDRM.multTransB(work, f, p);
        double inputVariance = spec.inputNoise() * spec.inputNoise() + window.varianceOfMissing();
        double[] g = step.gain(0);
        for (int r = 0; r < 2; r++) {
            for (int s = 0; s < 2; s++) {
                p.add(r, s, g[r] * g[s] * inputVariance);
            }
        }
        for (int i = 0; i < PARAMETERS; i++) {
            if (sensitive(i)) {
                p.add(FIRST + i, FIRST + i, drift[i].variance());
            }
        }
    }

    /** F = ∂g/∂ξ at the last estimate; before x moves. */
    private void fillTransition(ExactStep step) {
        double[] e = step.transition();
        for (int r = 0; r < 2; r++) {
            f.set(r, 0, e[2 * r]);
            f.set(r, 1, e[2 * r + 1]);
            for (int i = 0; i < PARAMETERS; i++) {
                f.set(r, FIRST + i, forced(step, i, r));
            }
        }
        for (int i = 0; i < PARAMETERS; i++) {
            f.set(FIRST + i, FIRST + i, 1);
        }
        f.set(OFFSET, OFFSET, baseline.decay());
    }

    /** Row r of ∂/∂θ_i of (E x + Σ g_j c_j), x held. */
    private double forced(ExactStep step, int i, int r) {
        double[] de = step.transitionSlope(i);
        double sum = de[2 * r] * x[0] + de[2 * r + 1] * x[1];
        for (int j = 0; j < c.length; j++) {
            sum += step.gainSlope(i, j)[r] * c[j];
        }
        return sum;
    }

    /** s = ∂x/∂θ along the motion since the start, and the mean square of ∂y/∂θ. */
    private void advanceSensitivity(ExactStep step, int i) {
        double[] e = step.transition();
        double[] s = sensitivity[i];
        double v = e[0] * s[0] + e[1] * s[1] + f.get(0, FIRST + i);
        double w = e[2] * s[0] + e[3] * s[1] + f.get(1, FIRST + i);
        s[0] = v;
        s[1] = w;
        double slope = model.output(v, w) + model.outputSlope(i, x[0], x[1]);
        sensitivityPower[i] += (slope * slope - sensitivityPower[i]) / (SENSITIVITY_MEMORY * spec.rate());
    }

    private boolean sensitive(int parameter) {
        double least = SENSITIVE * spec.outputNoise();
        return sensitivityPower[parameter] > least * least && moving > patience * spec.rate() && !window.gapped();
    }

    private void correct(double y) {
        h.set(0, 0, model.damper());
        h.set(0, 1, model.spring());
        for (int i = 0; i < PARAMETERS; i++) {
            h.set(0, FIRST + i, model.outputSlope(i, x[0], x[1]));
        }
        h.set(0, OFFSET, 1);

        noise.hear(y - x[OFFSET]);
        // K's numerator P⁻ Hᵀ, and S = H P⁻ Hᵀ + R
        CommonOps_DDRM.multTransB(p, h, k);
        double predicted = Math.max(0, CommonOps_DDRM.dot(h, k));
        double innovation = y - model.output(x[0], x[1]) - x[OFFSET];
        double s = predicted + noise.variance();
        double nis = innovation * innovation / s;
        double r = noise.variance() * noise.samplesInOne() + UNDERWEIGHT * predicted;
        double believed = Math.max(-LARGEST_INNOVATION, Math.min(LARGEST_INNOVATION, innovation / Math.sqrt(s))) * Math.sqrt(s);

        CommonOps_DDRM.scale(1 / (predicted + r), k);
        for (int i = 0; i < PARAMETERS; i++) {
            if (!sensitive(i)) {
                k.set(FIRST + i, 0, 0);
            }
        }
        for (int i = 0; i < N; i++) {
            x[i] += k.get(i, 0) * believed;
        }
        joseph(r);
        modelIsCurrent = false;
        track.nis = nis;
        listen(innovation, predicted, nis, believed);
    }

    /** P = (I - KH) P⁻ (I - KH)ᵀ + K R Kᵀ, symmetrised; right for any K. */
    private void joseph(double r) {
        CommonOps_DDRM.mult(-1, k, h, keep);
        for (int i = 0; i < N; i++) {
            keep.add(i, i, 1);
        }
        CommonOps_DDRM.mult(keep, p, work);
        CommonOps_DDRM.multTransB(work, keep, p);
        for (int i = 0; i < N; i++) {
            for (int j = 0; j <= i; j++) {
                double value = (p.get(i, j) + p.get(j, i)) / 2 + r * k.get(i, 0) * k.get(j, 0);
                p.set(i, j, value);
                p.set(j, i, value);
            }
        }
    }

    /** What the innovation says about the noise and about the body having changed. */
    private void listen(double innovation, double predicted, double nis, double believed) {
        if (window.gapped()) {
            return;
        }
        noise.learn(innovation, predicted);
        boolean informed = sensitive(0) || sensitive(1);
        if (!informed) {
            return;
        }
        meanNis += (Math.min(nis, 100) - meanNis) / (NIS_MEMORY * spec.rate());
        untilSettled -= 1 / spec.rate();
        useless = noise.explainsNothing() ? useless + 1 : 0;
        settled |= untilSettled <= 0 && meanNis > LEAST_SETTLED_NIS && meanNis < MOST_SETTLED_NIS;
        if (!settled) {
            return;
        }
        patience = FINDING_MOTION;
        noise.correlate(believed / Math.sqrt(predicted + noise.variance()));
        double before = alarm.mean();
        if (alarm.feed(Probability.chiSquare1(nis))) {
            track.cut = true;
            track.cuts++;
            noise.relearn();
            if (alarm.mean() > before) {
                track.changes++;
                noise.doubt();
                doubtParameters();
            }
        }
        for (int i = 0; i < PARAMETERS; i++) {
            drift[i].learn(k.get(FIRST + i, 0) * believed, alarm.width());
        }
    }

    /** P += σ² [s; 1][s; 1]ᵀ for each parameter. */
    private void doubtParameters() {
        for (int i = 0; i < PARAMETERS; i++) {
            double[] s = sensitivity[i];
            double variance = CHANGE * CHANGE;
            for (int r = 0; r < 2; r++) {
                for (int q = 0; q < 2; q++) {
                    p.add(r, q, variance * s[r] * s[q]);
                }
                p.add(r, FIRST + i, variance * s[r]);
                p.add(FIRST + i, r, variance * s[r]);
            }
            p.add(FIRST + i, FIRST + i, variance);
            drift[i].reset();
        }
        alarm.reset();
        untilSettled = SETTLING_AFTER_CHANGE;
        settled = false;
    }

    private boolean diverged() {
        for (int i = 0; i < N; i++) {
            if (!Double.isFinite(x[i]) || !(p.get(i, i) >= 0) || !(p.get(i, i) < 1e12)) {
                return true;
            }
        }
        double frequency = Math.exp(x[FIRST]) / (2 * Math.PI);
        double damping = Math.exp(x[FIRST + 1]);
        return frequency < Spec.LEAST_FREQUENCY || frequency > Spec.MOST_FREQUENCY
                || damping < Spec.LEAST_DAMPING || damping > Spec.MOST_DAMPING || meanNis > MOST_NIS
                || useless > LONGEST_USELESS * spec.rate();
    }

    /** Parameters and their uncertainty as at the start, motion unknown, statistics empty. */
    private void beginAnew() {
        Arrays.fill(x, 0);
        x[FIRST] = Math.log(2 * Math.PI * spec.frequency());
        x[FIRST + 1] = Math.log(spec.damping());
        p.zero();
        p.set(FIRST, FIRST, START * START);
        p.set(FIRST + 1, FIRST + 1, START * START);
        noise.reset();
        restartMotion();
        alarm.reset();
        for (ParameterNoise q : drift) {
            q.reset();
        }
        sinceInput = 0;
        untilSettled = SETTLING;
        settled = false;
        useless = 0;
        meanNis = 1;
        modelIsCurrent = false;
    }

    /** The motion and the offset are unknown again; parameters stay. */
    private void restartMotion() {
        window.restart();
        Arrays.fill(delayedOutput, Double.NaN);
        for (int i : new int[] {0, 1, OFFSET}) {
            x[i] = 0;
            for (int j = 0; j < N; j++) {
                p.set(i, j, 0);
                p.set(j, i, 0);
            }
        }
        double motion = START_MOTION / omegaReference;
        p.set(0, 0, motion * motion);
        p.set(1, 1, motion * motion);
        p.set(OFFSET, OFFSET, START_OFFSET * START_OFFSET);
        for (double[] s : sensitivity) {
            Arrays.fill(s, 0);
        }
        Arrays.fill(sensitivityPower, 0);
        moving = 0;
    }

    private void refreshModel() {
        if (!modelIsCurrent) {
            model.set(x[FIRST], x[FIRST + 1]);
            modelIsCurrent = true;
        }
    }

    private void publish() {
        track.frequency = Math.exp(x[FIRST]) / (2 * Math.PI);
        track.damping = Math.exp(x[FIRST + 1]);
        track.frequencyDeviation = track.frequency * Math.sqrt(p.get(FIRST, FIRST));
        track.dampingDeviation = track.damping * Math.sqrt(p.get(FIRST + 1, FIRST + 1));
        track.outputNoise = Math.sqrt(noise.variance());
        track.settled = settled;
        track.width = alarm.width();
    }
}

package wbv.filter;

import java.io.Serializable;
import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The extended Kalman filter on {@code ξ = [v, w, ln ω, ln ζ, d]}: motion and parameters of {@link OneDegree}, and the offset d
 * between two sensors that {@link Baseline} has not yet forgotten.
 *
 * <p>{@code ξ⁻ = g(ξ, u)}, {@code P⁻ = F P Fᵀ + Q}, {@code ν = y - h(ξ⁻)}, {@code S = H P⁻ Hᵀ + R}, {@code K = P⁻ Hᵀ / S},
 * {@code ξ = ξ⁻ + K ν}, {@code P = (I - KH) P⁻ (I - KH)ᵀ + K R Kᵀ}; F and H are the exact derivatives at the last estimate and at
 * ξ⁻.
 *
 * <ul>
 * <li>While parameters are uncertain, R is raised by a share of {@code H P⁻ Hᵀ} for what the linearisation leaves out
 * (underweighting: Zanetti, DeMars and Bishop, J. Guidance, Control and Dynamics 2010).</li>
 * <li>A parameter to which the output is not sensitive just now is held and only considered (Schmidt 1966).</li>
 * </ul>
 */
final class JointFilter implements Serializable {

    private static final long serialVersionUID = 1;
    private static final int N = 5;
    private static final int PARAMETERS = 2;
    private static final int FIRST = 2;
    private static final int OFFSET = 4;
    private static final int[] MOTION = {0, 1, OFFSET};

    /** Standard deviations at the start: parameters (ln), acceleration of the unknown motion, offset [m/s²]. */
    static final double START = 0.5;
    private static final double START_MOTION = 1;
    private static final double START_OFFSET = 1;
    /** Standard deviation that a change adds to the parameters (ln). */
    private static final double CHANGE = 0.25;
    private static final double UNDERWEIGHT = 1;
    /** Largest normalised innovation that is believed: what is beyond counts as this much. */
    private static final double LARGEST_INNOVATION = 5;
    /** The output must move by this many times the sensor's noise when a parameter grows e-fold, for it to be estimated. */
    private static final double SENSITIVE = 5;

    private final Spec spec;
    private final double offsetDecay;
    private final double reference;
    private final OneDegree model;
    private final ParameterNoise[] drift = new ParameterNoise[PARAMETERS];

    private final double[] x = new double[N];
    private final DMatrixRMaj p = new DMatrixRMaj(N, N);
    private final Sensitivity[] sensitivity = new Sensitivity[PARAMETERS];
    private final boolean[] free = new boolean[PARAMETERS];
    private boolean modelIsCurrent;
    private double innovation;
    private double believed;
    private double predicted;

    private final DMatrixRMaj f = new DMatrixRMaj(N, N);
    private final DMatrixRMaj h = new DMatrixRMaj(1, N);
    private final DMatrixRMaj k = new DMatrixRMaj(N, 1);
    private final DMatrixRMaj keep = new DMatrixRMaj(N, N);
    private final DMatrixRMaj work = new DMatrixRMaj(N, N);
    private final double[] c = new double[InputWindow.POINTS];
    private final double[] ahead = new double[2];

    /** @param offsetDecay what is left of the sensors' offset after one sample */
    JointFilter(Spec spec, double offsetDecay) {
        this.spec = spec;
        this.offsetDecay = offsetDecay;
        this.reference = 2 * Math.PI * spec.frequency();
        this.model = new OneDegree(reference, spec.rate());
        Arrays.setAll(drift, i -> new ParameterNoise(spec.drift(), spec.rate()));
        Arrays.setAll(sensitivity, i -> new Sensitivity(spec.rate()));
    }

    /** Parameters and their uncertainty as at the start, the motion unknown. */
    void start() {
        x[FIRST] = Math.log(reference);
        x[FIRST + 1] = Math.log(spec.damping());
        p.zero();
        for (int i = 0; i < PARAMETERS; i++) {
            p.set(FIRST + i, FIRST + i, START * START);
            drift[i].reset();
        }
        modelIsCurrent = false;
        restartMotion();
    }

    /** The motion and the offset are unknown again; parameters stay. */
    void restartMotion() {
        for (int i : MOTION) {
            x[i] = 0;
            for (int j = 0; j < N; j++) {
                p.set(i, j, 0);
                p.set(j, i, 0);
            }
        }
        double motion = START_MOTION / reference;
        p.set(0, 0, motion * motion);
        p.set(1, 1, motion * motion);
        p.set(OFFSET, OFFSET, START_OFFSET * START_OFFSET);
        for (Sensitivity s : sensitivity) {
            s.reset();
        }
    }

    /** The body may have changed: parameters become uncertain, and with them the motion, P += σ² [s; 1][s; 1]ᵀ for each. */
    void doubt() {
        double variance = CHANGE * CHANGE;
        for (int i = 0; i < PARAMETERS; i++) {
            double v = sensitivity[i].v();
            double w = sensitivity[i].w();
            int theta = FIRST + i;
            addSymmetric(0, 0, variance * v * v);
            addSymmetric(0, 1, variance * v * w);
            addSymmetric(1, 1, variance * w * w);
            addSymmetric(0, theta, variance * v);
            addSymmetric(1, theta, variance * w);
            addSymmetric(theta, theta, variance);
            drift[i].reset();
        }
    }

    private void addSymmetric(int row, int column, double value) {
        p.add(row, column, value);
        if (row != column) {
            p.add(column, row, value);
        }
    }

    /** The output, offset included, that an input sample after those of the window goes with. Changes nothing. */
    double foresee(InputWindow window, double input) {
        refreshModel();
        ahead[0] = x[0];
        ahead[1] = x[1];
        double offset = x[OFFSET];
        for (int lookAhead = InputWindow.LATENCY; lookAhead >= 0; lookAhead--) {
            window.coefficientsBefore(input, lookAhead, c);
            model.advance(c, ahead);
            offset *= offsetDecay;
        }
        return model.output(ahead[0], ahead[1]) + offset;
    }

    /** ξ⁻ = g(ξ, u), P⁻ = F P Fᵀ + Q. @param hold whether parameters are to be held at this sample */
    void advance(InputWindow window, boolean hold) {
        refreshModel();
        ExactStep step = model.step();
        window.coefficients(c);
        fillTransition(step);
        for (int i = 0; i < PARAMETERS; i++) {
            sensitivity[i].advance(step.transition(), f.get(0, FIRST + i), f.get(1, FIRST + i));
        }
        model.advance(c, x);
        for (int i = 0; i < PARAMETERS; i++) {
            sensitivity[i].hear(model.output(sensitivity[i].v(), sensitivity[i].w()) + model.outputSlope(i, x[0], x[1]));
            free[i] = !hold && sensitivity[i].rms() > SENSITIVE * spec.outputNoise();
        }
        x[OFFSET] *= offsetDecay;

        CommonOps_DDRM.mult(f, p, work);
        CommonOps_DDRM.multTransB(work, f, p);
        addProcessNoise(step.gain(0), spec.inputNoise() * spec.inputNoise() + window.varianceOfMissing());
        symmetrise();
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
        f.set(OFFSET, OFFSET, offsetDecay);
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

    private void addProcessNoise(double[] gain, double inputVariance) {
        addSymmetric(0, 0, gain[0] * gain[0] * inputVariance);
        addSymmetric(0, 1, gain[0] * gain[1] * inputVariance);
        addSymmetric(1, 1, gain[1] * gain[1] * inputVariance);
        for (int i = 0; i < PARAMETERS; i++) {
            if (free[i]) {
                p.add(FIRST + i, FIRST + i, drift[i].variance());
            }
        }
    }

    /** Takes the output that goes with the motion as advanced. @param samplesInOne how many innovations are worth one */
    void correct(double y, double variance, double samplesInOne) {
        h.set(0, 0, model.damper());
        h.set(0, 1, model.spring());
        for (int i = 0; i < PARAMETERS; i++) {
            h.set(0, FIRST + i, model.outputSlope(i, x[0], x[1]));
        }
        h.set(0, OFFSET, 1);

        // K's numerator P⁻ Hᵀ, and H P⁻ Hᵀ
        CommonOps_DDRM.multTransB(p, h, k);
        predicted = Math.max(0, CommonOps_DDRM.dot(h, k));
        innovation = y - model.output(x[0], x[1]) - x[OFFSET];
        believed = limited(innovation, predicted + variance);
        double r = variance * samplesInOne + UNDERWEIGHT * predicted;

        CommonOps_DDRM.scale(1 / (predicted + r), k);
        for (int i = 0; i < PARAMETERS; i++) {
            if (!free[i]) {
                k.set(FIRST + i, 0, 0);
            }
        }
        for (int i = 0; i < N; i++) {
            x[i] += k.get(i, 0) * believed;
        }
        joseph(r);
        modelIsCurrent = false;
    }

    /** P = (I - KH) P⁻ (I - KH)ᵀ + K R Kᵀ; right for any K. */
    private void joseph(double r) {
        CommonOps_DDRM.mult(-1, k, h, keep);
        for (int i = 0; i < N; i++) {
            keep.add(i, i, 1);
        }
        CommonOps_DDRM.mult(keep, p, work);
        CommonOps_DDRM.multTransB(work, keep, p);
        CommonOps_DDRM.multAddTransB(r, k, k, p);
        symmetrise();
    }

    private void symmetrise() {
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < i; j++) {
                double value = (p.get(i, j) + p.get(j, i)) / 2;
                p.set(i, j, value);
                p.set(j, i, value);
            }
        }
    }

    /** An innovation as far as its variance lets it be believed. */
    static double limited(double innovation, double variance) {
        double most = LARGEST_INNOVATION * Math.sqrt(variance);
        return Math.max(-most, Math.min(most, innovation));
    }

    /** Learns the parameters' process noise from the last correction. @param width of the alarm's window [samples] */
    void learnDrift(long width) {
        for (int i = 0; i < PARAMETERS; i++) {
            drift[i].learn(k.get(FIRST + i, 0) * believed, width);
        }
    }

    /** Whether the last sample could tell about a parameter. */
    boolean informed() {
        return free[0] || free[1];
    }

    /** ν [m/s²] of the last correction. */
    double innovation() {
        return innovation;
    }

    /** ν as far as it was believed [m/s²]. */
    double believed() {
        return believed;
    }

    /** What the sensors' offset now is [m/s²]. */
    double offset() {
        return x[OFFSET];
    }

    /** H P⁻ Hᵀ of the last correction [m²/s⁴]. */
    double predictedVariance() {
        return predicted;
    }

    /** Whether every number is one and the parameters are those of a body. */
    boolean sane() {
        for (int i = 0; i < N; i++) {
            if (!Double.isFinite(x[i]) || !(p.get(i, i) >= 0) || Double.isInfinite(p.get(i, i))) {
                return false;
            }
        }
        double frequency = frequency();
        double damping = damping();
        return frequency >= Spec.LEAST_FREQUENCY && frequency <= Spec.MOST_FREQUENCY
                && damping >= Spec.LEAST_DAMPING && damping <= Spec.MOST_DAMPING;
    }

    double frequency() {
        return Math.exp(x[FIRST]) / (2 * Math.PI);
    }

    double damping() {
        return Math.exp(x[FIRST + 1]);
    }

    /** Standard deviation of ln ω (0) or ln ζ (1). */
    double deviation(int parameter) {
        return Math.sqrt(p.get(FIRST + parameter, FIRST + parameter));
    }

    double[] covariance() {
        return p.data.clone();
    }

    private void refreshModel() {
        if (!modelIsCurrent) {
            model.set(x[FIRST], x[FIRST + 1]);
            modelIsCurrent = true;
        }
    }
}

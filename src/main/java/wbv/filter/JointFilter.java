package wbv.filter;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * A Kalman filter on {@code ξ = [motion, parameters, d]} of a {@link BodyModel}, d the offset between two sensors that {@link
 * Baseline} has not yet forgotten. Its {@link Moments} make it extended or unscented.
 *
 * <p>{@code ξ⁻ = g(ξ, u)}, {@code P⁻ = F P Fᵀ + Q}, {@code ν = y - h(ξ⁻)}, {@code S = H P⁻ Hᵀ + R}, {@code K = P⁻ Hᵀ / S},
 * {@code ξ = ξ⁻ + K ν}, {@code P = (I - KH) P⁻ (I - KH)ᵀ + K R Kᵀ}.
 *
 * <ul>
 * <li>While parameters are uncertain, R is raised by a share of {@code H P⁻ Hᵀ} for what the linearisation leaves out
 * (underweighting: Zanetti, DeMars and Bishop, J. Guidance, Control and Dynamics 2010).</li>
 * <li>A parameter to which the output is not sensitive just now is held and only considered (Schmidt 1966); its variance grows
 * by the assumed drift.</li>
 * </ul>
 * The textbook's filter does neither, and believes every innovation.
 */
final class JointFilter implements BodyFilter {

    private static final long serialVersionUID = 1;

    /** Standard deviations at the start: parameters (ln), acceleration of the unknown motion, offset [m/s²]. */
    static final double START = 0.5;
    static final double START_MOTION = 1;
    static final double START_OFFSET = 1;
    /** Standard deviation that a change adds to the parameters (ln). */
    static final double CHANGE = 0.25;
    private static final double UNDERWEIGHT = 1;

    private final Spec spec;
    private final boolean textbook;
    private final double offsetDecay;
    private final double reference;
    private final BodyModel model;
    private final Moments moments;
    private final int n;
    private final int states;
    private final int parameters;
    private final ParameterNoise[] drift;
    private final Sensitivity sensitivity;
    private final Projection projection;

    /** What the variance of a parameter of which nothing is learned grows by in a sample. */
    private final double resting;
    private final double[] x;
    private final DMatrixRMaj p;
    private final boolean[] free;
    private boolean modelIsCurrent;
    private final Innovation innovation = new Innovation();

    private final DMatrixRMaj k;
    private final double[] c = new double[InputWindow.POINTS];
    private final double[] ahead;

    /**
     * @param model       with slopes; set by this filter
     * @param moments     over the same model, or one of their own
     * @param offsetDecay what is left of the sensors' offset after one sample
     * @param textbook    whether it is to be the extended Kalman filter and nothing more
     */
    JointFilter(Spec spec, BodyModel model, Moments moments, double offsetDecay, boolean textbook) {
        this(spec, model, moments, offsetDecay, textbook, spec.drift());
    }

    /** @param wanders drift of the parameters while samples tell about them [1/√s]; otherwise it is that of the spec */
    JointFilter(Spec spec, BodyModel model, Moments moments, double offsetDecay, boolean textbook, double wanders) {
        this.spec = spec;
        this.textbook = textbook;
        this.offsetDecay = offsetDecay;
        this.reference = 2 * Math.PI * spec.frequency();
        this.model = model;
        this.moments = moments;
        this.n = model.size();
        this.states = model.states();
        this.parameters = model.parameters();
        this.drift = new ParameterNoise[parameters];
        this.free = new boolean[parameters];
        this.x = new double[n];
        this.p = new DMatrixRMaj(n, n);
        this.resting = spec.drift() * spec.drift() / spec.rate();
        this.k = new DMatrixRMaj(n, 1);
        this.ahead = new double[n];
        this.sensitivity = new Sensitivity(model, spec);
        this.projection = new Projection(model);
        Arrays.setAll(drift, i -> new ParameterNoise(wanders, spec.rate()));
    }

    @Override
    public void reset() {
        start();
    }

    @Override
    public void start() {
        model.start(x);
        p.zero();
        for (int i = 0; i < parameters; i++) {
            p.set(states + i, states + i, START * START);
            drift[i].reset();
        }
        modelIsCurrent = false;
        restartMotion();
    }

    @Override
    public void startAt(double[] xi, double[] deviation) {
        System.arraycopy(xi, states, x, states, parameters);
        p.zero();
        for (int i = 0; i < parameters; i++) {
            p.set(states + i, states + i, deviation[i] * deviation[i]);
            drift[i].reset();
        }
        modelIsCurrent = false;
        restartMotion();
    }

    @Override
    public void restartMotion() {
        double motion = START_MOTION / reference;
        for (int i = 0; i < n; i++) {
            if (i < states || i == model.offset()) {
                x[i] = 0;
                for (int j = 0; j < n; j++) {
                    p.set(i, j, 0);
                    p.set(j, i, 0);
                }
                p.set(i, i, i < states ? motion * motion : START_OFFSET * START_OFFSET);
            }
        }
        sensitivity.reset();
    }

    /** P += σ² [s; 1][s; 1]ᵀ for each parameter. */
    @Override
    public void doubt() {
        double variance = CHANGE * CHANGE;
        for (int i = 0; i < parameters; i++) {
            double v = sensitivity.v(i);
            double w = sensitivity.w(i);
            int theta = states + i;
            if (i < states) {
                int first = i - i % 2;
                addSymmetric(first, first, variance * v * v);
                addSymmetric(first, first + 1, variance * v * w);
                addSymmetric(first + 1, first + 1, variance * w * w);
                addSymmetric(first, theta, variance * v);
                addSymmetric(first + 1, theta, variance * w);
            }
            addSymmetric(theta, theta, variance);
            drift[i].reset();
        }
    }

    @Override
    public void rest(double samples) {
        for (int i = 0; i < parameters; i++) {
            p.add(states + i, states + i, samples * resting);
        }
    }

    private void addSymmetric(int row, int column, double value) {
        p.add(row, column, value);
        if (row != column) {
            p.add(column, row, value);
        }
    }

    @Override
    public double foresee(InputWindow window, double input) {
        refreshModel();
        System.arraycopy(x, 0, ahead, 0, n);
        return foresee(model, window, input, offsetDecay, c, ahead);
    }

    /** The output at the end of the window. @param c work @param ahead where the window begins. Modified. */
    static double foresee(BodyModel model, InputWindow window, double input, double offsetDecay, double[] c, double[] ahead) {
        for (int lookAhead = InputWindow.LATENCY; lookAhead >= 0; lookAhead--) {
            window.coefficientsBefore(input, lookAhead, c);
            model.advance(c, ahead);
            ahead[model.offset()] *= offsetDecay;
        }
        return model.output(ahead) + ahead[model.offset()];
    }

    @Override
    public void advance(InputWindow window, boolean hold) {
        refreshModel();
        window.coefficients(c);
        sensitivity.advance(c, x);
        moments.advance(c, x, p);
        sensitivity.hear(x, hold);
        for (int i = 0; i < parameters; i++) {
            free[i] = textbook || sensitivity.free(i);
        }
        addProcessNoise(spec.inputNoise() * spec.inputNoise() + window.varianceOfMissing());
        symmetrise();
    }

    private void addProcessNoise(double inputVariance) {
        for (int i = 0; i < states; i++) {
            double gi = model.step(i / 2).gain(0)[i % 2];
            for (int j = i; j < states; j++) {
                addSymmetric(i, j, gi * model.step(j / 2).gain(0)[j % 2] * inputVariance);
            }
        }
        for (int i = 0; i < parameters; i++) {
            p.add(states + i, states + i, free[i] && !textbook ? drift[i].variance() : resting);
        }
    }

    @Override
    public void correct(double y, double variance, double samplesInOne) {
        double foreseen = moments.measure(x, p, k);
        double predicted = moments.variance();
        innovation.set(y - foreseen, predicted, textbook ? Double.POSITIVE_INFINITY : predicted + variance);
        double r = textbook ? variance : variance * samplesInOne + UNDERWEIGHT * predicted;

        CommonOps_DDRM.scale(1 / (predicted + r), k);
        for (int i = 0; i < parameters; i++) {
            if (!free[i]) {
                k.set(states + i, 0, 0);
            }
        }
        for (int i = 0; i < n; i++) {
            x[i] += k.get(i, 0) * innovation.believed();
        }
        moments.reduce(k, r, p);
        symmetrise();
        modelIsCurrent = false;
    }

    /** Takes another estimate for its own. Neither is modified. */
    void become(double[] mean, DMatrixRMaj covariance) {
        System.arraycopy(mean, 0, x, 0, n);
        p.setTo(covariance);
        modelIsCurrent = false;
    }

    /** Adds a share of this estimate's second moments about a mean. @param about Not modified. @param to Modified. */
    void addMoments(double share, double[] about, DMatrixRMaj to) {
        for (int i = 0; i < n; i++) {
            double apart = x[i] - about[i];
            for (int j = 0; j < n; j++) {
                to.data[i * n + j] += share * (p.data[i * n + j] + apart * (x[j] - about[j]));
            }
        }
    }

    @Override
    public void project(Bounds bounds) {
        modelIsCurrent &= !projection.apply(bounds, x, p);
    }

    private void symmetrise() {
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < i; j++) {
                double value = (p.get(i, j) + p.get(j, i)) / 2;
                p.set(i, j, value);
                p.set(j, i, value);
            }
        }
    }

    @Override
    public void learnDrift(long width) {
        for (int i = 0; i < parameters; i++) {
            drift[i].learn(k.get(states + i, 0) * innovation.believed(), width);
        }
    }

    @Override
    public Sensitivity sensitivity() {
        return sensitivity;
    }

    @Override
    public Innovation innovation() {
        return innovation;
    }

    @Override
    public boolean sane() {
        for (int i = 0; i < n; i++) {
            if (!Double.isFinite(x[i]) || !(p.get(i, i) >= 0) || Double.isInfinite(p.get(i, i))) {
                return false;
            }
        }
        return model.sane(x);
    }

    @Override
    public BodyModel model() {
        return model;
    }

    @Override
    public double[] mean() {
        return x;
    }

    @Override
    public double deviation(int parameter) {
        return Math.sqrt(p.get(states + parameter, states + parameter));
    }

    @Override
    public double[] covariance() {
        return p.data.clone();
    }

    private void refreshModel() {
        if (!modelIsCurrent) {
            model.set(x);
            modelIsCurrent = true;
        }
    }

    @Override
    public void save(StateWriter out) {
        out.put(x);
        for (int i = 0; i < n; i++) {
            out.put(p.data, i * n, i * n + i + 1); // the other half is the same
        }
        out.put(drift);
        out.put(sensitivity);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(x);
        for (int i = 0; i < n; i++) {
            in.numbers(p.data, i * n, i * n + i + 1);
            for (int j = 0; j < i; j++) {
                p.set(j, i, p.get(i, j));
            }
        }
        in.parts(drift);
        in.part(sensitivity);
        modelIsCurrent = false;
    }
}

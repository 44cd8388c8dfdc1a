package wbv.filter;

import java.util.Arrays;
import wbv.filter.model.Adaptation;
import wbv.filter.model.BodyModel;
import wbv.filter.model.Bounds;
import wbv.filter.model.ExcitationLevel;
import wbv.filter.model.InputWindow;
import wbv.filter.model.ModeStep;
import wbv.filter.model.Sensitivity;
import wbv.filter.model.Spec;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * A Kalman filter on {@code ξ = [motion, parameters, d]} of a {@link BodyModel}, d the offset between two sensors, of
 * which each sample forgets a part. Its {@link Moments} make it extended or unscented.
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
 * {@link TextbookFilter} does neither, and believes every innovation.
 * Thesis: Eq. 4-7, 6-1.
 */
sealed class JointFilter implements BodyFilter permits TextbookFilter {

    private static final long serialVersionUID = 1;

    private final Spec spec;
    private final Adaptation.Prior prior;
    /** Standard deviation that a change adds to the parameters (ln). */
    private final double change;
    private final double underweight;
    private final double offsetDecay;
    private final double reference;
    private final BodyModel model;
    private final Moments moments;
    private final int n;
    private final int states;
    private final int parameters;
    private final ParameterNoise[] drift;
    private final Sensitivity sensitivity;
    private final ExcitationLevel excitation;
    private final BoundProjection projection;

    /** What the variance of a parameter of which nothing is learned grows by in a sample. */
    final double resting;
    private final double[] x;
    private final double[] p;
    private final boolean[] free;
    private boolean modelIsCurrent;
    private final Innovation innovation;

    private final double[] k;
    private final double[] c = new double[InputWindow.POINTS];
    private final double[] forced;
    private final double[] ahead;

    /**
     * @param model       with slopes; set by this filter
     * @param moments     over the same model, or one of their own
     * @param offsetDecay what is left of the sensors' offset after one sample
     */
    JointFilter(Spec spec, BodyModel model, Moments moments, double offsetDecay) {
        this(spec, model, moments, offsetDecay, spec.drift());
    }

    /** @param wanders drift of the parameters while samples tell about them [1/√s]; otherwise it is that of the spec */
    JointFilter(Spec spec, BodyModel model, Moments moments, double offsetDecay, double wanders) {
        this.spec = spec;
        this.prior = spec.adaptation().prior();
        this.change = spec.adaptation().wandering().change();
        this.underweight = spec.adaptation().noise().underweight();
        this.innovation = new Innovation(spec);
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
        this.p = new double[n * n];
        this.resting = spec.drift() * spec.drift() / spec.rate();
        this.k = new double[n];
        this.forced = new double[2 * states];
        this.ahead = new double[n];
        this.sensitivity = new Sensitivity(model, spec);
        this.excitation = new ExcitationLevel(spec);
        this.projection = new BoundProjection(model);
        Arrays.setAll(drift, i -> new ParameterNoise(wanders, spec));
    }

    @Override
    public void reset() {
        start();
    }

    @Override
    public void start() {
        model.start(x);
        Arrays.fill(p, 0);
        for (int i = 0; i < parameters; i++) {
            p[(states + i) * (n + 1)] = prior.parameters() * prior.parameters();
            drift[i].reset();
        }
        modelIsCurrent = false;
        restartMotion();
    }

    @Override
    public void startAt(double[] xi, double[] deviation) {
        System.arraycopy(xi, states, x, states, parameters);
        Arrays.fill(p, 0);
        for (int i = 0; i < parameters; i++) {
            p[(states + i) * (n + 1)] = deviation[i] * deviation[i];
            drift[i].reset();
        }
        modelIsCurrent = false;
        restartMotion();
    }

    @Override
    public void restartMotion() {
        double motion = prior.motion() / reference;
        for (int i = 0; i < n; i++) {
            if (i < states || i == model.offset()) {
                x[i] = 0;
                for (int j = 0; j < n; j++) {
                    p[i * n + j] = 0;
                    p[j * n + i] = 0;
                }
                p[i * (n + 1)] = i < states ? motion * motion : prior.offset() * prior.offset();
            }
        }
        sensitivity.reset();
        excitation.reset();
    }

    /** P += σ² [s; 1][s; 1]ᵀ for each parameter. */
    @Override
    public void doubt() {
        double variance = change * change;
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
            p[(states + i) * (n + 1)] += samples * resting;
        }
    }

    private void addSymmetric(int row, int column, double value) {
        p[row * n + column] += value;
        if (row != column) {
            p[column * n + row] += value;
        }
    }

    /** What the output reads of motion and parameters as they are foreseen. Thesis: Eq. 4-10. */
    @Override
    public double foresee(InputWindow window, double input) {
        refreshModel();
        System.arraycopy(x, 0, ahead, 0, n);
        return foresee(model, window, input, offsetDecay, c, ahead);
    }

    /**
     * The output at the end of the window.
     *
     * @param c work
     * @param ahead where the window begins. Modified.
     */
    static double foresee(BodyModel model, InputWindow window, double input, double offsetDecay, double[] c, double[] ahead) {
        window.lookAhead(input);
        int offset = model.offset();
        for (int known = InputWindow.LATENCY; known >= 0; known--) {
            int points = window.coefficientsBefore(known, c);
            model.advance(c, points, ahead);
            ahead[offset] *= offsetDecay;
        }
        return model.output(ahead) + ahead[offset];
    }

    /** Both together: motion and parameters, each with its noise. Thesis: Eq. 4-6, 4-9, 4-12. */
    @Override
    public void advance(InputWindow window, boolean hold) {
        window.coefficients(c);
        excitation.hear(c[0]);
        advance(c, window.varianceOfMissing(), hold || !excitation.excited());
    }

    /**
     * The same, where somebody else knows the input.
     *
     * @param coefficients of the input. Not modified.
     * @param missing      variance that missing samples add to it
     * @param hold         whether parameters are to be held, or nothing excites them
     */
    void advance(double[] coefficients, double missing, boolean hold) {
        refreshModel();
        model.forced(coefficients, x, forced);
        sensitivity.advance(forced);
        moments.advance(coefficients, forced, x, p);
        sensitivity.hear(x, hold);
        for (int i = 0; i < parameters; i++) {
            free[i] = estimates(i);
        }
        addProcessNoise(spec.inputNoise() * spec.inputNoise() + missing);
    }

    /** Process noise: one variance a state on the diagonal. Thesis: Eq. 4-23. */
    private void addProcessNoise(double inputVariance) {
        for (int i = 0; i < states; i += 2) {
            ModeStep own = model.step(i / 2);
            double v = own.firstGain();
            double w = own.secondGain();
            int at = i * n + i;
            p[at] += v * v * inputVariance;
            double cross = v * w * inputVariance;
            p[at + 1] += cross;
            p[at + n] += cross;
            p[at + n + 1] += w * w * inputVariance;
            for (int j = i + 2; j < states; j += 2) {
                ModeStep other = model.step(j / 2);
                addSymmetric(i, j, v * other.firstGain() * inputVariance);
                addSymmetric(i, j + 1, v * other.secondGain() * inputVariance);
                addSymmetric(i + 1, j, w * other.firstGain() * inputVariance);
                addSymmetric(i + 1, j + 1, w * other.secondGain() * inputVariance);
            }
        }
        for (int i = 0; i < parameters; i++) {
            p[(states + i) * (n + 1)] += free[i] ? wandering(i) : resting;
        }
    }

    /** Gain: P Hᵀ / S. Thesis: Eq. 4-15, 4-16. */
    @Override
    public void correct(double y, double variance, double samplesInOne) {
        double foreseen = moments.measure(x, p, k);
        double predicted = moments.variance();
        innovation.set(y - foreseen, predicted, believed(predicted + variance));
        double r = weighed(variance * samplesInOne, predicted);

        double weight = 1 / (predicted + r);
        double believed = innovation.believed();
        for (int i = 0; i < n; i++) {
            boolean held = i >= states && i < states + parameters && !free[i - states];
            k[i] = held ? 0 : weight * k[i];
            x[i] += k[i] * believed;
        }
        moments.reduce(k, r, p);
        modelIsCurrent = false;
    }

    /** Whether a parameter is estimated from the next output and not only considered. */
    boolean estimates(int parameter) {
        return sensitivity.free(parameter);
    }

    /** Variance by which a parameter that is estimated wanders in a sample [1, of its logarithm]. */
    double wandering(int parameter) {
        return drift[parameter].variance();
    }

    /** Variance by which an innovation is limited, of an expected variance s, both in the output's unit squared. */
    double believed(double s) {
        return s;
    }

    /** R that the gain is made with, from that of an independent sample and {@code H P Hᵀ}, all in the output's unit squared. */
    double weighed(double variance, double predicted) {
        return variance + underweight * predicted;
    }

    /** Takes another estimate for its own. Neither is modified. */
    void become(double[] mean, double[] covariance) {
        System.arraycopy(mean, 0, x, 0, n);
        System.arraycopy(covariance, 0, p, 0, n * n);
        modelIsCurrent = false;
    }

    /** Mean and moments will be another's. */
    void becomes() {
        modelIsCurrent = false;
    }

    /** Covariance of the estimate, row by row, to be written where {@link #becomes} was called. */
    double[] moments() {
        return p;
    }

    /**
     * This estimate from a point, and its second moments about it.
     *
     * @param about Not modified.
     * @param apart n long. Modified.
     * @param to    n by n, symmetric to the last bit. Modified.
     */
    void momentsAbout(double[] about, double[] apart, double[] to) {
        for (int i = 0; i < n; i++) {
            apart[i] = x[i] - about[i];
        }
        for (int i = 0; i < n; i++) {
            double own = apart[i];
            int at = i * n;
            for (int j = 0; j < n; j++) {
                to[at + j] = p[at + j] + own * apart[j];
            }
        }
    }

    @Override
    public boolean project(Bounds bounds) {
        boolean moved = projection.apply(bounds, x, p);
        modelIsCurrent &= !moved;
        return moved;
    }

    /** What an update moves: e = K ν. Thesis: Eq. 4-19. */
    @Override
    public void learnDrift(long width) {
        for (int i = 0; i < parameters; i++) {
            drift[i].learn(k[states + i] * innovation.believed(), width);
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
    public boolean learned(int parameter) {
        return k[states + parameter] != 0;
    }

    @Override
    public boolean sane() {
        for (int i = 0; i < n; i++) {
            double variance = p[i * (n + 1)];
            if (!(Math.abs(x[i]) <= Double.MAX_VALUE && variance >= 0 && variance <= Double.MAX_VALUE)) {
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
        return Math.sqrt(p[(states + parameter) * (n + 1)]);
    }

    @Override
    public double[] covariance() {
        return p.clone();
    }

    private void refreshModel() {
        if (!modelIsCurrent) {
            model.set(x);
            modelIsCurrent = true;
        }
    }

    @Override
    public void save(StateWriter out) {
        out.put(excitation);
        saveMember(out);
    }

    @Override
    public void load(StateReader in) {
        in.part(excitation);
        loadMember(in);
    }

    /** What a filter of a {@link Bank} has to itself: all but the excitation. */
    void saveMember(StateWriter out) {
        out.put(x);
        for (int i = 0; i < n; i++) {
            out.put(p, i * n, i * n + i + 1); // the other half is the same
        }
        out.put(drift);
        out.put(sensitivity);
    }

    void loadMember(StateReader in) {
        in.numbers(x);
        for (int i = 0; i < n; i++) {
            in.numbers(p, i * n, i * n + i + 1);
        }
        Linearised.mirror(p, n);
        in.parts(drift);
        in.part(sensitivity);
        modelIsCurrent = false;
    }
}

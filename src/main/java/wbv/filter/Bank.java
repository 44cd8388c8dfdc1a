package wbv.filter;

import java.util.Arrays;
import wbv.filter.model.Adaptation;
import wbv.filter.model.BodyModel;
import wbv.filter.model.Bounds;
import wbv.filter.model.ExcitationLevel;
import wbv.filter.model.InputWindow;
import wbv.filter.model.Sensitivity;
import wbv.filter.model.Spec;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Filters of one body that differ in how fast its parameters may wander, as interacting multiple models (Blom and Bar-Shalom,
 * IEEE Trans. Automatic Control 33, 1988): from a body that stays as it is to one that becomes another within a second. Before
 * each sample every filter begins from the mixture of all, weighed by how likely the body came from their way of wandering to
 * its own; after it they are weighed by how well they foresaw it. So the estimate is sluggish while nothing happens and quick
 * when something does, at once and without a threshold.
 *
 * <p>A way of wandering by {@code d} is left when it has moved the parameters by about {@link Adaptation.Wandering#change}, after {@code
 * (change / d)²} seconds.
 *
 * <p>Beside them runs a witness: a filter of the body as it was when it last changed, which wanders least and is told nothing
 * by the others. How much better the mixture foresees than the witness is the {@linkplain #gain() evidence} of a change.
 */
final class Bank implements BodyFilter {

    private static final long serialVersionUID = 1;
    /** Filters; their drifts are as the powers of a ratio. */
    private static final int MEMBERS = 4;
    /** Which of them wanders as is assumed. */
    private static final int ASSUMED = 1;

    private final Adaptation.Wandering settings;
    private final double expected;
    private final double forgetting;
    private final ExcitationLevel excitation;
    private final JointFilter[] members;
    private final JointFilter witness;
    private final BodyModel model;
    private final double offsetDecay;
    private final double[][] transition;
    private final double[] weights;
    private final double[] next;
    private final double[] likelihood;
    private final double[] reference;
    private final double[][] apart;
    private final double[][] moments;
    private final double[] shift;
    private final double[] x;
    /** Covariance of the mixture; found when it is asked for, since from sample to sample the parameters' variances are enough. */
    private final double[] p;
    private final double[] variances;
    /** Of the members where they were merged last. */
    private final double[] merged;
    private final double[] ahead;
    private final double[] c = new double[InputWindow.POINTS];
    private final Innovation innovation;
    private boolean covarianceIsCurrent;
    private boolean told;
    private double surprise;
    private double gain;
    private double witnessNis;

    /** What makes a filter that wanders by so much [1/√s]. */
    interface Maker {
        JointFilter filter(double drift);
    }

    /**
     * @param model of the mixture; its own
     * @param offsetDecay what is left of the sensors' offset after a sample
     */
    Bank(Spec spec, BodyModel model, double offsetDecay, Maker maker) {
        int n = model.size();
        int k = MEMBERS;
        this.settings = spec.adaptation().wandering();
        this.expected = settings.expectedSurprise();
        this.innovation = new Innovation(spec);
        this.model = model;
        this.forgetting = 1 / (settings.surpriseMemory() * spec.rate());
        this.offsetDecay = offsetDecay;
        this.excitation = new ExcitationLevel(spec);
        this.members = new JointFilter[k];
        Arrays.setAll(members, i -> maker.filter(factor(i) * spec.drift()));
        this.witness = maker.filter(factor(0) * spec.drift());
        this.transition = new double[k][k];
        for (int i = 0; i < k; i++) {
            double moved = settings.change() / (factor(i) * spec.drift());
            double leaves = Math.min(1, 1 / (spec.rate() * Math.min(settings.longest(), moved * moved)));
            Arrays.fill(transition[i], leaves / (k - 1));
            transition[i][i] = 1 - leaves;
        }
        this.weights = new double[k];
        this.next = new double[k];
        this.likelihood = new double[k];
        this.reference = new double[n];
        this.apart = new double[k][n];
        this.moments = new double[k][n * n];
        this.shift = new double[n];
        this.x = new double[n];
        this.p = new double[n * n];
        this.variances = new double[model.parameters()];
        this.merged = new double[k];
        this.ahead = new double[n];
        reset();
    }

    @Override
    public void reset() {
        for (JointFilter member : members) {
            member.reset();
        }
        witness.reset();
        begin();
    }

    @Override
    public void start() {
        for (JointFilter member : members) {
            member.start();
        }
        witness.start();
        begin();
    }

    @Override
    public void startAt(double[] xi, double[] deviation) {
        for (JointFilter member : members) {
            member.startAt(xi, deviation);
        }
        witness.startAt(xi, deviation);
        begin();
    }

    private void begin() {
        Arrays.fill(weights, 1.0 / weights.length);
        told = false;
        excitation.reset();
        surprise = expected;
        gain = 0;
        witnessNis = Double.NaN;
        merge();
    }

    @Override
    public void restartMotion() {
        for (JointFilter member : members) {
            member.restartMotion();
        }
        witness.restartMotion();
        excitation.reset();
        merge();
    }

    /** The witness becomes the body as it now is. */
    @Override
    public void doubt() {
        witness.become(x, mixture());
    }

    @Override
    public void rest(double samples) {
        for (JointFilter member : members) {
            member.rest(samples);
        }
        witness.rest(samples);
        merge();
    }

    @Override
    public double foresee(InputWindow window, double input) {
        model.set(x);
        System.arraycopy(x, 0, ahead, 0, x.length);
        return JointFilter.foresee(model, window, input, offsetDecay, c, ahead);
    }

    /** Where nothing can be learned, ways of wandering are not left either. */
    @Override
    public void advance(InputWindow window, boolean hold) {
        boolean learned = told;
        if (learned && judges()) {
            mix();
        }
        told = false;
        window.coefficients(c);
        excitation.hear(c[0]);
        double missing = window.varianceOfMissing();
        boolean still = hold || !excitation.excited();
        for (JointFilter member : members) {
            member.advance(c, missing, still);
        }
        witness.advance(c, missing, still);
        if (learned) {
            meet(); // the covariance is merged with the next output
        } else {
            merge(); // which does not come: what is known of the body fades
        }
    }

    /** Drift of a filter over that which is assumed [1]. */
    private double factor(int member) {
        return Math.pow(settings.ratio(), member - ASSUMED);
    }

    /** Whether a body that changes can be told from an input that is not what its sensor says. */
    private boolean judges() {
        return informed() && excitation.level() > settings.clear();
    }

    /**
     * {@code c_j = Σ p_ij μ_i}, {@code x_j = Σ p_ij μ_i x_i / c_j}, {@code P_j} with the spread between them. Nothing has moved the
     * filters since they were merged with the last output.
     */
    private void mix() {
        for (int j = 0; j < members.length; j++) {
            next[j] = 0;
            for (int i = 0; i < members.length; i++) {
                next[j] += transition[i][j] * weights[i];
            }
            for (int i = 0; i < members.length; i++) {
                likelihood[i] = transition[i][j] * weights[i] / next[j];
            }
            moveTo(likelihood);
            members[j].becomes();
            blend(likelihood, members[j].mean(), members[j].moments());
        }
        System.arraycopy(next, 0, weights, 0, weights.length);
    }

    private void merge() {
        spread();
        System.arraycopy(weights, 0, merged, 0, weights.length);
        covarianceIsCurrent = false;
        moveTo(merged);
        for (int r = 0; r < shift.length; r++) {
            x[r] = reference[r] + shift[r];
        }
        for (int i = 0; i < variances.length; i++) {
            int r = model.states() + i;
            int e = r * (shift.length + 1);
            double sum = 0;
            for (int m = 0; m < merged.length; m++) {
                sum += merged[m] * moments[m][e];
            }
            variances[i] = sum - shift[r] * shift[r];
        }
    }

    /** Covariance of the mixture. Not to be modified. */
    private double[] mixture() {
        if (!covarianceIsCurrent) {
            moveTo(merged);
            blend(merged, ahead, p);
            covarianceIsCurrent = true;
        }
        return p;
    }

    /** Where the filters are, and their second moments, about one of them: once for all mixtures of them. */
    private void spread() {
        System.arraycopy(members[ASSUMED].mean(), 0, reference, 0, reference.length);
        for (int i = 0; i < members.length; i++) {
            members[i].momentsAbout(reference, apart[i], moments[i]);
        }
    }

    /** The mean of the mixture alone. */
    private void meet() {
        mean(weights, x);
    }

    private void mean(double[] shares, double[] to) {
        Arrays.fill(to, 0);
        for (int i = 0; i < members.length; i++) {
            double[] from = members[i].mean();
            for (int r = 0; r < to.length; r++) {
                to[r] += shares[i] * from[r];
            }
        }
    }

    /**
     * {@code δ = Σ s_i d_i}.
     *
     * @param shares sum to 1. Not modified.
     */
    private void moveTo(double[] shares) {
        double first = shares[0];
        double second = shares[1];
        double third = shares[2];
        double fourth = shares[3];
        for (int r = 0; r < shift.length; r++) {
            shift[r] = first * apart[0][r] + second * apart[1][r] + third * apart[2][r] + fourth * apart[3][r];
        }
    }

    /**
     * Mean and covariance of a mixture, after {@link #spread} and {@link #moveTo}: {@code r + δ} and {@code Σ s_i (P_i + d_i d_iᵀ) - δ
     * δᵀ}.
     *
     * @param shares     sum to 1. Not modified.
     * @param mean       Modified.
     * @param covariance Modified.
     */
    private void blend(double[] shares, double[] mean, double[] covariance) {
        double[] a = moments[0];
        double[] b = moments[1];
        double[] c = moments[2];
        double[] d = moments[3];
        double first = shares[0];
        double second = shares[1];
        double third = shares[2];
        double fourth = shares[3];
        for (int e = 0; e < covariance.length; e++) {
            covariance[e] = first * a[e] + second * b[e] + third * c[e] + fourth * d[e];
        }
        int n = shift.length;
        for (int r = 0; r < n; r++) {
            double own = shift[r];
            mean[r] = reference[r] + own;
            for (int col = 0; col < n; col++) {
                covariance[r * n + col] -= own * shift[col];
            }
        }
    }

    @Override
    public void correct(double y, double variance, double samplesInOne) {
        told = true;
        double scale = Math.max(1, surprise / expected);
        double mean = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < members.length; i++) {
            likelihood[i] = corrected(members[i], y, variance, samplesInOne, scale);
            most = Math.max(most, likelihood[i]);
            mean += weights[i] * members[i].innovation().value();
        }
        double predicted = 0;
        double sum = 0;
        for (int i = 0; i < members.length; i++) {
            double apart = members[i].innovation().value() - mean;
            predicted += weights[i] * (members[i].innovation().predictedVariance() + apart * apart);
            likelihood[i] = Math.exp(likelihood[i] - most);
            sum += weights[i] * likelihood[i];
        }
        innovation.set(mean, predicted, predicted + variance);
        surprise += forgetting * (Math.min(settings.mostSurprise(), mean * mean / (predicted + variance)) - surprise);
        double unchanged = corrected(witness, y, variance, samplesInOne, scale);
        boolean judges = judges();
        gain = judges ? most + Math.log(sum) - unchanged : 0;
        double nu = witness.innovation().value();
        witnessNis = nu * nu / (witness.innovation().predictedVariance() + variance);
        if (judges) {
            for (int i = 0; i < members.length; i++) {
                weights[i] *= likelihood[i] / sum;
            }
        }
        merge();
    }

    /** Corrects a filter. Returns the log likelihood of the sample but for a constant, S scaled, as far as it is believed. */
    private static double corrected(JointFilter filter, double y, double variance, double samplesInOne, double scale) {
        filter.correct(y, variance, samplesInOne);
        double s = scale * (filter.innovation().predictedVariance() + variance * samplesInOne);
        double believed = filter.innovation().believed();
        return -0.5 * (Math.log(s) + believed * believed / s);
    }

    @Override
    public boolean project(Bounds bounds) {
        boolean moved = false;
        for (JointFilter member : members) {
            moved |= member.project(bounds);
        }
        witness.project(bounds);
        if (moved || !told) { // otherwise the last output has merged them as they are
            merge();
        }
        return moved;
    }

    /** Log likelihood of the last output under the mixture, over that under the body as it was when it last changed. */
    double gain() {
        return gain;
    }

    /** ν²/S of the body as it was when it last changed. */
    double witnessNis() {
        return witnessNis;
    }

    @Override
    public void learnDrift(long width) {}

    @Override
    public Sensitivity sensitivity() {
        return members[ASSUMED].sensitivity();
    }

    @Override
    public Innovation innovation() {
        return innovation;
    }

    @Override
    public boolean learned(int parameter) {
        for (JointFilter member : members) {
            if (member.learned(parameter)) {
                return true;
            }
        }
        return false;
    }

    @Override
    public boolean sane() {
        for (JointFilter member : members) {
            if (!member.sane()) {
                return false;
            }
        }
        return witness.sane();
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
        return Math.sqrt(variances[parameter]);
    }

    @Override
    public double[] covariance() {
        return mixture().clone();
    }

    @Override
    public void save(StateWriter out) {
        out.put(excitation);
        for (JointFilter member : members) {
            member.saveMember(out);
        }
        witness.saveMember(out);
        out.put(weights);
        out.put(told);
        out.put(surprise);
        out.put(x);
        mixture();
        for (int i = 0; i < x.length; i++) {
            out.put(p, i * x.length, i * x.length + i + 1);
        }
    }

    @Override
    public void load(StateReader in) {
        in.part(excitation);
        for (JointFilter member : members) {
            member.loadMember(in);
        }
        witness.loadMember(in);
        in.numbers(weights);
        told = in.flag();
        surprise = in.number();
        in.numbers(x);
        for (int i = 0; i < x.length; i++) {
            in.numbers(p, i * x.length, i * x.length + i + 1);
        }
        Linearised.mirror(p, x.length);
        covarianceIsCurrent = true;
        for (int i = 0; i < variances.length; i++) {
            variances[i] = p[(model.states() + i) * (x.length + 1)];
        }
        spread(); // where nothing was corrected since, the mixture is an older one and is found anew before it is used
    }
}

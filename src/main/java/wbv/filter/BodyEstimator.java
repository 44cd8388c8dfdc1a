package wbv.filter;

import java.util.Arrays;
import wbv.filter.drift.Alarm;
import wbv.filter.drift.ChangeTest;
import wbv.filter.model.Adaptation;
import wbv.filter.model.BodyModel;
import wbv.filter.model.InputWindow;
import wbv.filter.model.Spec;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Natural frequency and damping ratio of a body, sample by sample, from what shakes it and how it moves: a {@link BodyFilter}
 * on motion and parameters together, whose noise adapts to what it meets ({@link OutputNoise}, {@link ParameterNoise}) and
 * which an {@link Alarm} tells when the body has changed.
 *
 * <p>The step is exact for the input that {@link InputWindow} reads between samples, so the estimate is {@value
 * InputWindow#LATENCY} samples behind the present; {@link #predict} brings it up to date. Gravity and bias of the sensors may
 * be in both signals. Missing samples are bridged, and after a long gap the motion is found again. An estimate that leaves the
 * bounds of {@link Spec}, or explains nothing, begins anew, each time with more patience; one that settles where it explains
 * little begins elsewhere, twice at most. While nothing excites the body its parameters hold and their deviations grow.
 */
public final class BodyEstimator implements Estimator {

    private static final long serialVersionUID = 1;

    /** How often it begins elsewhere because the body that was found explains little. */
    private static final int MOST_TRIES = 2;

    private final Spec spec;
    private final EstimatorDesign design;
    private final boolean adapts;
    private final Adaptation.Restart settings;
    private final BodyEstimate track;
    private final HighPassPair baseline;
    private final InputWindow window;
    private final BodyFilter filter;
    private final Confinement confinement;
    private final OutputNoise noise;
    private final ChangeTests tests;
    private final InnovationWatch watch;
    private final double[] delayedOutput = new double[InputWindow.LATENCY + 1];
    private final double[] elsewhere;
    private final double[] startDeviation;
    private final ObservedScatter[] scatter;
    private final double[] parametersBefore;
    private final double[] variancesBefore;
    private int tries;
    private double withoutInput;
    private double withoutOutput;
    private double moving;
    private double patience;

    /**
     * An extended Kalman filter on one degree of freedom, adapted.
     *
     * @param alarm hears the innovations; owned by the estimator from now on
     */
    public BodyEstimator(Spec spec, Alarm alarm) {
        this(spec, alarm, EstimatorDesign.of(Method.EKF_ADWIN));
    }

    /** @param design of a single filter, not of a fusion */
    BodyEstimator(Spec spec, Alarm alarm, EstimatorDesign design) {
        this.spec = spec;
        this.design = design;
        this.adapts = design.method() != Method.EKF;
        this.settings = spec.adaptation().restart();
        this.track = new BodyEstimate(spec);
        this.baseline = new HighPassPair(spec);
        this.window = new InputWindow(spec);
        EstimatorDesign.Confined confined = design.filter(spec, baseline.decay());
        this.filter = confined.filter();
        this.confinement = confined.confinement();
        this.noise = new OutputNoise(spec);
        this.tests = filter instanceof Bank bank ? new Witness(spec, bank) : new OwnInnovations(spec);
        this.watch = new InnovationWatch(spec, alarm, tests);
        this.elsewhere = new double[filter.model().size()];
        this.startDeviation = new double[filter.model().parameters()];
        Arrays.fill(startDeviation, spec.adaptation().prior().parameters());
        this.scatter = new ObservedScatter[filter.model().parameters()];
        Arrays.setAll(scatter, i -> new ObservedScatter(spec));
        this.parametersBefore = new double[scatter.length];
        this.variancesBefore = new double[scatter.length];
        reset();
    }

    @Override
    public Spec spec() {
        return spec;
    }

    @Override
    public EstimatorDesign design() {
        return design;
    }

    @Override
    public BodyEstimate track() {
        return track;
    }

    /** Covariance of [motion, parameters, d], row by row: of one degree [v, w, ln ω, ln ζ, d] in m/s, 1 and m/s². A copy. */
    @Override
    public double[] covariance() {
        return filter.covariance();
    }

    @Override
    public double modulus(double f) {
        return filter.model().modulus(f, filter.mean());
    }

    BodyFilter filter() {
        return filter;
    }

    @Override
    public void reset() {
        baseline.reset();
        window.reset();
        track.clear();
        confinement.reset();
        filter.reset();
        tries = 0;
        withoutInput = 0;
        withoutOutput = 0;
        patience = settings.patience();
        beginAnew();
        publish();
    }

    @Override
    public BodyEstimator copy() {
        return (BodyEstimator) Estimator.super.copy();
    }

    /**
     * Begins anew from parameters that others found.
     *
     * @param xi read where they are
     * @param deviation of each of them
     */
    void seedFrom(double[] xi, double[] deviation) {
        tries = MOST_TRIES;
        restartAt(xi, deviation);
        publish();
    }

    private void restartAt(double[] xi, double[] deviation) {
        filter.startAt(xi, deviation);
        restartScatter();
        noise.reset();
        watch.restart();
        patience = settings.patience();
        restartMotion();
    }

    @Override
    public double predict(double u) {
        if (!baseline.started()) {
            return u;
        }
        double input = Double.isFinite(u) ? baseline.input(u) : 0;
        return baseline.rawOutput(filter.foresee(window, input));
    }

    @Override
    public BodyEstimate step(double u, double y) {
        boolean hasInput = Double.isFinite(u);
        boolean hasOutput = Double.isFinite(y);
        track.begin(predict(u), hasInput && hasOutput);
        confinement.begin();
        start(u, hasInput, y, hasOutput);
        if (baseline.started() && !inGap(hasInput)) {
            push(u, hasInput, y, hasOutput);
            advance();
            publish();
        }
        return track;
    }

    private void start(double u, boolean hasInput, double y, boolean hasOutput) {
        withoutOutput = hasOutput ? 0 : withoutOutput + 1 / spec.rate();
        if (!baseline.started() && hasInput && hasOutput) {
            baseline.start(u, y);
        } else if (!baseline.started() && hasInput && withoutOutput > settings.longestWait()) {
            baseline.startInput(u);
        } else if (baseline.started() && !baseline.hasOutput() && hasOutput) {
            baseline.startOutput(y);
        }
    }

    private boolean inGap(boolean hasInput) {
        boolean before = withoutInput > settings.longestGap();
        withoutInput = hasInput ? 0 : withoutInput + 1 / spec.rate();
        boolean now = withoutInput > settings.longestGap();
        if (now && !before) {
            track.gap();
            restartMotion();
        }
        if (now) {
            filter.rest(1);
            missSample();
            publish();
        }
        return now;
    }

    private void push(double u, boolean hasInput, double y, boolean hasOutput) {
        window.push(hasInput ? baseline.input(u) : 0, hasInput);
        System.arraycopy(delayedOutput, 1, delayedOutput, 0, InputWindow.LATENCY);
        delayedOutput[InputWindow.LATENCY] = hasOutput ? baseline.output(y) : Double.NaN;
        if (hasInput && hasOutput) {
            double surprise = filter.innovation().limited(y - track.prediction(), variance());
            baseline.advance(u, watch.settled() ? track.prediction() + surprise : y);
        } else if (hasInput && !baseline.hasOutput()) {
            baseline.advanceInput(u);
        }
    }

    private void advance() {
        moving += 1 / spec.rate();
        boolean gapped = window.gapped();
        filter.advance(window, adapts && (gapped || moving < patience));
        track.excite(filter.informed());
        boolean lost = false;
        double y = delayedOutput[0];
        if (Double.isFinite(y)) {
            lost = correct(y, gapped);
        } else {
            missSample();
        }
        confinement.apply();
        if (lost || !filter.sane()) {
            track.diverge();
            patience = Math.min(settings.longestPatience(), Math.max(settings.patienceAfterDivergence(), 2 * patience));
            beginAnew();
        }
    }

    /** True if the filter is lost. */
    private boolean correct(double y, boolean gapped) {
        double variance = variance();
        remember();
        filter.correct(y, variance, adapts ? noise.samplesInOne() : 1);
        hearMoves();
        Innovation innovation = filter.innovation();
        double s = innovation.predictedVariance() + variance;
        track.correct(innovation.value() * innovation.value(), s);
        if (!adapts) {
            return false;
        }
        noise.hear(y - innovation.value() + innovation.believed() - filter.offset());
        if (gapped) {
            return false;
        }
        if (!filter.informed()) {
            return false;
        }
        noise.learn(innovation.value(), innovation.predictedVariance());
        return judge(s);
    }

    private void remember() {
        for (int i = 0; i < scatter.length; i++) {
            variancesBefore[i] = variance(i);
        }
    }

    /**
     * All that moved the parameters since the last time counts: corrections, bounds, and the draws of a particle filter. Where a
     * correction could not move one, nothing was learned of it.
     */
    private void hearMoves() {
        int first = filter.model().states();
        for (int i = 0; i < scatter.length; i++) {
            double parameter = filter.mean()[first + i];
            if (filter.learned(i)) {
                scatter[i].hear(parameter - parametersBefore[i], variancesBefore[i], variance(i));
            } else {
                scatter[i].miss(variance(i));
            }
            parametersBefore[i] = parameter;
        }
    }

    private void missSample() {
        for (int i = 0; i < scatter.length; i++) {
            scatter[i].miss(variance(i));
        }
    }

    /** The filter's own variance of a parameter. */
    private double variance(int parameter) {
        return filter.deviation(parameter) * filter.deviation(parameter);
    }

    /** Standard deviation of a parameter: as the filter believes, or as its corrections have shown. */
    private double deviation(int parameter) {
        return Math.sqrt(scatter[parameter].variance(variance(parameter)));
    }

    private void restartScatter() {
        for (int i = 0; i < scatter.length; i++) {
            scatter[i].restart(variance(i));
            parametersBefore[i] = filter.mean()[filter.model().states() + i];
        }
    }

    /** R of the next sample. */
    private double variance() {
        return adapts ? noise.variance() : spec.outputNoise() * spec.outputNoise();
    }

    /**
     * True if the filter is lost.
     *
     * @param s variance of the innovation
     */
    private boolean judge(double s) {
        boolean settled = watch.settled();
        double believed = filter.innovation().believed();
        double independent = Math.sqrt(filter.innovation().predictedVariance() + variance() * noise.samplesInOne());
        InnovationWatch.Verdict verdict = watch.hear(track.nis(), believed / independent, filter.sensitivity().slope(0) / independent,
                noise);
        if (!settled && watch.settled() && noise.explainsLittle() && tries < MOST_TRIES) {
            beginElsewhere();
            return false;
        }
        switch (verdict) {
            case DISTURBED -> noise.relearn();
            case CHANGED -> {
                if (tests.deafAfterChange()) {
                    noise.doubt();
                }
                filter.doubt();
                restartScatter();
            }
            default -> {}
        }
        track.hear(watch.heardBy(), verdict == InnovationWatch.Verdict.CHANGED);
        if (verdict == InnovationWatch.Verdict.QUIET) {
            patience = settings.patience();
            noise.correlate(believed / Math.sqrt(s));
            filter.learnDrift(watch.width());
        }
        return verdict == InnovationWatch.Verdict.LOST;
    }

    /** At another natural frequency, the modes as far apart as at the start. */
    private void beginElsewhere() {
        double to = tries == 0 ? settings.elsewhere() : settings.elsewhereAgain();
        BodyModel model = filter.model();
        model.start(elsewhere);
        for (int m = 0; m < model.modes(); m++) {
            elsewhere[model.states() + 2 * m] += Math.log(to / spec.frequency());
        }
        tries++;
        restartAt(elsewhere, startDeviation);
    }

    /** Parameters and their uncertainty as at the start, motion unknown, statistics empty. */
    private void beginAnew() {
        filter.start();
        restartScatter();
        noise.reset();
        watch.restart();
        restartMotion();
    }

    private void restartMotion() {
        window.restart();
        filter.restartMotion();
        Arrays.fill(delayedOutput, Double.NaN);
        moving = 0;
    }

    private void publish() {
        BodyModel model = filter.model();
        double[] mean = filter.mean();
        boolean swap = model.modes() == 2 && model.frequency(0, mean) > model.frequency(1, mean);
        for (int m = 0; m < model.modes(); m++) {
            int from = swap ? 1 - m : m;
            track.know(m, model.frequency(from, mean), deviation(2 * from), model.damping(from, mean), deviation(2 * from + 1));
        }
        track.stand(model.modes(), model.share(mean), Math.sqrt(variance()), watch.settled(), watch.width());
    }

    @Override
    public void save(StateWriter out) {
        out.put(track);
        out.put(baseline);
        out.put(window);
        out.put(filter);
        out.put(confinement);
        out.put(noise);
        out.put(watch);
        out.put(delayedOutput);
        out.put(scatter);
        out.put(parametersBefore);
        out.put(tries);
        out.put(withoutInput);
        out.put(withoutOutput);
        out.put(moving);
        out.put(patience);
    }

    @Override
    public void load(StateReader in) {
        in.part(track);
        in.part(baseline);
        in.part(window);
        in.part(filter);
        in.part(confinement);
        in.part(noise);
        in.part(watch);
        in.numbers(delayedOutput);
        in.parts(scatter);
        in.numbers(parametersBefore);
        tries = in.integer();
        withoutInput = in.number();
        withoutOutput = in.number();
        moving = in.number();
        patience = in.number();
        publish();
    }
}

package wbv.filter;

import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import wbv.filter.drift.Alarm;
import wbv.filter.drift.ChangeTest;
import wbv.filter.model.Adaptation;
import wbv.filter.model.BodyModel;
import wbv.filter.model.Spec;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Several estimators of one body, weighed by the evidence of their innovations: the log likelihood {@code -½ (ln S + ν²/S)},
 * forgotten within seconds, as in the interacting and static multiple-model filters (Bar-Shalom, Li and Kirubarajan 2001,
 * 11.6).
 *
 * <p>The estimate is the mean of the mixture, in the logarithms of the parameters, with the spread between members in its
 * variance. A member that has diverged, or stays far behind the best, begins anew from the best once that has settled, and
 * elsewhere until then. What is counted as divergence is that of the best. One member, the scout, always begins elsewhere, so
 * that all cannot agree on the same wrong body for long.
 */
final class FusedEstimator implements Estimator {

    private static final long serialVersionUID = 1;
    /**
     * Unscented filters at these frequencies [Hz] and this damping ratio, beside a constrained bank, an unscented and a particle
     * filter at the start.
     */
    private static final double[] STARTS = {2, 3.5, 6, 11};
    private static final double START_DAMPING = 0.3;
    private static final int SCOUT = 0;
    /** A member's share of the particles of a design. */
    private static final int PARTICLE_SHARE = 4;

    private final Adaptation.Fusion settings;
    private final Spec spec;
    private final EstimatorDesign design;
    private final BodyEstimator[] members;
    private final BodyEstimate track;
    private final SplitMix random;
    private final double[] evidence;
    private final double[] weights;
    private final double[] trust;
    private final double[] sinceAlarm;
    private final ChangeTest[] by;
    private final double[] behind;
    private final long[] divergences;
    private final double[] seed;
    private final double[] deviations;
    private double sinceChange;
    private int best;

    FusedEstimator(Spec spec, EstimatorDesign design, Supplier<? extends Alarm> alarms) {
        this.spec = spec;
        this.settings = spec.adaptation().fusion();
        this.track = new BodyEstimate(spec);
        this.design = design;
        this.random = new SplitMix(design.seed());
        this.members = new BodyEstimator[STARTS.length + 3];
        for (int i = 0; i < STARTS.length; i++) {
            members[i] = new BodyEstimator(spec.startingAt(STARTS[i], START_DAMPING), alarms.get(),
                    design.by(Method.UNSCENTED));
        }
        int few = Math.max(EstimatorDesign.LEAST_PARTICLES, design.particles() / PARTICLE_SHARE);
        int next = STARTS.length;
        for (EstimatorDesign other : List.of(design.by(Method.CONSTRAINED), design.by(Method.UNSCENTED),
                design.by(Method.PARTICLE).withParticles(few))) {
            members[next++] = new BodyEstimator(spec, alarms.get(), other);
        }
        BodyModel model = members[0].filter().model();
        this.evidence = new double[members.length];
        this.weights = new double[members.length];
        this.sinceAlarm = new double[members.length];
        this.trust = new double[members.length];
        this.by = new ChangeTest[members.length];
        this.behind = new double[members.length];
        this.divergences = new long[members.length];
        this.seed = new double[model.size()];
        this.deviations = new double[model.parameters()];
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

    @Override
    public void reset() {
        random.restart();
        for (BodyEstimator member : members) {
            member.reset();
        }
        Arrays.fill(evidence, 0);
        Arrays.fill(trust, 0);
        Arrays.fill(sinceAlarm, settings.oneChange());
        Arrays.fill(by, ChangeTest.NONE);
        Arrays.fill(behind, 0);
        Arrays.fill(divergences, 0);
        sinceChange = 2 * settings.oneChange();
        track.clear();
        weigh();
        // nothing is known yet: the start that was told counts
        best = STARTS.length;
        Arrays.fill(weights, 0);
        weights[best] = 1;
        publish();
    }

    @Override
    public double predict(double u) {
        double sum = 0;
        for (int i = 0; i < members.length; i++) {
            if (weights[i] > 0) {
                sum += weights[i] * members[i].predict(u);
            }
        }
        return sum;
    }

    @Override
    public BodyEstimate step(double u, double y) {
        track.foresee(predict(u));
        ChangeTest test = ChangeTest.NONE;
        double trusted = 0;
        sinceChange += 1 / spec.rate();
        double heard = 0;
        double all = 0;
        boolean excited = false;
        for (int i = 0; i < members.length; i++) {
            BodyEstimate one = members[i].step(u, y);
            if (one.changed()) {
                sinceAlarm[i] = 0;
                by[i] = one.heardBy();
            } else {
                sinceAlarm[i] += 1 / spec.rate();
            }
            if (sinceAlarm[i] < settings.oneChange() && trust[i] > trusted) {
                trusted = trust[i];
                test = by[i];
            }
            heard += sinceAlarm[i] < settings.oneChange() ? trust[i] : 0;
            all += trust[i];
            trust[i] = Math.max(weights[i], trust[i] * (1 - 1 / (settings.trust() * spec.rate())));
            excited |= one.excited();
        }
        boolean changed = heard > settings.heard() * all && sinceChange >= 2 * settings.oneChange();
        track.hear(changed ? test : ChangeTest.NONE, changed);
        sinceChange = changed ? 0 : sinceChange;
        if (excited && Double.isFinite(members[best].track().nis())) {
            hear();
            weigh();
            help();
        }
        publish();
        return track;
    }

    /** Samples that tell nothing are no evidence: what was learned before is not forgotten over them. */
    private void hear() {
        for (int i = 0; i < members.length; i++) {
            BodyEstimate one = members[i].track();
            if (Double.isFinite(one.nis())) {
                evidence[i] += -0.5 * (Math.log(one.innovationVariance()) + one.nis()) - evidence[i] / (settings.memory() * spec.rate());
            }
        }
    }

    private void weigh() {
        best = 0;
        for (int i = 1; i < members.length; i++) {
            if (evidence[i] > evidence[best]) {
                best = i;
            }
        }
        double sum = 0;
        for (int i = 0; i < members.length; i++) {
            weights[i] = Math.exp(evidence[i] - evidence[best]);
            sum += weights[i];
        }
        for (int i = 0; i < members.length; i++) {
            weights[i] /= sum;
        }
    }

    /** Lets members that are lost begin anew. */
    private void help() {
        for (int i = 0; i < members.length; i++) {
            BodyEstimate one = members[i].track();
            boolean diverged = one.divergences() > divergences[i];
            divergences[i] = one.divergences();
            if (diverged && i == best) {
                track.diverge();
            }
            boolean far = one.excited() && evidence[i] < evidence[best] - settings.far();
            behind[i] = far || behind[i] < 0 ? behind[i] + 1 / spec.rate() : 0;
            if (i == best || !diverged && behind[i] < settings.longestBehind()) {
                continue;
            }
            BodyModel model = members[i].filter().model();
            if (members[best].track().settled() && i != SCOUT) {
                seedFromBest(model);
                track.reseed();
            } else {
                seedAnywhere(model);
            }
            members[i].seedFrom(seed, deviations);
            behind[i] = -settings.grace();
        }
    }

    private void seedFromBest(BodyModel model) {
        BodyFilter leader = members[best].filter();
        System.arraycopy(leader.mean(), 0, seed, 0, seed.length);
        for (int i = 0; i < model.parameters(); i++) {
            deviations[i] = Math.hypot(leader.deviation(i), settings.seedDeviation());
        }
    }

    private void seedAnywhere(BodyModel model) {
        model.start(seed);
        Arrays.fill(deviations, spec.adaptation().prior().parameters());
        for (int m = 0; m < model.modes(); m++) {
            int i = model.states() + 2 * m;
            seed[i] = Math.log(2 * Math.PI * settings.lowest()) + random.nextDouble() * Math.log(settings.highest() / settings.lowest());
            seed[i + 1] = Math.log(settings.lightest()) + random.nextDouble() * Math.log(settings.heaviest() / settings.lightest());
        }
    }

    private void publish() {
        BodyEstimate leader = members[best].track();
        for (int m = 0; m < leader.modes(); m++) {
            mix(m);
        }
        track.follow(leader);
    }

    private void mix(int mode) {
        double frequency = 0;
        double damping = 0;
        for (int i = 0; i < members.length; i++) {
            frequency += weights[i] * Math.log(members[i].track().frequency(mode));
            damping += weights[i] * Math.log(members[i].track().damping(mode));
        }
        double frequencyVariance = 0;
        double dampingVariance = 0;
        for (int i = 0; i < members.length; i++) {
            BodyEstimate one = members[i].track();
            double df = Math.log(one.frequency(mode)) - frequency;
            double dz = Math.log(one.damping(mode)) - damping;
            double sf = one.frequencyDeviation(mode) / one.frequency(mode);
            double sz = one.dampingDeviation(mode) / one.damping(mode);
            frequencyVariance += weights[i] * (sf * sf + df * df);
            dampingVariance += weights[i] * (sz * sz + dz * dz);
        }
        track.know(mode, Math.exp(frequency), Math.sqrt(frequencyVariance), Math.exp(damping), Math.sqrt(dampingVariance));
    }

    @Override
    public double modulus(double f) {
        return members[best].modulus(f);
    }

    /** Covariance of the parameters in the mixture: [ln ω, ln ζ] of one degree of freedom. A copy. */
    @Override
    public double[] covariance() {
        BodyModel model = members[0].filter().model();
        int n = model.parameters();
        int from = model.states();
        int size = model.size();
        double[] mean = new double[n];
        for (int i = 0; i < members.length; i++) {
            for (int k = 0; k < n; k++) {
                mean[k] += weights[i] * members[i].filter().mean()[from + k];
            }
        }
        double[] all = new double[n * n];
        for (int i = 0; i < members.length; i++) {
            double[] own = members[i].covariance();
            double[] xi = members[i].filter().mean();
            for (int r = 0; r < n; r++) {
                for (int c = 0; c < n; c++) {
                    double apart = (xi[from + r] - mean[r]) * (xi[from + c] - mean[c]);
                    all[r * n + c] += weights[i] * (own[(from + r) * size + from + c] + apart);
                }
            }
        }
        return all;
    }

    @Override
    public void save(StateWriter out) {
        out.put(members);
        out.put(track);
        out.put(random);
        out.put(evidence);
        out.put(weights);
        out.put(trust);
        out.put(sinceAlarm);
        for (ChangeTest test : by) {
            out.put(test.ordinal());
        }
        out.put(behind);
        out.put(divergences);
        out.put(sinceChange);
        out.put(best);
    }

    @Override
    public void load(StateReader in) {
        in.parts(members);
        in.part(track);
        in.part(random);
        in.numbers(evidence);
        in.numbers(weights);
        in.numbers(trust);
        in.numbers(sinceAlarm);
        for (int i = 0; i < by.length; i++) {
            by[i] = ChangeTest.values()[in.integer(0, ChangeTest.values().length - 1, "a test")];
        }
        in.numbers(behind);
        in.counts(divergences);
        sinceChange = in.number();
        best = in.integer(0, members.length - 1, "the best member");
        publish();
    }
}

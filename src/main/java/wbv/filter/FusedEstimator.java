package wbv.filter;

import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import wbv.filter.drift.Alarm;
import wbv.filter.drift.ChangeTest;
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
    /** A member's share of the particles of a recipe. */
    private static final int PARTICLE_SHARE = 4;
    /** Time in which evidence is forgotten [s]. */
    private static final double MEMORY = 5;
    /** A member this much less likely than the best (ln), for this long [s], is behind. */
    private static final double FAR = 50;
    private static final double LONGEST_BEHIND = 3;
    /** Time that a member has to prove itself after it began anew [s]. */
    private static final double GRACE = 8;
    private static final double SEED_DEVIATION = 0.1;
    private static final double LOW = 1;
    private static final double HIGH = 16;
    private static final double LIGHT = 0.05;
    private static final double HEAVY = 1;
    /**
     * Part of the members, by their weight, whose alarms are a change; weights as of about this time [s], since a change moves
     * them.
     */
    private static final double HEARD = 0.4;
    private static final double TRUST = 3;
    /** Time within which alarms are one [s]. */
    private static final double ONE_CHANGE = 1;

    private final Spec spec;
    private final EstimatorDesign recipe;
    private final BodyEstimator[] members;
    private final BodyEstimate track = new BodyEstimate();
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

    FusedEstimator(Spec spec, EstimatorDesign recipe, Supplier<? extends Alarm> alarms) {
        this.spec = spec;
        this.recipe = recipe;
        this.random = new SplitMix(recipe.seed());
        this.members = new BodyEstimator[STARTS.length + 3];
        for (int i = 0; i < STARTS.length; i++) {
            members[i] = new BodyEstimator(spec.startingAt(STARTS[i], START_DAMPING), alarms.get(),
                    recipe.by(Method.UNSCENTED));
        }
        int few = Math.max(EstimatorDesign.LEAST_PARTICLES, recipe.particles() / PARTICLE_SHARE);
        int next = STARTS.length;
        for (EstimatorDesign other : List.of(recipe.by(Method.CONSTRAINED), recipe.by(Method.UNSCENTED),
                recipe.by(Method.PARTICLE).withParticles(few))) {
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
    public EstimatorDesign recipe() {
        return recipe;
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
        Arrays.fill(sinceAlarm, ONE_CHANGE);
        Arrays.fill(by, ChangeTest.NONE);
        Arrays.fill(behind, 0);
        Arrays.fill(divergences, 0);
        sinceChange = 2 * ONE_CHANGE;
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
        track.prediction = predict(u);
        ChangeTest test = ChangeTest.NONE;
        double trusted = 0;
        sinceChange += 1 / spec.rate();
        double heard = 0;
        double all = 0;
        boolean excited = false;
        for (int i = 0; i < members.length; i++) {
            BodyEstimate one = members[i].step(u, y);
            if (one.changed) {
                sinceAlarm[i] = 0;
                by[i] = one.heard;
            } else {
                sinceAlarm[i] += 1 / spec.rate();
            }
            if (sinceAlarm[i] < ONE_CHANGE && trust[i] > trusted) {
                trusted = trust[i];
                test = by[i];
            }
            heard += sinceAlarm[i] < ONE_CHANGE ? trust[i] : 0;
            all += trust[i];
            trust[i] = Math.max(weights[i], trust[i] * (1 - 1 / (TRUST * spec.rate())));
            excited |= one.excited;
        }
        boolean changed = heard > HEARD * all && sinceChange >= 2 * ONE_CHANGE;
        track.hear(changed ? test : ChangeTest.NONE, changed);
        sinceChange = changed ? 0 : sinceChange;
        if (excited && Double.isFinite(members[best].track().nis)) {
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
            if (Double.isFinite(one.nis)) {
                evidence[i] += -0.5 * (Math.log(one.innovationVariance) + one.nis) - evidence[i] / (MEMORY * spec.rate());
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
            boolean diverged = one.divergences > divergences[i];
            divergences[i] = one.divergences;
            track.divergences += diverged && i == best ? 1 : 0;
            boolean far = one.excited && evidence[i] < evidence[best] - FAR;
            behind[i] = far || behind[i] < 0 ? behind[i] + 1 / spec.rate() : 0;
            if (i == best || !diverged && behind[i] < LONGEST_BEHIND) {
                continue;
            }
            BodyModel model = members[i].filter().model();
            if (members[best].track().settled && i != SCOUT) {
                seedFromBest(model);
                track.reseeds++;
            } else {
                seedAnywhere(model);
            }
            members[i].seedFrom(seed, deviations);
            behind[i] = -GRACE;
        }
    }

    private void seedFromBest(BodyModel model) {
        BodyFilter leader = members[best].filter();
        System.arraycopy(leader.mean(), 0, seed, 0, seed.length);
        for (int i = 0; i < model.parameters(); i++) {
            deviations[i] = Math.hypot(leader.deviation(i), SEED_DEVIATION);
        }
    }

    private void seedAnywhere(BodyModel model) {
        model.start(seed);
        Arrays.fill(deviations, JointFilter.START);
        for (int m = 0; m < model.modes(); m++) {
            int i = model.states() + 2 * m;
            seed[i] = Math.log(2 * Math.PI * LOW) + random.nextDouble() * Math.log(HIGH / LOW);
            seed[i + 1] = Math.log(LIGHT) + random.nextDouble() * Math.log(HEAVY / LIGHT);
        }
    }

    private void publish() {
        BodyEstimate leader = members[best].track();
        track.modes = leader.modes;
        for (int m = 0; m < leader.modes; m++) {
            mix(m);
        }
        track.share = leader.share;
        track.nis = leader.nis;
        track.innovationVariance = leader.innovationVariance;
        track.excited = leader.excited;
        track.outputNoise = leader.outputNoise;
        track.settled = leader.settled;
        track.width = leader.width;
        track.gaps = leader.gaps;
        track.missing = leader.missing;
    }

    private void mix(int mode) {
        double frequency = 0;
        double damping = 0;
        for (int i = 0; i < members.length; i++) {
            frequency += weights[i] * Math.log(members[i].track().frequency[mode]);
            damping += weights[i] * Math.log(members[i].track().damping[mode]);
        }
        double frequencyVariance = 0;
        double dampingVariance = 0;
        for (int i = 0; i < members.length; i++) {
            BodyEstimate one = members[i].track();
            double df = Math.log(one.frequency[mode]) - frequency;
            double dz = Math.log(one.damping[mode]) - damping;
            double sf = one.frequencyDeviation[mode] / one.frequency[mode];
            double sz = one.dampingDeviation[mode] / one.damping[mode];
            frequencyVariance += weights[i] * (sf * sf + df * df);
            dampingVariance += weights[i] * (sz * sz + dz * dz);
        }
        track.frequency[mode] = Math.exp(frequency);
        track.damping[mode] = Math.exp(damping);
        track.frequencyDeviation[mode] = track.frequency[mode] * Math.sqrt(frequencyVariance);
        track.dampingDeviation[mode] = track.damping[mode] * Math.sqrt(dampingVariance);
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

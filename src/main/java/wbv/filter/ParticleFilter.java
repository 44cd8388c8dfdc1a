package wbv.filter;

import java.util.Arrays;
import wbv.filter.model.Adaptation;
import wbv.filter.model.BodyModel;
import wbv.filter.model.ExcitationLevel;
import wbv.filter.model.InputWindow;
import wbv.filter.model.Sensitivity;
import wbv.filter.model.Spec;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * A bootstrap particle filter on motion and parameters of a {@link BodyModel} (Gordon, Salmond and Smith 1993).
 *
 * <p>Each particle moves by its own exact step, driven by the input with noise of its sensor, and its log weight takes {@code
 * -(y - ŷ)²/2R}. When the effective number {@code 1/Σw²} falls below half, particles are resampled systematically; they then
 * move by the kernel of Liu and West (2001), which keeps mean and covariance of the cloud, and are roughened by the drift that
 * {@link ParameterNoise} learned since. Kernel and covariance take motion and parameters together, so that a particle's motion
 * stays that of its parameters. R is raised by the cloud's own spread in the output, so that a wide cloud narrows step by
 * step.
 *
 * <p>The offset between two sensors is followed beside the particles, by a Kalman filter of one state. Half the cloud starts
 * about the start of {@link Spec}, the other half anywhere. When the best particle stays impossible, the filter is lost.
 */
final class ParticleFilter implements BodyFilter {

    private static final long serialVersionUID = 1;

    private final Spec spec;
    private final Adaptation.Particles settings;
    private final double shrinkage;
    private final double kernel;
    private final double underweight;
    private final double change;
    private final double offsetDeviation;
    private final double offsetDecay;
    private final BodyModel model;
    private final SplitMix random;
    private final Sensitivity sensitivity;
    private final ExcitationLevel excitation;
    private final ParameterNoise[] drift;
    private final int states;
    private final int parameters;
    private final int moving;
    private final double motion;

    private double[][] particles;
    private double[][] spare;
    private final ParticleSteps steps;
    private final ParticleWeights weights;
    private final double[] outputs;
    private final Cloud cloud;
    private final double[] mean;
    private final double[] kept;
    private final double[] correction;
    private final double[] walk;
    private final double[] normal;
    private final double[] c = new double[InputWindow.POINTS];
    private final double[] forced;
    private final double[] ahead;
    private double offsetVariance;
    private double impossible;
    private final Innovation innovation;

    /**
     * @param model    with slopes; set by this filter
     * @param stepping the same body without slopes, for the particles' steps
     * @param count    of particles, &gt;= 2 for each number of an estimate
     */
    ParticleFilter(Spec spec, BodyModel model, BodyModel stepping, double offsetDecay, int count, long seed) {
        if (count < 2 * model.size()) {
            throw new IllegalArgumentException("particles must be >= " + 2 * model.size() + ": " + count);
        }
        this.spec = spec;
        this.settings = spec.adaptation().particles();
        this.shrinkage = settings.shrinkage();
        this.kernel = Math.sqrt(1 - shrinkage * shrinkage);
        this.underweight = spec.adaptation().noise().underweight();
        this.change = spec.adaptation().wandering().change();
        this.offsetDeviation = spec.adaptation().prior().offset();
        this.innovation = new Innovation(spec);
        this.offsetDecay = offsetDecay;
        this.model = model;
        this.random = new SplitMix(seed);
        this.sensitivity = new Sensitivity(model, spec);
        this.excitation = new ExcitationLevel(spec);
        this.states = model.states();
        this.parameters = model.parameters();
        this.moving = states + parameters;
        this.motion = spec.adaptation().prior().motion() / (2 * Math.PI * spec.frequency());
        this.particles = new double[count][moving];
        this.spare = new double[count][moving];
        this.steps = new ParticleSteps(stepping, count);
        this.weights = new ParticleWeights(count);
        this.outputs = new double[count];
        this.cloud = new Cloud(moving);
        this.mean = new double[model.size()];
        this.kept = new double[parameters];
        this.correction = new double[parameters];
        this.walk = new double[parameters];
        this.normal = new double[moving];
        this.forced = new double[2 * states];
        this.ahead = new double[model.size()];
        this.drift = new ParameterNoise[parameters];
        Arrays.setAll(drift, i -> new ParameterNoise(spec.drift(), spec));
    }

    @Override
    public void reset() {
        random.restart();
        start();
    }

    @Override
    public void start() {
        ParticlePrior prior = new ParticlePrior(spec.adaptation());
        double[] centre = ahead;
        model.start(centre);
        for (double[] particle : particles) {
            prior.draw(centre, states, random, particle);
        }
        begin();
    }

    @Override
    public void startAt(double[] xi, double[] deviation) {
        for (double[] particle : particles) {
            for (int i = 0; i < parameters; i++) {
                particle[states + i] = xi[states + i] + deviation[i] * random.nextGaussian();
            }
        }
        begin();
    }

    private void begin() {
        Arrays.fill(walk, 0);
        for (ParameterNoise noise : drift) {
            noise.reset();
        }
        impossible = 0;
        weights.equal();
        takeSteps();
        drawMotions();
    }

    /** What was learned of the body, which the weights hold, stays. */
    @Override
    public void restartMotion() {
        resample();
        drawMotions();
    }

    private void drawMotions() {
        for (double[] particle : particles) {
            for (int i = 0; i < states; i++) {
                particle[i] = motion * random.nextGaussian();
            }
        }
        mean[model.offset()] = 0;
        offsetVariance = offsetDeviation * offsetDeviation;
        sensitivity.reset();
        excitation.reset();
        cloud.meanOf(particles, weights.all(), mean);
        cloud.spreadOf(particles, weights.all(), mean, walk);
        model.set(mean);
    }

    @Override
    public void doubt() {
        for (int i = 0; i < parameters; i++) {
            walk[i] += change * change;
            drift[i].reset();
        }
        resample();
        cloud.meanOf(particles, weights.all(), mean);
        cloud.spreadOf(particles, weights.all(), mean, walk);
        model.set(mean);
    }

    @Override
    public void rest(double samples) {
        for (int i = 0; i < parameters; i++) {
            walk[i] += samples * drift[i].assumed();
            cloud.widen(states + i, samples * drift[i].assumed());
        }
    }

    @Override
    public double foresee(InputWindow window, double input) {
        System.arraycopy(mean, 0, ahead, 0, ahead.length);
        return JointFilter.foresee(model, window, input, offsetDecay, c, ahead);
    }

    @Override
    public void advance(InputWindow window, boolean hold) {
        window.coefficients(c);
        excitation.hear(c[0]);
        model.forced(c, mean, forced);
        sensitivity.advance(forced);
        double noise = Math.sqrt(spec.inputNoise() * spec.inputNoise() + window.varianceOfMissing());
        for (int k = 0; k < particles.length; k++) {
            outputs[k] = steps.advance(k, c, noise * random.nextGaussian(), particles[k]);
        }
        cloud.meanOf(particles, weights.all(), mean);
        mean[model.offset()] *= offsetDecay;
        offsetVariance *= offsetDecay * offsetDecay;
        sensitivity.hear(mean, hold || !excitation.excited());
        for (int i = 0; i < parameters; i++) {
            double passed = sensitivity.free(i) ? drift[i].variance() : drift[i].assumed();
            walk[i] += passed;
            cloud.widen(states + i, passed);
        }
    }

    /** Weights all particles by what the output reads of each. Thesis: Eq. 5-8. */
    @Override
    public void correct(double y, double variance, double samplesInOne) {
        double foreseen = 0;
        for (int k = 0; k < outputs.length; k++) {
            foreseen += weights.of(k) * outputs[k];
        }
        double spread = 0;
        for (int k = 0; k < outputs.length; k++) {
            spread += weights.of(k) * (outputs[k] - foreseen) * (outputs[k] - foreseen);
        }
        double predicted = spread + offsetVariance;
        innovation.set(y - foreseen - mean[model.offset()], predicted, predicted + variance);
        double independent = variance * samplesInOne;
        System.arraycopy(mean, states, kept, 0, parameters);
        if (sensitivity.informed()) {
            weigh(foreseen, independent + underweight * predicted, independent);
        }
        double gain = offsetVariance / (predicted + independent);
        mean[model.offset()] += gain * innovation.believed();
        offsetVariance *= 1 - gain;
        cloud.meanOf(particles, weights.all(), mean);
        cloud.spreadOf(particles, weights.all(), mean, walk);
        for (int i = 0; i < parameters; i++) {
            correction[i] = mean[states + i] - kept[i];
        }
        model.set(mean);
    }

    /** Weights by the likelihood of the measurement. Thesis: Eq. 5-10. */
    private void weigh(double foreseen, double r, double independent) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < outputs.length; k++) {
            double e = innovation.believed() + foreseen - outputs[k];
            weights.add(k, -e * e / (2 * r));
            nearest = Math.min(nearest, Math.abs(innovation.value() + foreseen - outputs[k]));
        }
        boolean lost = !(nearest * nearest / (2 * (independent + offsetVariance)) < settings.impossible());
        impossible = lost ? impossible + 1 / spec.rate() : 0;
        if (weights.normalise() < outputs.length / 2.0) {
            resample();
        }
    }

    /** Systematic resampling, then the kernel and the drift. Weights are equal afterwards. Thesis: Eq. 5-13, 5-14, 5-15. */
    private void resample() {
        int count = particles.length;
        cloud.meanOf(particles, weights.all(), mean);
        cloud.covarianceOf(particles, weights.all(), mean);
        cloud.factor();
        double step = 1.0 / count;
        double at = step * random.nextDouble();
        double sum = weights.of(0);
        int parent = 0;
        for (int k = 0; k < count; k++) {
            while (at > sum && parent < count - 1) {
                parent++;
                sum += weights.of(parent);
            }
            move(particles[parent], spare[k]);
            at += step;
        }
        double[][] moved = spare;
        spare = particles;
        particles = moved;
        Arrays.fill(walk, 0);
        weights.equal();
        takeSteps();
    }

    private void move(double[] parent, double[] child) {
        for (int i = 0; i < moving; i++) {
            normal[i] = random.nextGaussian();
        }
        for (int i = 0; i < moving; i++) {
            child[i] = shrinkage * parent[i] + (1 - shrinkage) * mean[i] + kernel * cloud.rootTimes(i, normal);
        }
        for (int i = 0; i < parameters; i++) {
            child[states + i] += Math.sqrt(walk[i]) * random.nextGaussian();
        }
    }

    /** Particles drawn from the state equation. Thesis: Eq. 5-9. */
    private void takeSteps() {
        for (int k = 0; k < particles.length; k++) {
            steps.take(k, particles[k]);
        }
    }

    @Override
    public void learnDrift(long width) {
        for (int i = 0; i < parameters; i++) {
            drift[i].learn(correction[i], width);
        }
    }

    /** Its draws move all of them. */
    @Override
    public boolean learned(int parameter) {
        return true;
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
        for (double value : mean) {
            if (!Double.isFinite(value)) {
                return false;
            }
        }
        return impossible <= settings.longestImpossible() && model.sane(mean);
    }

    @Override
    public BodyModel model() {
        return model;
    }

    @Override
    public double[] mean() {
        return mean;
    }

    @Override
    public double deviation(int parameter) {
        return Math.sqrt(cloud.variance(states + parameter));
    }

    @Override
    public double[] covariance() {
        int n = model.size();
        double[] all = new double[n * n];
        cloud.covarianceOf(particles, weights.all(), mean);
        for (int i = 0; i < moving; i++) {
            for (int j = 0; j < moving; j++) {
                all[i * n + j] = cloud.covariance(i, j) + (i == j && i >= states ? walk[i - states] : 0);
            }
        }
        all[n * n - 1] = offsetVariance;
        return all;
    }

    @Override
    public void save(StateWriter out) {
        out.put(random);
        for (double[] particle : particles) {
            out.put(particle);
        }
        out.put(weights);
        out.put(mean);
        for (int i = 0; i < moving; i++) {
            out.put(cloud.variance(i));
        }
        out.put(walk);
        out.put(drift);
        out.put(sensitivity);
        out.put(excitation);
        out.put(offsetVariance);
        out.put(impossible);
    }

    @Override
    public void load(StateReader in) {
        in.part(random);
        for (double[] particle : particles) {
            in.numbers(particle);
        }
        in.part(weights);
        in.numbers(mean);
        for (int i = 0; i < moving; i++) {
            cloud.know(i, in.number());
        }
        in.numbers(walk);
        in.parts(drift);
        in.part(sensitivity);
        in.part(excitation);
        offsetVariance = in.number();
        impossible = in.number();
        takeSteps();
        model.set(mean);
    }
}

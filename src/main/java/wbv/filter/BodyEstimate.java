package wbv.filter;

import java.io.Serializable;
import java.util.Arrays;
import wbv.filter.drift.ChangeTest;
import wbv.filter.model.Bounds;
import wbv.filter.model.Spec;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * What an estimator knows after a sample. One object is reused: read it before the next sample.
 *
 * <p>Standard deviations of frequency and damping come from those of their logarithms (delta method).
 */
public final class BodyEstimate implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    /** Share of the deviation at the start below which a parameter is found [1]. */
    private static final double FOUND = 0.9;

    private final double found;
    private int modes = 1;
    private final double[] frequency = new double[Bounds.MODES];
    private final double[] damping = new double[Bounds.MODES];
    private final double[] frequencyDeviation = new double[Bounds.MODES];
    private final double[] dampingDeviation = new double[Bounds.MODES];
    private double share = 1;
    private boolean excited;
    private double innovationVariance;
    private double prediction;
    private double nis;
    private double outputNoise;
    private boolean changed;
    /** The test that heard something at this sample. */
    private ChangeTest heard = ChangeTest.NONE;
    private final long[] alarms = new long[ChangeTest.values().length];
    private boolean settled;
    private long width;
    private long cuts;
    private long changes;
    private long divergences;
    private long gaps;
    private long missing;
    private long reseeds;

    /** @param spec with the deviation at the start */
    BodyEstimate(Spec spec) {
        this.found = FOUND * spec.adaptation().prior().parameters();
    }

    /** As before the first sample, but for what the filter publishes after each. */
    void clear() {
        prediction = Double.NaN;
        nis = Double.NaN;
        innovationVariance = Double.NaN;
        excited = false;
        heard = ChangeTest.NONE;
        changed = false;
        Arrays.fill(alarms, 0);
        cuts = 0;
        changes = 0;
        divergences = 0;
        gaps = 0;
        missing = 0;
        reseeds = 0;
    }

    /**
     * A sample begins, of which nothing was learned yet.
     *
     * @param foreseen the output, in its own unit
     * @param whole    whether both samples came
     */
    void begin(double foreseen, boolean whole) {
        foresee(foreseen);
        nis = Double.NaN;
        innovationVariance = Double.NaN;
        excited = false;
        hear(ChangeTest.NONE, false);
        missing += whole ? 0 : 1;
    }

    /** What is foreseen of the output [its own unit]. */
    void foresee(double output) {
        prediction = output;
    }

    /** Whether the sample excited the body. */
    void excite(boolean told) {
        excited = told;
    }

    /**
     * The output has corrected the estimate.
     *
     * @param squared  ν² [output's unit squared]
     * @param expected S [output's unit squared]
     */
    void correct(double squared, double expected) {
        nis = squared / expected;
        innovationVariance = expected;
    }

    /** The input was missing for too long. */
    void gap() {
        gaps++;
    }

    /** The estimate began anew. */
    void diverge() {
        divergences++;
    }

    /** A member began from another. */
    void reseed() {
        reseeds++;
    }

    /**
     * What is known of a mode.
     *
     * @param f0        natural frequency [Hz]
     * @param deviation of its logarithm [1]
     * @param zeta      damping ratio [1]
     * @param spread    of its logarithm [1]
     */
    void know(int mode, double f0, double deviation, double zeta, double spread) {
        frequency[mode] = f0;
        frequencyDeviation[mode] = f0 * deviation;
        damping[mode] = zeta;
        dampingDeviation[mode] = zeta * spread;
    }

    /**
     * What goes along with the modes.
     *
     * @param number of modes
     * @param first  what the slower contributes at rest [1]
     * @param noise  standard deviation that nothing explains [output's unit]
     * @param hears  whether the alarm listens
     * @param window of the alarm, in samples
     */
    void stand(int number, double first, double noise, boolean hears, long window) {
        modes = number;
        share = first;
        outputNoise = noise;
        settled = hears;
        width = window;
    }

    /** Takes what another knows beside its modes, alarms and divergences. */
    void follow(BodyEstimate leader) {
        stand(leader.modes, leader.share, leader.outputNoise, leader.settled, leader.width);
        nis = leader.nis;
        innovationVariance = leader.innovationVariance;
        excited = leader.excited;
        gaps = leader.gaps;
        missing = leader.missing;
    }

    /**
     * What was heard at this sample.
     *
     * @param change whether it is one of the body
     */
    void hear(ChangeTest test, boolean change) {
        heard = test;
        changed = change;
        alarms[test.ordinal()]++;
        cuts += test == ChangeTest.NONE ? 0 : 1;
        changes += change ? 1 : 0;
    }

    /** Modes of the body: 1 or 2. */
    public int modes() {
        return modes;
    }

    /** Natural frequency f0 [Hz], of the slower mode if there are two. */
    public double frequency() {
        return frequency[0];
    }

    /** Natural angular frequency ω [rad/s]. */
    public double omega() {
        return 2 * Math.PI * frequency[0];
    }

    /** Damping ratio ζ [1], of the slower mode. */
    public double damping() {
        return damping[0];
    }

    /** Standard deviation of the natural frequency [Hz]. */
    public double frequencyDeviation() {
        return frequencyDeviation[0];
    }

    /** Standard deviation of the damping ratio [1]. */
    public double dampingDeviation() {
        return dampingDeviation[0];
    }

    /**
     * Natural frequency of a mode [Hz].
     *
     * @param mode from 0, the slowest, to below {@link #modes}
     */
    public double frequency(int mode) {
        return frequency[mode];
    }

    /** Damping ratio of a mode [1]. */
    public double damping(int mode) {
        return damping[mode];
    }

    /** Standard deviation of the natural frequency of a mode [Hz]. */
    public double frequencyDeviation(int mode) {
        return frequencyDeviation[mode];
    }

    /** Standard deviation of the damping ratio of a mode [1]. */
    public double dampingDeviation(int mode) {
        return dampingDeviation[mode];
    }

    /** What the slower mode contributes to the output at rest [1]; 1 where it is alone. */
    public double share() {
        return share;
    }

    /** Whether the last second told about the parameters: where it did not, they hold and their deviations grow. */
    public boolean excited() {
        return excited;
    }

    /** Whether the samples have told anything about the parameters that was not assumed before the first of them. */
    public boolean found() {
        return frequencyDeviation[0] < found * frequency[0] || dampingDeviation[0] < found * damping[0];
    }

    /** The output sample [m/s²] as foreseen from this input sample and everything before it. NaN before the first sample. */
    public double prediction() {
        return prediction;
    }

    /** Normalised innovation squared ν²/S [1]: averages 1 while model and noise are right. NaN where nothing was corrected. */
    public double nis() {
        return nis;
    }

    /** S of the innovation whose ν²/S is {@link #nis} [output's unit squared]. */
    double innovationVariance() {
        return innovationVariance;
    }

    /** Standard deviation [m/s²] of what neither model nor input explains in an output sample; the sensor's at least. */
    public double outputNoise() {
        return outputNoise;
    }

    /** Whether a test rang at this sample: the body, or what disturbs it, has changed. */
    public boolean cut() {
        return heard != ChangeTest.NONE;
    }

    /** The test that rang at this sample. */
    public ChangeTest heardBy() {
        return heard;
    }

    /** How often a test rang so far. */
    public long alarms(ChangeTest test) {
        return alarms[test.ordinal()];
    }

    /** Whether the model became worse at this cut: the body has changed, and its parameters are being learned again. */
    public boolean changed() {
        return changed;
    }

    /** Whether the start (or the last change) is far enough behind that the alarm listens. */
    public boolean settled() {
        return settled;
    }

    /** Number of samples in the alarm's window. */
    public long width() {
        return width;
    }

    /** Cuts so far. */
    public long cuts() {
        return cuts;
    }

    /** Changes so far; each is a cut too. */
    public long changes() {
        return changes;
    }

    /** How often the estimate diverged and began anew. */
    public long divergences() {
        return divergences;
    }

    /** How often the input was missing for so long that the body's motion had to be found again. */
    public long gaps() {
        return gaps;
    }

    /** How often a fused estimator gave one that had diverged the parameters of another. */
    public long reseeds() {
        return reseeds;
    }

    /** Samples of which the input or the output was missing. */
    public long missing() {
        return missing;
    }

    @Override
    public void save(StateWriter out) {
        out.put(prediction);
        out.put(nis);
        out.put(innovationVariance);
        out.put(excited);
        out.put(changed);
        out.put(heard.ordinal());
        out.put(alarms);
        out.put(cuts);
        out.put(changes);
        out.put(divergences);
        out.put(gaps);
        out.put(missing);
        out.put(reseeds);
    }

    @Override
    public void load(StateReader in) {
        prediction = in.number();
        nis = in.number();
        innovationVariance = in.number();
        excited = in.flag();
        changed = in.flag();
        heard = ChangeTest.values()[in.integer(0, alarms.length - 1, "a test")];
        in.counts(alarms);
        cuts = in.count();
        changes = in.count();
        divergences = in.count();
        gaps = in.count();
        missing = in.count();
        reseeds = in.count();
    }
}

package wbv.filter;

import java.io.Serializable;
import java.util.Arrays;
import wbv.filter.model.Adaptation;
import wbv.filter.model.Spec;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * What other motions of the base have to do with an output: a sitter leans when the base moves sideways and nods when it moves
 * fore and aft, and an estimator of one input would take that for noise.
 *
 * <p>The output is taken for a sum of responses to the estimator's own input and to the others, each a series of {@value
 * #TERMS} discrete Laguerre functions (Wahlberg, IEEE Trans. Automatic Control 1991), whose coefficients a Kalman filter follows
 * sample by sample. They wander back towards zero within a minute where nothing tells about them, so that their
 * covariance stays below what it starts with and no narrow excitation winds it up. {@link #foresee} is the part of the others,
 * with the coefficients as they were before the sample: what is taken from an output was not fitted to it.
 *
 * <p>The others must not be the input's own motion seen again: what goes along with it is divided between them.
 */
public final class CrossAxes implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;
    private static final int TERMS = 12;

    private final Adaptation.Others settings;
    private final double rate;
    private final int inputs;
    private final int n;
    private final double pole;
    private final double gain;
    private final double level;
    private final double keep;
    private final double[] previous;
    private final double[] blocked;
    private final double[] power;
    private final double[] x;
    private final double[] ahead;
    private final double[] theta;
    private final double[] start;
    private final double[][] p;
    private final double[] px;
    private double previousOutput;
    private double blockedOutput;
    private double outputPower;
    private double noise;
    private double disturbed;
    private long measured;
    private boolean learning;

    /**
     * Knows no response of any motion yet.
     *
     * @param spec   rate and adaptation
     * @param others number of motions beside the estimator's own input, &gt;= 0
     */
    public CrossAxes(Spec spec, int others) {
        if (others < 0) {
            throw new IllegalArgumentException("other motions must be >= 0: " + others);
        }
        this.settings = spec.adaptation().others();
        this.rate = spec.rate();
        this.inputs = 1 + others;
        this.n = TERMS * inputs;
        this.pole = Math.exp(-settings.decay() / rate);
        this.gain = Math.sqrt(1 - pole * pole);
        this.level = Math.exp(-2 * Math.PI * spec.adaptation().information().corner() / rate);
        this.keep = 1 - 1 / (settings.memory() * rate);
        this.previous = new double[inputs];
        this.blocked = new double[inputs];
        this.power = new double[inputs];
        this.x = new double[n];
        this.ahead = new double[TERMS];
        this.theta = new double[n];
        this.start = new double[n];
        this.p = new double[n][n];
        this.px = new double[n];
        reset();
    }

    /** As before the first sample. */
    public void reset() {
        Arrays.fill(previous, Double.NaN);
        Arrays.fill(blocked, 0);
        Arrays.fill(power, 0);
        Arrays.fill(x, 0);
        Arrays.fill(theta, 0);
        previousOutput = Double.NaN;
        blockedOutput = 0;
        outputPower = 0;
        noise = 0;
        disturbed = 0;
        measured = 0;
        learning = false;
    }

    /**
     * The part of the next output that the other motions make. Changes nothing.
     *
     * @param others one sample of each, by motion, in its own unit; one that is missing, NaN, counts as the one before it. Not modified.
     * @return in the output's unit; 0 for the first seconds
     */
    public double foresee(double[] others) {
        double sum = 0;
        for (int i = 1; i < inputs && learning; i++) {
            respond(i, blockedNext(i, others[i - 1]), ahead, 0);
            for (int k = 0; k < TERMS; k++) {
                sum += theta[TERMS * i + k] * ahead[k];
            }
        }
        return sum;
    }

    /**
     * Takes the next sample.
     *
     * @param u      the estimator's own input [m/s² or rad/s]; NaN if missing
     * @param others one sample of each, by motion, in its own unit; NaN if missing. Not modified.
     * @param y      output, whole, in the unit of u; NaN if missing
     */
    public void learn(double u, double[] others, double y) {
        if (inputs == 1) {
            return;
        }
        disturbed = Math.max(0, disturbed - 1 / rate);
        for (int i = 0; i < inputs; i++) {
            double sample = i == 0 ? u : others[i - 1];
            blocked[i] = blockedNext(i, sample);
            if (Double.isFinite(sample)) {
                previous[i] = sample;
            } else {
                disturbed = settings.disturbed();
            }
            respond(i, blocked[i], x, TERMS * i);
        }
        if (!Double.isFinite(y)) {
            return;
        }
        blockedOutput = level * (blockedOutput + (Double.isNaN(previousOutput) ? 0 : y - previousOutput));
        previousOutput = y;
        if (disturbed > 0) {
            return;
        }
        if (learning) {
            correct();
        } else {
            measure();
        }
    }

    /** y' = a (y' + u - u₋): first-order high-pass. */
    private double blockedNext(int i, double sample) {
        double rise = Double.isFinite(sample) && !Double.isNaN(previous[i]) ? sample - previous[i] : 0;
        return level * (blocked[i] + rise);
    }

    /**
     * One step of the Laguerre functions of an input: a low-pass, then all-passes.
     *
     * @param to from index at. Modified.
     */
    private void respond(int i, double sample, double[] to, int at) {
        double into = gain * sample;
        double outBefore = 0;
        for (int k = 0; k < TERMS; k++) {
            double before = x[TERMS * i + k];
            double next = k == 0 ? pole * before + into : pole * before + outBefore - pole * into;
            // the all-pass (z⁻¹ - p) / (1 - p z⁻¹) takes its input before and after the step
            outBefore = before;
            into = next;
            to[at + k] = next;
        }
    }

    private void measure() {
        measured++;
        outputPower += (blockedOutput * blockedOutput - outputPower) / measured;
        for (int i = 0; i < inputs; i++) {
            power[i] += (blocked[i] * blocked[i] - power[i]) / measured;
        }
        if (measured < settings.measuring() * rate || !(outputPower > 0)) {
            return;
        }
        learning = true;
        noise = outputPower;
        for (int j = 0; j < n; j++) {
            int i = j / TERMS;
            double scale = power[i] > 0 ? outputPower / power[i] : 0;
            start[j] = scale * (i == 0 ? settings.startOwn() * settings.startOwn() : settings.start() * settings.start());
            Arrays.fill(p[j], 0);
            p[j][j] = start[j];
        }
    }

    /** θ ← a θ, P ← a² P + (1 - a²) P₀, then the correction by ν = y - xᵀθ. */
    private void correct() {
        double variance = 0;
        double said = 0;
        double fresh = 1 - keep * keep;
        for (int r = 0; r < n; r++) {
            theta[r] *= keep;
            double[] row = p[r];
            double sum = 0;
            for (int c = 0; c < n; c++) {
                row[c] *= keep * keep;
                sum += row[c] * x[c];
            }
            row[r] += fresh * start[r];
            px[r] = sum + fresh * start[r] * x[r];
            variance += px[r] * x[r];
            said += theta[r] * x[r];
        }
        double innovation = blockedOutput - said;
        noise += (Math.min(innovation * innovation, settings.largestSurprise() * noise) - noise) / (settings.noiseMemory() * rate);
        double s = variance + noise;
        for (int r = 0; r < n; r++) {
            theta[r] += px[r] / s * innovation;
            double[] row = p[r];
            for (int c = 0; c < n; c++) {
                row[c] -= px[r] * px[c] / s;
            }
        }
    }

    @Override
    public void save(StateWriter out) {
        out.put(previous);
        out.put(blocked);
        out.put(power);
        out.put(x);
        out.put(theta);
        out.put(previousOutput);
        out.put(blockedOutput);
        out.put(outputPower);
        out.put(noise);
        out.put(disturbed);
        out.put(measured);
        out.put(learning);
        if (learning) {
            out.put(start);
            for (int r = 0; r < n; r++) {
                out.put(p[r], 0, r + 1); // symmetric
            }
        }
    }

    @Override
    public void load(StateReader in) {
        in.numbers(previous);
        in.numbers(blocked);
        in.numbers(power);
        in.numbers(x);
        in.numbers(theta);
        previousOutput = in.number();
        blockedOutput = in.number();
        outputPower = in.number();
        noise = in.number();
        disturbed = in.number();
        measured = in.count();
        learning = in.flag();
        if (learning) {
            in.numbers(start);
            for (int r = 0; r < n; r++) {
                in.numbers(p[r], 0, r + 1);
                for (int c = 0; c < r; c++) {
                    p[c][r] = p[r][c];
                }
            }
        }
    }
}

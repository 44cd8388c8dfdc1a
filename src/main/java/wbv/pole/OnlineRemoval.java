package wbv.pole;

import java.io.Serializable;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.filter.BodyEstimate;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/**
 * The whole chain on one stream: while an absent place still has its sensor, windows are identified, their poles gathered and
 * polygons drawn anew now and then; and always the place is predicted as if it had none, by {@link RemovalRun}. A sample of the
 * place is never used for a prediction but through polygons and responses that older windows made. Memory does not grow: the
 * newest windows are kept.
 *
 * <p>One that is serialised and read back goes on as the original would.
 */
public final class OnlineRemoval implements Serializable {

    private static final long serialVersionUID = 1;
    private static final String STREAM = "stream";
    /** Time over which the place's own level, gravity and bias, is taken [s]. */
    private static final double LEVEL = 8;

    private final Layout layout;
    private final PoleWindows windows;
    private final double rate;
    private final int between;
    private final boolean learns;
    private final PoleTraining training;
    private final double[][] ring;
    private final double[] now;
    private RemovalRun run;
    private boolean trained;
    private long samples;
    private int taken;
    private int trainings;
    private double level;

    /**
     * Learns from the stream alone.
     *
     * @param layout  with one absent channel
     * @param rate    [Hz]
     * @param kept    windows kept, &gt;= 1
     * @param between windows from one training to the next, &gt;= 1
     */
    public OnlineRemoval(Layout layout, PoleWindows windows, double rate, int kept, int between) {
        this(layout, windows, rate, kept, between, true);
    }

    /**
     * Follows what was trained elsewhere.
     *
     * @param trained of which the first absent channel is predicted
     * @param rate [Hz]
     */
    public OnlineRemoval(TrainedPoles trained, double rate) {
        this(trained.layout(), trained.windows(), rate, 1, 1, false);
        this.run = new RemovalRun(trained, STREAM, rate);
        this.trained = true;
    }

    private OnlineRemoval(Layout layout, PoleWindows windows, double rate, int kept, int between, boolean learns) {
        if (kept < 1 || between < 1) {
            throw new IllegalArgumentException("windows kept and between trainings must be >= 1: " + kept + ", " + between);
        }
        this.layout = layout;
        this.windows = windows;
        this.rate = rate;
        this.between = between;
        this.learns = learns;
        this.training = new PoleTraining(layout, windows, kept);
        int inputs = layout.inputs().size();
        this.ring = new double[inputs + 2][windows.samples(STREAM, rate, inputs)];
        this.now = new double[inputs];
    }

    /** Base, measured place and absent places. */
    public Layout layout() {
        return layout;
    }

    /**
     * What is foreseen of the absent place in its channel's unit, its own level added, before the sample is taken. Changes nothing.
     *
     * @param u    inputs, one a channel in the layout's order, in its unit. Not modified.
     * @param body whether by the bounded body, or by the response to all inputs
     */
    public double foresee(double[] u, boolean body) {
        // Untrained, a body that follows its base is the least that can be said.
        double motion = !trained ? Double.isFinite(u[0]) ? u[0] : 0 : body ? run.foreseeBody(0, u[0]) : run.foresee(0, u);
        return trained ? motion + level : motion;
    }

    /**
     * Takes a sample.
     *
     * @param u        inputs, one a channel in the layout's order, in its unit; NaN is missing. Not modified.
     * @param measured the measured place, in its channel's unit
     * @param absent   the absent place, in its channel's unit, as long as it has a sensor, then NaN
     */
    public void step(double[] u, double measured, double absent) {
        int length = ring[0].length;
        if (learns && samples >= length && (samples - length) % windows.hopSamples(rate) == 0) {
            learn();
        }
        int at = (int) (samples % length);
        for (int i = 0; i < u.length; i++) {
            ring[i][at] = u[i];
        }
        ring[u.length][at] = measured;
        ring[u.length + 1][at] = absent;
        if (trained) {
            run.step(u, measured);
        }
        if (Double.isFinite(absent)) {
            level += (absent - level) / Math.min(samples + 1, LEVEL * rate);
        }
        samples++;
    }

    private double[] channel(int row) {
        int length = ring[0].length;
        int from = (int) (samples % length);
        double[] out = new double[length];
        System.arraycopy(ring[row], from, out, 0, length - from);
        System.arraycopy(ring[row], 0, out, length - from, from);
        return out;
    }

    private void learn() {
        int inputs = now.length;
        double[][] u = new double[inputs][];
        for (int i = 0; i < inputs; i++) {
            u[i] = PoleWindows.bridged(channel(i));
        }
        Map<Channel, double[]> outputs = new LinkedHashMap<>();
        outputs.put(layout.measured(), PoleWindows.bridged(channel(inputs)));
        outputs.put(layout.absent().get(0), PoleWindows.bridged(channel(inputs + 1)));
        if (training.take(STREAM, rate, u, outputs) && ++taken % between == 0) {
            train();
        }
    }

    private void train() {
        TrainedPoles found;
        try {
            found = training.finish().trained();
        } catch (DataFault tooLittle) {
            return; // poles that do not gather yet; the next windows may
        }
        trainings++;
        trained = true;
        run = new RemovalRun(found, STREAM, rate);
        // What has just passed brings the new bodies into motion.
        int length = ring[0].length;
        for (int k = 0; k < length; k++) {
            int at = (int) ((samples + k) % length);
            for (int i = 0; i < now.length; i++) {
                now[i] = ring[i][at];
            }
            run.step(now, ring[now.length][at]);
        }
    }

    /** Whether there are polygons. */
    public boolean trained() {
        return trained;
    }

    /** Windows that were learned from. */
    public int windows() {
        return taken;
    }

    /** Times that polygons were drawn. */
    public int trainings() {
        return trainings;
    }

    /** Windows since the last training in which no pole of the main cluster was found; 0 before the first. */
    public int lost() {
        return trained ? run.lost() : 0;
    }

    /** Natural frequency [Hz] of the measured place's pole; NaN before the first training. */
    public double poleFrequency() {
        return trained ? run.pole().frequency() : Double.NaN;
    }

    /** Its damping ratio [1]. */
    public double poleDamping() {
        return trained ? run.pole().damping() : Double.NaN;
    }

    /** Bounds of the absent body in the order of {@link Attributes#OF_A_BODY}; empty before the first training. */
    public List<Chord> bounds() {
        return trained ? run.bounds(0) : List.of();
    }

    /** Natural frequency [Hz] of the absent place's body within its bounds; NaN before the first training. */
    public double bodyFrequency() {
        return trained ? body().frequency() : Double.NaN;
    }

    /** Its damping ratio [1]. */
    public double bodyDamping() {
        return trained ? body().damping() : Double.NaN;
    }

    private BodyEstimate body() {
        return run.body(0);
    }
}

package wbv.pole;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.drift.Alarm;
import wbv.filter.model.Spec;
import wbv.identify.Pole;
import wbv.identify.SkyhookBody;
import wbv.identify.TransferRun;
import wbv.identify.TunedResponse;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/**
 * Places without sensors, sample by sample: from the base and the measured place alone, the motion of the absent places and their
 * bodies within the polygons' bounds. Memory does not grow.
 *
 * <p>Every hop the window that has just passed is identified; its pole in the main cluster tunes the trained responses and cuts
 * the polygons. Nothing later than a sample is used for it. Until the first window is whole, the trained population's median
 * stands in; while no pole of the cluster is found, the last one holds, and is counted. One that is serialised and read back goes
 * on as the original would.
 */
public final class RemovalRun implements Serializable {

    private static final long serialVersionUID = 1;
    private static final double STEADY = 0.5;
    /** Below which motion counts as gravity and bias [Hz]. */
    private static final double LEVEL_CORNER = 0.02;
    /** Missing samples for which an input is held. */
    private static final int LONGEST_HOLD = 5;

    private final TrainedPoles trained;
    private final double rate;
    private final int inputs;
    private final int hop;
    private final double[][] ring;
    private final Place[] places;
    private final double[] level;
    private final double[] held;
    private final int[] missing;
    private final double[] now;
    private final double[] ahead;
    private final double forget;
    private Pole pole;
    private long samples;
    private int seen;
    private int lost;
    private boolean fresh;

    /** An absent place. */
    private static final class Place implements Serializable {
        private static final long serialVersionUID = 1;
        private final Channel channel;
        private final TransferRun response;
        private final ChordBounds bounds;
        private final Estimator body;
        private List<Chord> chords;
        private double said;

        Place(Channel channel, TransferRun response, List<Chord> chords, ChordBounds bounds, Estimator body) {
            this.channel = channel;
            this.response = response;
            this.chords = chords;
            this.bounds = bounds;
            this.body = body;
        }
    }

    /** Hears nothing: an estimator without an output has no innovations. */
    private enum Deaf implements Alarm {
        DEAF;

        @Override
        public boolean feed(double value) {
            return false;
        }

        @Override
        public long width() {
            return 0;
        }

        @Override
        public double mean() {
            return 0;
        }

        @Override
        public void reset() {}
    }

    /**
     * A run from the trained population's median.
     *
     * @param name of the recording or stream, for messages
     * @param rate [Hz]
     * @throws DataFault if a window at this rate is too short for its poles, or the polygons are no sitter's
     */
    public RemovalRun(TrainedPoles trained, String name, double rate) {
        this.trained = trained;
        this.rate = rate;
        this.inputs = trained.layout().inputs().size();
        this.hop = trained.windows().hopSamples(rate);
        this.ring = new double[inputs + 1][trained.windows().samples(name, rate, inputs)];
        this.level = new double[inputs];
        this.held = new double[inputs];
        this.missing = new int[inputs];
        Arrays.fill(missing, LONGEST_HOLD);
        this.now = new double[inputs];
        this.ahead = new double[inputs];
        this.forget = 2 * Math.PI * LEVEL_CORNER / rate;
        this.pole = trained.typical();
        this.places = trained.layout().absent().stream().map(this::place).toArray(Place[]::new);
    }

    private Place place(Channel absent) {
        SkyhookBody start = trained.bodies().get(absent);
        List<Chord> chords = chords(absent);
        ChordBounds bounds = new ChordBounds(chords);
        Estimator body = EstimatorDesign.of(Method.CONSTRAINED).within(bounds).withSkyhook()
                .estimator(Spec.at(rate).startingAt(start.frequency(), start.damping()), () -> Deaf.DEAF);
        return new Place(absent, new TransferRun(trained.responses().get(absent).at(2 * Math.PI * pole.frequency()), rate), chords,
                bounds, body);
    }

    private List<Chord> chords(Channel absent) {
        return Attributes.OF_A_BODY.stream().map(attribute -> trained.chord(absent, pole, attribute)).toList();
    }

    /**
     * Takes the next sample of every input, in the layout's order, and of the measured place; NaN is missing.
     *
     * @param u one a channel, in its unit. Not modified.
     * @param measured in its channel's unit
     */
    public void step(double[] u, double measured) {
        fresh = false;
        int length = ring[0].length;
        if (samples >= length && (samples - length) % hop == 0) {
            identify();
        }
        boolean first = samples == 0;
        for (int i = 0; i < inputs; i++) {
            ring[i][(int) (samples % length)] = u[i];
            if (Double.isFinite(u[i])) {
                // A constant is gravity or bias.
                level[i] = first ? u[i] : level[i] + forget * (u[i] - level[i]);
                held[i] = u[i] - level[i];
                missing[i] = 0;
            } else {
                missing[i]++;
            }
            now[i] = missing[i] > LONGEST_HOLD ? 0 : held[i];
        }
        ring[inputs][(int) (samples % length)] = measured;
        for (Place place : places) {
            place.said = place.response.step(now);
            // At rest both sensors read the same; after that the absent one says nothing.
            place.body.step(u[0], first ? u[0] : Double.NaN);
        }
        samples++;
    }

    private void identify() {
        int length = ring[0].length;
        double[][] window = new double[inputs + 1][length];
        int from = (int) (samples % length);
        for (int i = 0; i <= inputs; i++) {
            System.arraycopy(ring[i], from, window[i], 0, length - from);
            System.arraycopy(ring[i], 0, window[i], length - from, from);
            window[i] = PoleWindows.bridged(window[i]);
        }
        Optional<Pole> found = trained.windows().window(Arrays.copyOf(window, inputs), window[inputs], 0, length, rate)
                .flatMap(trained::mainOf);
        if (found.isEmpty()) {
            lost++;
            return;
        }
        double before = 2 * Math.PI * pole.frequency();
        pole = seen == 0 ? found.get() : smoothed(pole, found.get());
        double after = 2 * Math.PI * pole.frequency();
        for (Place place : places) {
            TunedResponse response = trained.responses().get(place.channel);
            place.response.retune(response.at(after), response.pulsation(after) / response.pulsation(before));
            place.chords = chords(place.channel);
            place.bounds.see(place.chords);
        }
        seen++;
        fresh = true;
    }

    private static Pole smoothed(Pole before, Pole now) {
        return new Pole(before.re() + STEADY * (now.re() - before.re()), before.im() + STEADY * (now.im() - before.im()));
    }

    /** Samples taken. */
    public long samples() {
        return samples;
    }

    /** Windows whose pole was found. */
    public int seen() {
        return seen;
    }

    /** Windows in which no pole of the cluster was found, or a sample was missing. */
    public int lost() {
        return lost;
    }

    /** Whether the last sample came with a new pole. */
    public boolean fresh() {
        return fresh;
    }

    /** Pole of the measured place as last known. */
    public Pole pole() {
        return pole;
    }

    /**
     * Bounds of an absent body, in the order of {@link Attributes#OF_A_BODY}.
     *
     * @param absent number of the channel in the layout
     */
    public List<Chord> bounds(int absent) {
        return places[absent].chords;
    }

    /** Bounds of all absent bodies. */
    Map<Channel, List<Chord>> bounds() {
        Map<Channel, List<Chord>> bounds = new LinkedHashMap<>();
        for (Place place : places) {
            bounds.put(place.channel, new ArrayList<>(place.chords));
        }
        return bounds;
    }

    /** Motion of an absent place at the last sample [m/s²], by the trained response to all inputs at the pole measured. */
    public double motion(int absent) {
        return places[absent].said;
    }

    /** What the constrained estimator knows of an absent body; its prediction is that body's motion [m/s²]. */
    public BodyEstimate body(int absent) {
        return places[absent].body.track();
    }

    /**
     * {@link #motion} that goes with the next sample, in its channel's unit. Changes nothing.
     *
     * @param u one a channel, in its unit. Not modified.
     */
    public double foresee(int absent, double[] u) {
        for (int i = 0; i < inputs; i++) {
            double change = Double.isFinite(u[i]) ? u[i] - level[i] : 0;
            ahead[i] = Double.isFinite(u[i]) ? samples == 0 ? 0 : (1 - forget) * change : missing[i] >= LONGEST_HOLD ? 0 : held[i];
        }
        return places[absent].response.foresee(ahead);
    }

    /**
     * The constrained body's motion that goes with the next sample [m/s²]. Changes nothing.
     *
     * @param u of the base [m/s²]; NaN if missing
     */
    public double foreseeBody(int absent, double u) {
        return places[absent].body.predict(u);
    }
}

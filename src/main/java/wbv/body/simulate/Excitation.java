package wbv.body.simulate;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import wbv.body.Model;
import wbv.body.Row;
import wbv.body.SensorFilter;
import wbv.body.Spectra;
import wbv.body.Structure;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Leaps;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.signal.LostSamples;
import wbv.signal.RealDft;

/**
 * The input of a simulation: the base's acceleration and the channels that may act beside it, as spectra over a record padded
 * with silence, so that what rings at the end does not come back at the start. A {@link Stroke} where links are driven.
 *
 * <p>A spectrum has K lines, {@code f_k = k rate / padded} below 45 % of the rate: real part at 2k, imaginary part at 2k + 1.
 */
public final class Excitation {

    private static final double BAND = 0.45;
    private static final double SILENCE = 4;
    /**
     * Time without samples after which nothing is known of what a structure has done meanwhile [s]: half the silence in which all that is
     * held has rung out, which lies between two recordings, and more than drops out of a stream.
     */
    public static final double PAUSE = SILENCE / 2;

    private static final double FINE_RATE = 240;
    /** Points between samples beyond which the recording is too slow for any body to be seen in it: below 1 Hz. */
    private static final int MOST_OVERSAMPLING = 256;
    /** Points of the longest transform: half a gigabyte of numbers. */
    private static final int MOST_POINTS = 1 << 26;
    private static final int FORCED = 4;
    private static final double NEARLY_STEADY = 1e-3;

    private final double rate;
    private final int samples;
    private final int padded;
    private final int oversampling;
    private final double[] omega;
    private final Grid coarse;
    private final Grid fine;
    /** Spectrum of the base's acceleration, by axis. */
    private final double[][] base;
    private final Map<Channel, double[]> others;
    private final double[] rollOff;
    private final Optional<Stroke> stroke;
    private final boolean unit;
    private final Leaps leaps;
    /** Forces on bodies beside it [N], spectra by body: in their order, since sums in another differ by rounding. */
    private final SortedMap<Integer, double[]> pushes;
    private final SolvedLines solved;
    private final boolean forced;
    /**
     * Spectrum of the straight line and the mean of the base's measured position, which have no acceleration; empty where acceleration or
     * velocity was measured.
     */
    private final double[][] track;
    /** The channels as they were recorded. Not modified. */
    private final Map<Channel, double[]> recorded;
    /** Worked out when first asked for. */
    private double[][] fineBase = new double[0][];
    private Optional<Grid> products = Optional.empty();

    /**
     * The base's motion along one axis.
     *
     * @param rate   samples per second [Hz]
     * @param base   acceleration of the base by sample [m/s²], finite. Not modified.
     * @param others further channels by name, as long as the base, finite. Not modified.
     */
    public Excitation(double rate, double[] base, Map<Channel, double[]> others) {
        this(rate, new double[][] {base}, others);
    }

    /**
     * A base that moves along several axes.
     *
     * @param rate samples per second [Hz]
     * @param base its accelerations [m/s²], by axis and sample; about an axis [rad/s²]; finite. Not modified.
     * @param others likewise
     */
    public Excitation(double rate, double[][] base, Map<Channel, double[]> others) {
        this(rate, base, others, Optional.empty(), Math.max(2, finer(rate)), Optional.empty(), false);
    }

    private static int finer(double rate) {
        return Integer.highestOneBit((int) Math.ceil(FINE_RATE / rate) * 2 - 1);
    }

    private Excitation(double rate, double[][] base, Map<Channel, double[]> others, Optional<SensorFilter> filter, int oversampling,
            Optional<Stroke> stroke, boolean forced) {
        this.rate = rate;
        this.samples = base[0].length;
        double wanted = (samples + SILENCE * rate) * oversampling;
        if (oversampling > MOST_OVERSAMPLING || wanted > MOST_POINTS) {
            throw new DataFault(String.format(Locale.ROOT, "%d samples at %.3g Hz are too %s to run a model on", samples, rate,
                    oversampling > MOST_OVERSAMPLING ? "slow" : "many"));
        }
        this.padded = RealDft.covering((int) (samples + SILENCE * rate));
        this.oversampling = oversampling;
        this.stroke = stroke;
        this.unit = false;
        this.leaps = Leaps.NONE;
        this.pushes = Collections.emptySortedMap();
        this.solved = new SolvedLines();
        this.forced = forced;
        this.track = new double[base.length][0];
        this.recorded = Map.copyOf(others);
        int lines = (int) Math.floor(BAND * padded);
        this.coarse = new Grid(padded, samples, lines, 1);
        this.fine = new Grid(padded, samples, lines, oversampling);
        omega = new double[lines];
        for (int k = 0; k < lines; k++) {
            omega[k] = 2 * Math.PI * k * rate / padded;
        }
        // Not quite 0, so that a body that only a dashpot holds has a steady velocity there.
        omega[0] = NEARLY_STEADY * 2 * Math.PI * rate / padded;
        this.base = Arrays.stream(base).map(this::spectrum).toArray(double[][]::new);
        this.others = new java.util.HashMap<>();
        others.forEach((channel, values) -> this.others.put(channel, spectrum(values)));
        rollOff = new double[lines];
        for (int k = 0; k < lines; k++) {
            double relative = (double) k / padded;
            rollOff[k] = filter.map(f -> f.at(relative)).orElse(1.0);
        }
    }

    /**
     * Forces on bodies over a base at rest, with a finer free run than a base needs, since forces are held linear between samples.
     *
     * @param rate samples per second [Hz]
     * @param forces by channel, all of one length, finite. Not modified.
     */
    public static Excitation ofForces(double rate, int samples, Map<Channel, double[]> forces) {
        return new Excitation(rate, new double[1][samples], forces, Optional.empty(), Math.max(FORCED, finer(rate)), Optional.empty(),
                true);
    }

    /**
     * A measured stroke that drives links.
     *
     * @param rate samples per second [Hz]
     * @param others further channels by name. Not modified.
     */
    public static Excitation ofStroke(double rate, Stroke stroke, Map<Channel, double[]> others) {
        return new Excitation(rate, new double[1][stroke.position().length], others, Optional.empty(), 1, Optional.of(stroke), false);
    }

    /**
     * The input that a recording holds for a model: its base's acceleration, lost samples filled, mean removed, and every other channel; a
     * measured force is at its mean in pauses. Past the filter of the sensors that {@link RollOff#of} finds in all of the recording: for
     * comparing with what they recorded. A base's velocity or position is turned into its acceleration; measured forces leave the base at
     * rest.
     *
     * @param samples how much of the recording, from its start
     * @throws DataFault if neither the model's base has a sensor nor a body a measured force, or the recording lacks it
     */
    public static Excitation of(Model model, Recording recording, int samples) {
        return uniform(model, recording, samples, RollOff.of(model, recording)).leaping(recording.leaps());
    }

    /**
     * The same past no filter but the one that the model declares: what comes of it goes by the model and the channels that it takes,
     * whatever else was recorded.
     *
     * @param samples how much of the recording, from its start
     * @throws DataFault likewise
     */
    public static Excitation asDeclared(Model model, Recording recording, int samples) {
        return uniform(model, recording, samples, model.base().filter()).leaping(recording.leaps());
    }

    /** On a clock that never leaps. */
    private static Excitation uniform(Model model, Recording recording, int samples, Optional<SensorFilter> filter) {
        double rate = recording.clock().rate();
        Map<Channel, double[]> others = new java.util.HashMap<>();
        for (Channel channel : recording.channels()) {
            boolean pushes = model.inputs().stream().anyMatch(input -> input.sensor().equals(channel));
            others.put(channel, Arrays.copyOf(pushes ? LostSamples.resting(recording.values(channel), (int) (PAUSE * rate))
                    : LostSamples.filled(recording.values(channel)), samples));
        }
        if (!model.inputs().isEmpty()) {
            return ofForces(rate, samples, others);
        }
        Channel input = model.base().sensor().orElseThrow(() -> new DataFault("the model's base '" + model.base().name()
                + "' has no sensor and no body a measured force ('inputs'); name the channel that measures the excitation"));
        if (model.driven()) {
            return ofStroke(rate, Stroke.of(model, recording, input, samples), others);
        }
        Excitation still = new Excitation(rate, new double[samples], Map.of());
        List<Moved> moved = model.base().sensors().stream().map(sensor -> still.moved(recording, sensor, sensor.equals(input))).toList();
        Excitation plain = new Excitation(rate, new double[moved.size()][samples], others, filter, Math.max(2, finer(rate)),
                Optional.empty(), false);
        return new Excitation(plain, moved.stream().map(Moved::acceleration).toArray(double[][]::new),
                moved.stream().map(Moved::track).toArray(double[][]::new), plain.others, plain.recorded, false, Leaps.NONE,
                Collections.emptySortedMap());
    }

    private Excitation leaping(Leaps ahead) {
        return ahead.all().isEmpty() ? this : new Excitation(this, base, track, others, recorded, unit, ahead, pushes);
    }

    /**
     * How the base moves along an axis.
     *
     * @param acceleration its spectrum
     * @param track see {@link Excitation#track}
     */
    private record Moved(double[] acceleration, double[] track) {}

    /**
     * What a sensor says of the base's motion, as long as this: lost samples filled, the mean of an acceleration removed. Along further
     * axes, whose rates and angles other sensors read too, what integrates back to what was read: with a smooth return in the silence.
     */
    private Moved moved(Recording recording, Channel sensor, boolean first) {
        double[] moved = LostSamples.filled(recording.values(sensor));
        if (sensor.quantity() != Quantity.ACCELERATION) {
            return first ? derived(Arrays.copyOf(moved, samples), sensor.quantity())
                    : new Moved(differentiated(returning(moved), order(sensor.quantity())), new double[0]);
        }
        double mean = LostSamples.mean(recording.values(sensor));
        return new Moved(spectrum(Arrays.stream(moved, 0, samples).map(value -> value - mean).toArray()), new double[0]);
    }

    /**
     * Acceleration from velocity or position, spectrally. The straight line between the ends goes first, which has no acceleration, so that
     * no jump is left there; where positions are read it comes back.
     */
    private Moved derived(double[] moved, Quantity quantity) {
        int last = moved.length - 1;
        double[] line = new double[moved.length];
        double[] levelled = new double[moved.length];
        for (int i = 0; i <= last; i++) {
            line[i] = moved[0] + (moved[last] - moved[0]) * i / Math.max(1, last);
            levelled[i] = moved[i] - line[i];
        }
        int order = order(quantity);
        double[] track = order == 2 ? spectrum(line) : new double[0];
        if (order == 2) {
            track[0] += spectrum(levelled)[0];   // nor has its mean
        }
        return new Moved(differentiated(levelled, order), track);
    }

    /**
     * How often what a sensor of a base reads is differentiated to be an acceleration.
     *
     * @throws DataFault if it tells no acceleration
     */
    public static int order(Quantity quantity) {
        return switch (quantity) {
            case ACCELERATION -> 0;
            case VELOCITY, ANGULAR_RATE -> 1;
            case POSITION, ANGLE -> 2;
            default -> throw new DataFault("a base's sensor reads acc, vel, pos, gyr or ang: " + quantity.symbol());
        };
    }

    /**
     * Spectrum of a series' derivative.
     *
     * @param order 1 or 2
     */
    private double[] differentiated(double[] series, int order) {
        double[] x = spectrum(series);
        for (int times = 0; times < order; times++) {
            x = Spectra.timesJOmega(omega, x);
        }
        return x;
    }

    /** A record that goes back in the silence from its last value to its first, so that it repeats without a jump. */
    private double[] returning(double[] moved) {
        double[] out = Arrays.copyOf(moved, padded);
        double first = moved[0];
        double last = moved[samples - 1];
        for (int i = samples; i < padded; i++) {
            double u = (i - samples + 1.0) / (padded - samples + 1);
            out[i] = last + (first - last) * u * u * u * (10 + u * (6 * u - 15));
        }
        return out;
    }

    private Excitation(Excitation like, double[][] base, double[][] track, Map<Channel, double[]> others, Map<Channel, double[]> recorded,
            boolean unit, Leaps leaps, SortedMap<Integer, double[]> pushes) {
        rate = like.rate;
        samples = like.samples;
        padded = like.padded;
        oversampling = like.oversampling;
        omega = like.omega;
        coarse = like.coarse;
        fine = like.fine;
        rollOff = like.rollOff;
        stroke = like.stroke;
        this.base = base;
        this.others = others;
        this.recorded = recorded;
        this.track = track;
        this.unit = unit;
        this.leaps = leaps;
        this.pushes = pushes;
        solved = like.solved;
        forced = like.forced;
    }

    /**
     * The same with a force on a body beside it, and beside one that is there already.
     *
     * @param force [N], by sample, as long as this or longer. Not modified.
     */
    public Excitation pushed(int body, double[] force) {
        SortedMap<Integer, double[]> all = new TreeMap<>(pushes);
        all.merge(body, spectrum(Arrays.copyOf(force, samples)), (there, more) -> {
            Spectra.add(more, there, 1);
            return more;
        });
        return new Excitation(this, base, track, others, recorded, unit, leaps, Collections.unmodifiableSortedMap(all));
    }

    /**
     * The same with the forces on bodies that act beside another.
     *
     * @param all of which this is a stretch
     * @param from its first sample there
     */
    public Excitation pushedAs(Excitation all, int from) {
        Excitation out = this;
        for (Map.Entry<Integer, double[]> push : all.pushes.entrySet()) {
            out = out.pushed(push.getKey(), Arrays.copyOfRange(all.series(push.getValue()), from, from + samples));
        }
        return out;
    }

    /** Whether there is such a force. */
    public boolean isPushed() {
        return !pushes.isEmpty();
    }

    /** Forces on bodies beside it [N], spectra by body. Not copies. */
    SortedMap<Integer, double[]> pushes() {
        return pushes;
    }

    /** The same lines with a base of 1 at each along its first axis: what answers is a frequency response. */
    public Excitation unit() {
        return unit(0);
    }

    /** The same along another axis. */
    public Excitation unit(int axis) {
        double[][] ones = new double[base.length][2 * omega.length];
        for (int k = 0; k < omega.length; k++) {
            ones[axis][2 * k] = 1;
        }
        return new Excitation(this, ones, new double[base.length][0], Map.of(), Map.of(), true, leaps,
                Collections.emptySortedMap());
    }

    /** The measured motion of the base where links are driven by it. */
    public Optional<Stroke> stroke() {
        return stroke;
    }

    /** Whether it is 1 at every line, so that what answers is a frequency response and no motion. */
    boolean isUnit() {
        return unit;
    }

    /** Samples per second [Hz]. */
    public double rate() {
        return rate;
    }

    /** Whether measured forces drive a model over a base at rest: then a body may be free, and what jumps counts. */
    boolean isForced() {
        return forced;
    }

    /** Samples of the record with the silence. */
    int padded() {
        return padded;
    }

    /** Samples of the record, without the silence. */
    public int samples() {
        return samples;
    }

    /** Angular frequency by line [rad/s]. Not a copy. */
    public double[] omega() {
        return omega;
    }

    /** Time between the samples of the free run [s]. */
    public double fineStep() {
        return 1 / (rate * oversampling);
    }

    /** How much later a sample of the free run was taken than its number says [s], see {@link Recording#leaps}. */
    double later(int fine) {
        return leaps.later(fine / oversampling);
    }

    /** Samples of the free run. */
    public int fineSamples() {
        return samples * oversampling;
    }

    /** What was solved at these lines of late. */
    SolvedLines solved() {
        return solved;
    }

    /** Spectrum of the base's acceleration along its first axis [m/s²]. Not a copy. */
    public double[] baseSpectrum() {
        return base[0];
    }

    /** Spectrum of the base's acceleration along an axis [m/s²]; nothing along one that nothing measures. Not a copy. */
    public double[] base(int axis) {
        return base[axis];
    }

    /**
     * The relative acceleration that stretches a link [m/s²], a new spectrum.
     *
     * @param absolute acceleration of each body [m/s²], as spectra. Not modified.
     */
    public double[] stretching(Structure structure, int link, double[][] absolute) {
        Row row = structure.stretch(link);
        double[] out = row.of(absolute, 2 * omega.length);
        for (int axis = 0; axis < base.length; axis++) {
            double carried = structure.kinematics().carried(row, axis);
            if (carried != 0) {
                Spectra.add(out, base[axis], -carried);
            }
        }
        return out;
    }

    /** Spectrum of what of the base's position along an axis its acceleration does not hold. Not a copy. */
    double[] track(int axis) {
        return track[axis];
    }

    /**
     * A channel as it was recorded, straight between its samples, at the free run's rate. A new array.
     *
     * @throws DataFault if the recording has no such channel
     */
    double[] level(Channel channel) {
        double[] values = Optional.ofNullable(recorded.get(channel)).orElseThrow(() -> lacks(channel));
        double[] out = new double[fineSamples()];
        for (int i = 0; i < out.length; i++) {
            int at = Math.min(i / oversampling, samples - 1);
            double share = (double) (i % oversampling) / oversampling;
            out[i] = values[at] + share * (values[Math.min(at + 1, samples - 1)] - values[at]);
        }
        return out;
    }

    private static DataFault lacks(Channel channel) {
        return new DataFault("the model needs the channel " + channel + ", which the recording lacks");
    }

    /**
     * Spectrum of another channel. Not a copy.
     *
     * @throws DataFault if the recording has no such channel
     */
    double[] other(Channel channel) {
        double[] found = others.get(channel);
        if (found == null) {
            throw lacks(channel);
        }
        return found;
    }

    /**
     * Spectrum of a series at the recording's rate, in the series' unit.
     *
     * @param series of any unit. Not modified.
     */
    public double[] spectrum(double[] series) {
        return coarse.spectrum(series);
    }

    /**
     * Spectrum of a series at the free run's rate, in the series' unit.
     *
     * @param series of any unit. Not modified.
     */
    public double[] spectrumOfFine(double[] series) {
        return fine.spectrum(series);
    }

    /**
     * Spectrum of a force at the free run's rate, past the sensors' anti-alias filter.
     *
     * @param series Not modified.
     */
    double[] spectrumOfForce(double[] series) {
        return filtered(spectrumOfFine(series));
    }

    /**
     * A spectrum past the sensors' anti-alias filter.
     *
     * @param spectrum Modified.
     */
    double[] filtered(double[] spectrum) {
        for (int i = 0; i < spectrum.length; i++) {
            spectrum[i] *= rollOff[i / 2];
        }
        return spectrum;
    }

    /**
     * The series at the recording's rate, {@link #samples} long, in the spectrum's unit.
     *
     * @param spectrum of any unit. Not modified.
     */
    public double[] series(double[] spectrum) {
        return coarse.series(spectrum);
    }

    /**
     * The series at the free run's rate, record only, in the spectrum's unit.
     *
     * @param spectrum of any unit. Not modified.
     */
    public double[] fineSeries(double[] spectrum) {
        return fine.series(spectrum);
    }

    /** Twice the record's rate, where products of two motions are what they are in its band: no line of theirs folds back into it. */
    synchronized Grid products() {
        if (products.isEmpty()) {
            products = Optional.of(new Grid(padded, samples, omega.length, Math.min(2, oversampling)));
        }
        return products.get();
    }

    /** The base for the free run, by axis. Not a copy. */
    synchronized double[][] fineBase() {
        if (fineBase.length == 0) {
            fineBase = Arrays.stream(base).map(this::held).toArray(double[][]::new);
        }
        return fineBase;
    }

    /**
     * A spectrum of any unit as a series in that unit for the free run: raised by what the first-order hold takes away, (x / sin x)². Not
     * modified.
     */
    public double[] held(double[] spectrum) {
        double[] raised = spectrum.clone();
        for (int k = 1; k < omega.length; k++) {
            double x = omega[k] * fineStep() / 2;
            double gain = x / Math.sin(x);
            raised[2 * k] *= gain * gain;
            raised[2 * k + 1] *= gain * gain;
        }
        return fineSeries(raised);
    }
}

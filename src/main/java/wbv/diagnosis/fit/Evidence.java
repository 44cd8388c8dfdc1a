package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Library;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/** What models are judged by: a recording as they see it, two windows, one to fit and one to prove, and what counts as noise. */
public final class Evidence {

    /** Time from the start in which motion is still that of what was before [s], and part of a short record that it is at most. */
    public static final double SETTLING = 2;
    /** The most of a record that this may take, as a share of its length. */
    public static final double SETTLING_SHARE = 0.05;
    private static final double END = 0.6;
    /** Part of an output that must count. */
    private static final double LEAST_VALID = 0.25;
    private static final double BRIEF = 36;
    private static final double WORTH_A_PART = 1.6;

    private final Measured measured;
    private final Excitation excitation;
    private final Window fit;
    private final Window heldOut;
    private final Optional<BodyForce> bodyForce;
    private final List<Place> ignored;
    private final Library library;
    private final Map<Channel, Double> heard;
    private final Known known = new Known();

    /** With the sensors' noise as the recording shows it. */
    public Evidence(Model model, Recording recording) {
        this(model, recording, OptionalDouble.empty());
    }

    /**
     * Evidence of which the last part is held out.
     *
     * @param stated standard deviation of a sample of every sensor of the outputs' kind, in its unit
     */
    public Evidence(Model model, Recording recording, OptionalDouble stated) {
        this(model, recording, stated, OptionalDouble.empty());
    }

    /**
     * The same, held out from a moment that is given.
     *
     * @param provedFrom see {@link wbv.diagnosis.Question#provedFrom}
     */
    public Evidence(Model model, Recording recording, OptionalDouble stated, OptionalDouble provedFrom) {
        this(model, recording, stated, false, provedFrom);
    }

    /**
     * What another model makes of the input.
     *
     * @param stated as for what was measured
     */
    public static Evidence computed(Model model, Recording simulation, OptionalDouble stated) {
        return new Evidence(model, simulation, stated, true, OptionalDouble.empty());
    }

    private Evidence(Model model, Recording recording, OptionalDouble stated, boolean computed, OptionalDouble provedFrom) {
        measured = new Measured(model, recording, stated, computed, provedFrom);
        double rate = recording().clock().rate();
        int n = recording().length();
        int start = model.driven() ? 0 : (int) Math.round(onRig() ? Math.min(SETTLING * rate, SETTLING_SHARE * n) : SETTLING * rate);
        int split = measured.split();
        // Fits need the record up to their window's end and no more: half the lines, half the time.
        excitation = Excitation.of(model, recording(), Math.min(n, split + (int) rate));
        fit = onRig() ? new Window(start, split - start, rate, 0) : new Window(start, split - start, rate);
        int proof = measured.isChosen() ? split + start : split;   // another ride begins with what nobody saw before it
        heldOut = onRig() ? new Window(proof, n - proof, rate, 0) : new Window(proof, n - proof - (int) (END * rate), rate);
        bodyForce = Optional.empty();
        ignored = List.of();
        library = Library.standard();
        heard = Map.of();
        if (!onRig()) {
            counts(fit, "fit");
            counts(heldOut, "prove anything on");
        }
    }

    private void counts(Window window, String what) {
        double rate = recording().clock().rate();
        for (int o = 0; o < outputs().size(); o++) {
            boolean[] valid = valid(o);
            long counted = IntStream.range(window.start(), window.start() + window.length()).filter(i -> valid[i]).count();
            if (counted < LEAST_VALID * window.length()) {
                throw new DataFault(String.format(Locale.ROOT,
                        "between %.4g and %.4g s only %.0f %% of %s counts, the rest is lost there or in the input: "
                                + "too little to %s; cut the recording, or take the sensor out of the model",
                        window.start() / rate,
                        (window.start() + window.length()) / rate, 100.0 * counted / window.length(), outputs().get(o), what));
            }
        }
    }

    private Evidence(Measured measured, Excitation excitation, Window fit, Window heldOut, Optional<BodyForce> bodyForce,
            List<Place> ignored, Library library, Map<Channel, Double> heard) {
        this.measured = measured;
        this.excitation = excitation;
        this.fit = fit;
        this.heldOut = heldOut;
        this.bodyForce = bodyForce;
        this.ignored = List.copyOf(ignored);
        this.library = library;
        this.heard = Map.copyOf(heard);
    }

    /** The user's. */
    public Model model() {
        return measured.model();
    }

    /**
     * Whether the model is of a test rig, see {@link Model#subject}: then constants count, no band is known to be free of excitation, and
     * no person's own force acts.
     */
    public boolean onRig() {
        return measured.onRig();
    }

    /** Whether the model stands for a simulation that gave more than it does. */
    public boolean standsForSimulation() {
        return Stream.concat(model().bodies().stream().map(Model.Body::faults), model().sensors().stream().map(Model.Sensor::faults))
                .flatMap(List::stream)
                .anyMatch(SensorFault.Beside.class::isInstance);
    }

    /** Whether no sensor measured it, so that none can be wrong by a little. */
    boolean isComputed() {
        return measured.computed();
    }

    /** What is judged by: a fast one of a sitter brought to about 60 Hz, any other as it was read. */
    public Recording recording() {
        return measured.recording();
    }

    /** Channels of the model's sensors, in the order in which all arrays by output have them. */
    public List<Channel> outputs() {
        return measured.outputs();
    }

    /** The input up to the end of the fit's window. */
    public Excitation excitation() {
        return excitation;
    }

    /** The whole input. */
    public Excitation whole() {
        return measured.input();
    }

    /** The series of a channel with its gaps bridged, in its unit. Not a copy. */
    public double[] series(Channel channel) {
        return Excitation.bridged(recording().values(channel));
    }

    /** The series that was measured at an output, mean removed, gaps filled, in its unit. Not a copy. */
    public double[] measured(int output) {
        return measured.series(output);
    }

    /** What was removed of {@link #measured}, in the channel's unit. */
    public double mean(int output) {
        return measured.mean(output);
    }

    /** Samples of an output that count. Not a copy. */
    public boolean[] valid(int output) {
        return measured.valid(output);
    }

    /** Samples in which the whole sensor of an output repeats itself or reads zero. */
    public int repeated(int output) {
        return measured.repeated(output);
    }

    /** Time between two samples as they were recorded [s], see {@link Measured#sample}. */
    public double sample() {
        return measured.sample();
    }

    /** Standard deviation of a sample of the input, in its unit. */
    public double inputNoise() {
        return measured.inputNoise();
    }

    /** See {@link Measured#inputNoises}. */
    List<Measured.InputNoise> inputNoises() {
        return measured.inputNoises();
    }

    /** Standard deviation of a sample, by output, in its unit. Not a copy. */
    public double[] noise() {
        return measured.noise();
    }

    /** Acceleration channels of other axes and rates that may act beside the input. */
    List<Channel> companions(Channel sensor, Quantity quantity) {
        return measured.companions(sensor, quantity);
    }

    /** See {@link Measured#across}. */
    List<Channel> across(String location, Quantity quantity) {
        return measured.across(location, quantity);
    }

    /** What small errors of the sensors do in a window. */
    ErrorShapes shapes(Window window) {
        return measured.shapes(window, own -> ErrorShapes.of(this).in(this, own));
    }

    /** What models are fitted in. */
    public Window fit() {
        return fit;
    }

    /** What is kept from fits, to prove them. */
    public Window heldOut() {
        return heldOut;
    }

    /** What may be missing. */
    public Library library() {
        return library;
    }

    /** What was found out about it already. */
    public Known known() {
        return known;
    }

    /** The same evidence, to be explained by other mechanisms. */
    public Evidence with(Library other) {
        return new Evidence(measured, excitation, fit, heldOut, bodyForce, ignored, other, heard);
    }

    /** The same evidence, with a force that a person makes as part of the noise. */
    public Evidence with(BodyForce force) {
        return new Evidence(measured, excitation, fit, heldOut, Optional.of(force), ignored, library, heard);
    }

    /**
     * The same evidence, of a rig, with noise of the input's sensors.
     *
     * @param levels standard deviation of a sample, by sensor; the others have none but what is known beforehand
     */
    public Evidence with(Map<Channel, Double> levels) {
        return new Evidence(measured, excitation, fit, heldOut, bodyForce, ignored, library, levels);
    }

    /** How noisy the sensors of a rig's input are, where a fit has told it: standard deviation of a sample. */
    public Map<Channel, Double> heard() {
        return heard;
    }

    /** The same evidence, with no person's force in the noise. */
    public Evidence withoutForce() {
        return new Evidence(measured, excitation, fit, heldOut, Optional.empty(), ignored, library, heard);
    }

    /** The same evidence, blind to whatever enters at a place. */
    public Evidence ignoring(Place place) {
        List<Place> all = new ArrayList<>(ignored);
        all.addAll(place.each(this));
        return new Evidence(measured, excitation, fit, heldOut, bodyForce, all, library, heard);
    }

    /** The same evidence fitted on the end of the recording and proved on its beginning, for what shows only late. */
    public Evidence late() {
        double rate = recording().clock().rate();
        int n = recording().length();
        int start = (int) Math.round(SETTLING * rate);
        int split = n - measured.split();
        return new Evidence(measured, whole(), new Window(split, n - split - (int) (END * rate), rate),
                new Window(start, split - start, rate), bodyForce, ignored, library, heard);
    }

    /**
     * A part of the fit's window that is shaken hard, to try on it what may not be worth the whole: empty where the window is hardly
     * longer, or the ride has no such part. Time counts from its own start.
     */
    public Optional<Evidence> brief() {
        return known.brief(this::shaken);
    }

    private Optional<Evidence> shaken() {
        double rate = recording().clock().rate();
        int n = (int) Math.round(BRIEF * rate);
        if (onRig() || isLate() || Hypothesis.byTheClock(model().assembly()) || fit.length() < WORTH_A_PART * n) {
            return Optional.empty();
        }
        double[] ride = excitation.series(excitation.baseSpectrum());
        int from = IntStream.iterate(0, at -> at + n <= fit.start() + fit.length(), at -> at + n / 4).boxed()
                .max(Comparator.comparingDouble(at -> Motion.rms(Arrays.copyOfRange(ride, at, at + n), n))).orElseThrow();
        Measured part = measured.part(from, n);
        int start = (int) Math.round(SETTLING * rate);
        Window all = new Window(start, n - start - (int) (END * rate), rate);
        return Optional.of(new Evidence(part, part.input(), all, all, bodyForce, ignored, library, heard));
    }

    /** Whether the user said what proves. */
    public boolean isChosen() {
        return measured.isChosen();
    }

    /** Whether it is the end of the recording that is fitted. */
    public boolean isLate() {
        return fit.start() > heldOut.start();
    }

    /** A force that a person makes, where one was found. */
    public Optional<BodyForce> bodyForce() {
        return bodyForce;
    }

    /** Whether something strong reaches several outputs at once and counts as noise: a person's own force, or whatever is ignored. */
    boolean sharesNoise() {
        return bodyForce.isPresent() || !ignored.isEmpty();
    }

    /**
     * The whitening that belongs to a model, in a window.
     *
     * @param seen what sensors read of something that reaches the outputs: by output at the window's lines, see {@link Nuisances#seen}
     */
    Whitening whitening(Excitation from, Assembly model, Window window, UnaryOperator<double[][]> seen) {
        Simulator simulator = new Simulator(from);
        Assembly assembly = simulator.equivalent(model);
        List<Whitening.Source> sources = new ArrayList<>();
        for (InputWay input : inputWays(from, assembly)) {
            if (input.noise() > 0) {
                double[] power = new double[window.lines()];
                Arrays.setAll(power, line -> input.power(2 * Math.PI * window.frequency(line)));
                sources.add(new Whitening.Source(power, seen.apply(atLines(from, input.transfer().get(), window))));
            }
        }
        bodyForce.ifPresent(force -> {
            double[] power = new double[window.lines()];
            Arrays.setAll(power, line -> force.power(window.frequency(line)));
            double[][] way = new Place(Place.Kind.BODY, force.body()).direction(from, assembly);
            sources.add(new Whitening.Source(power, seen.apply(atLines(from, way, window))));
        });
        for (Place place : ignored) {
            sources.add(Whitening.Source.deafening(noise(), seen.apply(atLines(from, place.direction(from, assembly), window))));
        }
        return new Whitening(window, noise(), sources, ignored.size());
    }

    /**
     * The noise of a sensor of the input, and its way to the outputs.
     *
     * @param noise standard deviation of a sample, in its unit
     * @param order how often what it reads is differentiated to be what enters
     * @param transfer spectra of what enters, by output
     */
    public record InputWay(Channel sensor, double noise, int order, Supplier<double[][]> transfer) {

        /**
         * Power of the noise as it enters, in the square of the unit of what enters.
         *
         * @param omega frequency [rad/s]
         */
        public double power(double omega) {
            return Math.pow(noise * Math.pow(omega, order), 2);
        }
    }

    /**
     * The sensors of the input, those of the base first.
     *
     * @param model without laws that are not linear
     */
    public List<InputWay> inputWays(Excitation from, Assembly model) {
        List<InputWay> out = new ArrayList<>();
        List<Channel> base = model().base().sensors();
        for (int axis = 0; axis < base.size(); axis++) {
            Measured.InputNoise known = inputNoises().get(axis);
            int along = axis;
            out.add(new InputWay(base.get(axis), Math.hypot(known.deviation(), heard(base.get(axis))), known.order(),
                    () -> new Simulator(from).transmissibility(model, along)));
        }
        for (Model.Input input : onRig() ? model().inputs() : List.<Model.Input>of()) {
            double steps = Rounding.coarse(recording().values(input.sensor())).map(Rounding::noise).orElse(0.0);
            Place body = new Place(Place.Kind.BODY, model().index(input.body()));
            out.add(new InputWay(input.sensor(), Math.hypot(steps, heard(input.sensor())), 0, () -> body.direction(from, model)));
        }
        return out;
    }

    private double heard(Channel sensor) {
        return heard.getOrDefault(sensor, 0.0);
    }

    /**
     * Spectra over all lines of an excitation at the lines of a window, by straight lines between.
     *
     * @param spectra Not modified.
     */
    double[][] atLines(Excitation from, double[][] spectra, Window window) {
        double[] omega = from.omega();
        double spacing = omega[1] / (2 * Math.PI);
        double[][] g = new double[spectra.length][2 * window.lines()];
        for (int o = 0; o < g.length; o++) {
            for (int line = 0; line < window.lines(); line++) {
                double at = window.frequency(line) / spacing;
                int k = Math.min((int) at, omega.length - 2);
                double share = at - k;
                for (int part = 0; part < 2; part++) {
                    g[o][2 * line + part] = spectra[o][2 * k + part] * (1 - share) + spectra[o][2 * k + 2 + part] * share;
                }
            }
        }
        return g;
    }

    /**
     * Measured minus simulated, whitened.
     *
     * @param from what was simulated
     * @param simulated spectra by output. Not modified.
     */
    double[] residual(Excitation from, double[][] simulated, Whitening whitening) {
        double[][] spectra = new double[outputs().size()][];
        for (int o = 0; o < spectra.length; o++) {
            double[] series = from.series(simulated[o]);
            double[] own = measured(o);
            for (int i = 0; i < series.length; i++) {
                series[i] = own[i] - series[i];
            }
            level(o, series, whitening.window());
            spectra[o] = whitening.window().spectrum(series, valid(o));
        }
        return whitening.whiten(spectra);
    }

    /**
     * Simulated spectra times a factor, whitened like a residual.
     *
     * @param from what was simulated
     * @param simulated by output, in its unit. Not modified.
     */
    public double[] whitened(Excitation from, double[][] simulated, double factor, Whitening whitening) {
        double[][] spectra = new double[outputs().size()][];
        for (int o = 0; o < spectra.length; o++) {
            if (isZero(simulated[o])) {
                spectra[o] = new double[0];
                continue;
            }
            double[] series = from.series(simulated[o]);
            for (int i = 0; i < series.length; i++) {
                series[i] *= factor;
            }
            level(o, series, whitening.window());
            spectra[o] = whitening.window().spectrum(series, valid(o));
        }
        return whitening.whiten(spectra);
    }

    /**
     * Takes the mean in a window from a person's rate or place, which no sensor of acceleration knows: where it began is nobody's error.
     * What bodies that turn by whole angles feel has a mean, too, which is taken from the recorded.
     *
     * @param series of an output. Modified.
     */
    private void level(int output, double[] series, Window window) {
        if (!isLevelled(output)) {
            return;
        }
        boolean[] valid = valid(output);
        double sum = 0;
        int counted = 0;
        for (int i = window.start(); i < window.start() + window.length(); i++) {
            sum += valid[i] ? series[i] : 0;
            counted += valid[i] ? 1 : 0;
        }
        double mean = counted == 0 ? 0 : sum / counted;
        for (int i = 0; i < series.length; i++) {
            series[i] -= mean;
        }
    }

    /** Whether an output's constant part does not count. */
    boolean isLevelled(int output) {
        return !onRig() && (measured.isPlaceOrRate(output) || model().base().at().isPresent());
    }

    private static boolean isZero(double[] x) {
        for (double value : x) {
            if (value != 0) {
                return false;
            }
        }
        return true;
    }
}

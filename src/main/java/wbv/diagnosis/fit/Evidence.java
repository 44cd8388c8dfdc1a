package wbv.diagnosis.fit;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.diagnosis.measured.Inputs;
import wbv.diagnosis.measured.Measured;
import wbv.diagnosis.mechanism.Library;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/** What models are judged by: a recording as they see it, two windows, one to fit and one to prove, and what counts as noise. */
public final class Evidence {

    private final Measured measured;
    private final Inputs inputs;
    private final Windows windows;
    private final NoiseSources sources;
    private final Library library;
    /** What small errors of the sensors do in each window of what was measured, since many whitenings ask for it. */
    private final Map<Window, ErrorShapes> shapes;
    private final Known known = new Known();

    /** With the sensors' noise as the recording shows it. */
    public Evidence(Model model, Recording recording) {
        this(model, recording, OptionalDouble.empty(), OptionalDouble.empty());
    }

    /**
     * Evidence of which the last part is held out, or what comes after a moment that is given.
     *
     * @param stated standard deviation of a sample of every sensor of the outputs' kind, in its unit
     * @param provedFrom see {@link wbv.diagnosis.Question#provedFrom}
     */
    public Evidence(Model model, Recording recording, OptionalDouble stated, OptionalDouble provedFrom) {
        this(new Measured(model, recording, stated, false, provedFrom));
    }

    /**
     * What another model makes of the input.
     *
     * @param stated as for what was measured
     */
    public static Evidence computed(Model model, Recording simulation, OptionalDouble stated) {
        return new Evidence(new Measured(model, simulation, stated, true, OptionalDouble.empty()));
    }

    private Evidence(Measured measured) {
        this(measured, Inputs.of(measured), Windows.of(measured), NoiseSources.NONE, Library.standard(), new ConcurrentHashMap<>());
    }

    private Evidence(Measured measured, Inputs inputs, Windows windows, NoiseSources sources, Library library,
            Map<Window, ErrorShapes> shapes) {
        this.measured = measured;
        this.inputs = inputs;
        this.windows = windows;
        this.sources = sources;
        this.library = library;
        this.shapes = shapes;
    }

    /** The user's. */
    public Model model() {
        return measured.model();
    }

    /** Whether forces alone drive the model, or one in a link is measured: no data tell a gain of all sensors from all its numbers then. */
    public boolean measuresForces() {
        return model().base().sensor().isEmpty() || model().driven();
    }

    /** Whether the model is of a test rig, see {@link Model#subject}: then constants count, and no person's own force acts. */
    public boolean onRig() {
        return measured.onRig();
    }

    /** Whether the model stands for a simulation that gave more than it does. */
    public boolean standsForSimulation() {
        return !beside().isEmpty();
    }

    /** Channels of the recording that hold what a simulation gave beside the model, and nobody measured. */
    public Set<Channel> beside() {
        return Measured.beside(model());
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
        return inputs.fitted();
    }

    /** The whole input. */
    public Excitation whole() {
        return inputs.whole();
    }

    /** All that is known of the recording before any fit. */
    public Measured measured() {
        return measured;
    }

    /** What counts as noise beside that of the outputs' own sensors. */
    NoiseSources sources() {
        return sources;
    }

    /** The series of a channel with its gaps bridged, in its unit. Not a copy where it has none. */
    public double[] series(Channel channel) {
        return LostSamples.filled(recording().values(channel));
    }

    /** The series that was measured at an output, of a sitter without its mean, gaps filled, in its unit. Not a copy. */
    public double[] measured(int output) {
        return measured.series(output);
    }

    /** Samples of an output that count. Not a copy. */
    public boolean[] valid(int output) {
        return measured.valid(output);
    }

    /** Standard deviation of a sample, by output, in its unit. Not a copy. */
    public double[] noise() {
        return measured.noise();
    }

    /** What noise leaves at least, as a mean square of a whitened residual [1]: itself; nothing where noise is only bounded from above. */
    public double floor() {
        return measured.isNoiseKnown() ? 1 : 0;
    }

    /** What small errors of the sensors do in a window. */
    ErrorShapes shapes(Window window) {
        return shapes.computeIfAbsent(window, own -> ErrorShapes.of(this).in(this, own));
    }

    /** What models are fitted in. */
    public Window fit() {
        return windows.fit();
    }

    /** What is kept from fits, to prove them. */
    public Window heldOut() {
        return windows.heldOut();
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
        return new Evidence(measured, inputs, windows, sources, other, shapes);
    }

    /** The same evidence, with a force as part of the noise: a person's who sits still, or a push. */
    public Evidence with(BodyForce force) {
        return with(force.ordinary(this) ? acting().withOwn(Optional.of(force)) : acting().withPush(Optional.of(force)));
    }

    /** The same evidence, with these forces as part of the noise and no others. */
    public Evidence with(BodyForce.Acting forces) {
        return with(sources.with(forces));
    }

    /** The same evidence, of a rig, with standard deviations of a sample of its input's sensors; of others none but what is known. */
    public Evidence with(Map<Channel, Double> levels) {
        return with(sources.with(levels));
    }

    /** How noisy the sensors of a rig's input are, where a fit has told it: standard deviation of a sample. */
    public Map<Channel, Double> heard() {
        return sources.heard();
    }

    /** The same evidence, blind to whatever enters at a place. */
    public Evidence ignoring(Place place) {
        return with(sources.ignoring(place.each(this)));
    }

    private Evidence with(NoiseSources others) {
        return new Evidence(measured, inputs, windows, others, library, shapes);
    }

    /**
     * The same evidence, where a force on a body is known that nobody measured: models are simulated with it.
     *
     * @param force [N], by sample of the recording. Not modified.
     */
    public Evidence pushed(int body, double[] force) {
        return new Evidence(measured, inputs.pushed(body, force), windows, sources, library, shapes);
    }

    /** The same evidence fitted on the end of the recording and proved on its beginning, for what shows only late. */
    public Evidence late() {
        return new Evidence(measured, Inputs.whole(whole()), Windows.late(measured), sources, library, shapes);
    }

    /**
     * A part of the fit's window that is shaken hard, to try on it what may not be worth the whole: empty where there is none that is much
     * shorter, see {@link ShakenPart}. Time counts from its own start.
     */
    public Optional<Evidence> brief() {
        return known.once(new ShakenPart.Asked(), () -> ShakenPart.of(this).map(part -> new Evidence(part.measured(), part.inputs(),
                Windows.whole(part.measured()), sources, library, new ConcurrentHashMap<>())));
    }

    /** The same evidence, with less noise than it is bounded by, where a fit leaves less; empty where nothing shows that. */
    public Optional<Evidence> beside(Fitter.State fit) {
        return measured.isNoiseKnown() || fit.failed() ? Optional.empty() : measured.beside(new Readings(this).of(fit))
                .map(quieter -> new Evidence(quieter, inputs, windows, sources, library, new ConcurrentHashMap<>()));
    }

    /** Whether it is the end of the recording that is fitted. */
    public boolean isLate() {
        return windows.isLate();
    }

    /** Forces that count as noise. */
    public BodyForce.Acting acting() {
        return sources.acting();
    }

    /** What is simulated for the outputs, as it shows beside what was measured there. */
    public OutputSpectra spectra() {
        return new OutputSpectra(measured);
    }
}

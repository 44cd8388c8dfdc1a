package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Excitation;
import wbv.body.Model;
import wbv.body.Simulator;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/**
 * The recording as a model sees it: the input, what was measured at each output and which samples of it count, how noisy the
 * sensors are, and the two windows, one to fit and one to prove.
 */
final class Evidence {

    private static final double SETTLING = 2;
    private static final double FIT_SHARE = 0.7;
    private static final double END = 0.6;
    private static final double SHORTEST = 15;
    private static final double SHORTEST_ON_A_RIG = 4;
    private static final double SETTLING_SHARE = 0.05;
    private static final double BRIEF = 36;
    private static final double WORTH_A_PART = 1.6;
    /** What the noise's level is read from. */
    private static final int FEWEST = 1024;

    private final Model model;
    private final boolean onRig;
    private final Recording recording;
    private final List<Channel> outputs;
    private final Excitation excitation;
    private final Excitation whole;
    private final double[][] measured;
    private final double[] mean;
    private final boolean[][] valid;
    private final int[] dropped;
    private final double inputNoise;
    private final double[] noise;
    private final Window fit;
    private final Window heldOut;
    private final Optional<BodyForce> bodyForce;
    private final List<Place> ignored;

    /** With the sensors' noise as the recording shows it. */
    Evidence(Model model, Recording recording) {
        this(model, recording, OptionalDouble.empty());
    }

    /** @param stated standard deviation of a sample of every output, where it is known */
    Evidence(Model model, Recording recording, OptionalDouble stated) {
        this.model = model;
        onRig = model.driven() || !model.inputs().isEmpty();
        this.recording = recording;
        this.outputs = model.outputs();
        if (outputs.isEmpty()) {
            throw new DataFault("no body or link of the model has a sensor: there is nothing to compare");
        }
        double rate = recording.clock().rate();
        int n = recording.length();
        double shortest = onRig ? SHORTEST_ON_A_RIG : SHORTEST;
        if (n / rate < shortest) {
            throw new DataFault(String.format(Locale.ROOT, "a diagnosis needs at least %.0f s; the recording has %.3g s",
                    shortest, n / rate));
        }
        if (!onRig && n < FEWEST) {
            throw new DataFault("a diagnosis needs at least " + FEWEST + " samples; the recording has " + n);
        }
        Admission.moving(model, recording);
        whole = Excitation.of(model, recording, n);
        measured = new double[outputs.size()][];
        mean = new double[outputs.size()];
        valid = new boolean[outputs.size()][];
        dropped = new int[outputs.size()];
        for (int o = 0; o < measured.length; o++) {
            double[] raw = recording.values(outputs.get(o));
            if (onRig) {   // rounded values of a slow stroke repeat without being lost
                valid[o] = present(raw);
            } else {
                valid[o] = new Dropouts(recording, outputs.get(o)).valid();
                dropped[o] = new Dropouts(recording, outputs.get(o)).found();
            }
            double[] counted = raw.clone();
            for (int i = 0; i < n; i++) {
                counted[i] = valid[o][i] ? raw[i] : Double.NaN;
            }
            double[] bridged = Excitation.bridged(counted);
            mean[o] = onRig ? 0 : Arrays.stream(counted).filter(value -> !Double.isNaN(value)).average().orElse(0);
            measured[o] = onRig ? bridged : centred(bridged);
        }
        int start = model.driven() ? 0 : (int) Math.round(onRig ? Math.min(SETTLING * rate, SETTLING_SHARE * n) : SETTLING * rate);
        int split = (int) Math.round(FIT_SHARE * n);
        // Fits need the record up to their window's end and no more: half the lines, half the time.
        int end = Math.min(n, split + (int) rate);
        excitation = Excitation.of(model, recording, end);
        fit = onRig ? new Window(start, split - start, rate, 0) : new Window(start, split - start, rate);
        heldOut = onRig ? new Window(split, n - split, rate, 0) : new Window(split, n - split - (int) (END * rate), rate);
        bodyForce = Optional.empty();
        ignored = List.of();
        NoiseLevel level = new NoiseLevel();
        noise = new double[outputs.size()];
        if (onRig) {
            inputNoise = 0;
            for (int o = 0; o < noise.length; o++) {
                double floor = level.bound(measured[o]);
                if (whole.stroke().isPresent()) {
                    floor = Math.max(floor, Repeatable.rest(whole.stroke().get(), measured[o], valid[o], split));
                }
                noise[o] = stated.orElse(floor);
            }
            return;
        }
        Channel input = model.base().sensor().orElseThrow(() -> new DataFault("the model's base '" + model.base().name()
                + "' has no sensor; name the channel that measures the excitation"));
        boolean moved = input.quantity() != Quantity.ACCELERATION;
        inputNoise = moved ? 0 : level.ofPlace(recording, input);
        for (int o = 0; o < noise.length; o++) {
            noise[o] = stated.orElse(outputs.get(o).quantity() == input.quantity() && !moved ? inputNoise : level.of(measured[o]));
        }
        if (!moved) {
            Admission.excited(rate, input, whole.series(whole.baseSpectrum()), inputNoise, measured);
        }
    }

    private static boolean[] present(double[] x) {
        boolean[] out = new boolean[x.length];
        for (int i = 0; i < x.length; i++) {
            out[i] = !Double.isNaN(x[i]);
        }
        return out;
    }

    private Evidence(Evidence like, Excitation excitation, Window fit, Window heldOut, Optional<BodyForce> bodyForce, List<Place> ignored) {
        model = like.model;
        onRig = like.onRig;
        recording = like.recording;
        outputs = like.outputs;
        whole = like.whole;
        measured = like.measured;
        mean = like.mean;
        valid = like.valid;
        dropped = like.dropped;
        inputNoise = like.inputNoise;
        noise = like.noise;
        this.excitation = excitation;
        this.fit = fit;
        this.heldOut = heldOut;
        this.bodyForce = bodyForce;
        this.ignored = ignored;
    }

    Model model() {
        return model;
    }

    /**
     * Whether forces push the model or its links are driven, as on a test rig: then constants count, no band is known to be free of
     * excitation, and no person's own force acts.
     */
    boolean onRig() {
        return onRig;
    }

    Recording recording() {
        return recording;
    }

    List<Channel> outputs() {
        return outputs;
    }

    /** The input up to the end of the fit's window. */
    Excitation excitation() {
        return excitation;
    }

    /** The whole input. */
    Excitation whole() {
        return whole;
    }

    /** A channel with its gaps bridged. Not a copy. */
    double[] series(Channel channel) {
        return Excitation.bridged(recording.values(channel));
    }

    /** What was measured at an output, mean removed, gaps filled. Not a copy. */
    double[] measured(int output) {
        return measured[output];
    }

    double mean(int output) {
        return mean[output];
    }

    boolean[] valid(int output) {
        return valid[output];
    }

    /** Samples in which the whole sensor of an output repeats itself or reads zero. */
    int repeated(int output) {
        return dropped[output];
    }

    double inputNoise() {
        return inputNoise;
    }

    double[] noise() {
        return noise;
    }

    Window fit() {
        return fit;
    }

    Window heldOut() {
        return heldOut;
    }

    /** The same evidence, with a force that a person makes as part of the noise. */
    Evidence with(BodyForce force) {
        return new Evidence(this, excitation, fit, heldOut, Optional.of(force), ignored);
    }

    /** The same evidence, blind to whatever enters at a place. */
    Evidence ignoring(Place place) {
        List<Place> all = new ArrayList<>(ignored);
        all.add(place);
        return new Evidence(this, excitation, fit, heldOut, bodyForce, List.copyOf(all));
    }

    /** The same evidence fitted on the end of the recording and proved on its beginning, for what shows only late. */
    Evidence late() {
        double rate = recording.clock().rate();
        int n = recording.length();
        int start = (int) Math.round(SETTLING * rate);
        int split = n - (int) Math.round(FIT_SHARE * n);
        return new Evidence(this, whole, new Window(split, n - split - (int) (END * rate), rate), new Window(start, split - start, rate), bodyForce,
                ignored);
    }

    /**
     * A part of the fit's window that is shaken hard, to try on it what may not be worth the whole: empty where the window is hardly longer, or
     * the ride has no such part. Time counts from its own start.
     */
    Optional<Evidence> brief() {
        double rate = recording.clock().rate();
        int n = (int) Math.round(BRIEF * rate);
        if (onRig || isLate() || fit.length() < WORTH_A_PART * n) {
            return Optional.empty();
        }
        double[] ride = excitation.series(excitation.baseSpectrum());
        int from = IntStream.iterate(0, at -> at + n <= fit.start() + fit.length(), at -> at + n / 4).boxed()
                .max(Comparator.comparingDouble(at -> Motion.rms(Arrays.copyOfRange(ride, at, at + n), n))).orElseThrow();
        return Optional.of(new Evidence(this, from, n));
    }

    private Evidence(Evidence like, int from, int length) {
        model = like.model;
        onRig = like.onRig;
        recording = like.recording.part(from, from + length);
        outputs = like.outputs;
        measured = Arrays.stream(like.measured).map(y -> Arrays.copyOfRange(y, from, from + length)).toArray(double[][]::new);
        mean = like.mean;
        valid = Arrays.stream(like.valid).map(v -> Arrays.copyOfRange(v, from, from + length)).toArray(boolean[][]::new);
        dropped = like.dropped;
        inputNoise = like.inputNoise;
        noise = like.noise;
        excitation = Excitation.of(model, recording, length);
        whole = excitation;
        double rate = recording.clock().rate();
        int start = (int) Math.round(SETTLING * rate);
        fit = new Window(start, length - start - (int) (END * rate), rate);
        heldOut = fit;
        bodyForce = like.bodyForce;
        ignored = like.ignored;
    }

    /** Whether it is the end of the recording that is fitted. */
    boolean isLate() {
        return fit.start() > heldOut.start();
    }

    Optional<BodyForce> bodyForce() {
        return bodyForce;
    }

    /** The whitening that belongs to a model, in a window. */
    Whitening whitening(Excitation from, Assembly assembly, Window window) {
        List<Whitening.Source> sources = new ArrayList<>();
        double[] white = new double[window.lines()];
        Arrays.fill(white, inputNoise * inputNoise);
        sources.add(new Whitening.Source(white, atLines(from, new Simulator(from).transmissibility(assembly), window)));
        bodyForce.ifPresent(force -> {
            double[] power = new double[window.lines()];
            Arrays.setAll(power, line -> force.power(window.frequency(line)));
            sources.add(new Whitening.Source(power, atLines(from, new Place(Place.Kind.BODY, force.body()).direction(from, assembly), window)));
        });
        for (Place place : ignored) {
            sources.add(Whitening.Source.deafening(noise[0], atLines(from, place.direction(from, assembly), window)));
        }
        return new Whitening(window, noise, sources, ignored.size());
    }

    /** Spectra over all lines of an excitation at the lines of a window, by straight lines between. @param spectra Not modified. */
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

    /** Measured minus simulated, whitened. @param from what was simulated @param simulated spectra by output. Not modified. */
    double[] residual(Excitation from, double[][] simulated, Whitening whitening) {
        double[][] spectra = new double[measured.length][];
        for (int o = 0; o < spectra.length; o++) {
            double[] series = from.series(simulated[o]);
            for (int i = 0; i < series.length; i++) {
                series[i] = measured[o][i] - series[i];
            }
            spectra[o] = whitening.window().spectrum(series, valid[o]);
        }
        return whitening.whiten(spectra);
    }

    /** Simulated spectra times a factor, whitened like a residual. @param from what was simulated @param simulated by output. Not modified. */
    double[] whitened(Excitation from, double[][] simulated, double factor, Whitening whitening) {
        double[][] spectra = new double[measured.length][];
        for (int o = 0; o < spectra.length; o++) {
            if (isZero(simulated[o])) {
                spectra[o] = new double[0];
                continue;
            }
            double[] series = from.series(simulated[o]);
            for (int i = 0; i < series.length; i++) {
                series[i] *= factor;
            }
            spectra[o] = whitening.window().spectrum(series, valid[o]);
        }
        return whitening.whiten(spectra);
    }

    /** Acceleration channels of other axes and rates that may act beside the input. */
    List<Channel> companions(String location, Quantity quantity) {
        List<Channel> out = new ArrayList<>();
        for (Channel channel : recording.channels()) {
            if (channel.location().equals(location) && channel.quantity() == quantity && channel.axis() != model.axis()) {
                out.add(channel);
            }
        }
        return out;
    }

    private static boolean isZero(double[] x) {
        for (double value : x) {
            if (value != 0) {
                return false;
            }
        }
        return true;
    }

    private static double[] centred(double[] x) {
        double mean = Arrays.stream(x).average().orElse(0);
        return Arrays.stream(x).map(value -> value - mean).toArray();
    }
}

package wbv.diagnosis.measured;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.body.simulate.Excitation;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/** A recording as a model sees it: the input, what was measured at each output and which samples of it count, how noisy the sensors are. */
public final class Measured {

    /** Share of a recording that models are fitted to; the rest proves them. */
    public static final double FIT_SHARE = 0.7;

    /** Part of a noise that another has to be below for anything to look different [1]: a tenth is what short records tell. */
    private static final double NOTICED = 0.9;

    private final Model model;
    private final boolean computed;
    private final Recording recording;
    private final Excitation input;
    private final List<MeasuredOutput> outputs;
    private final List<Channel> channels;
    private final double sample;
    private final boolean chosen;
    private final int split;
    private final SensorNoise reading;
    private final SensorNoise.Levels noise;

    /**
     * A recording of a sitter that is faster than about 60 Hz is slowed down.
     *
     * @param stated standard deviation of a sample of every sensor of the outputs' kind, in its unit, where it is known
     * @param computed whether a simulation gave it
     * @param provedFrom moment [s] from which on it proves what was fitted, see {@link wbv.diagnosis.Question#provedFrom}
     */
    public Measured(Model model, Recording recording, OptionalDouble stated, boolean computed, OptionalDouble provedFrom) {
        this.model = model;
        this.computed = computed;
        channels = model.outputs();
        if (channels.isEmpty()) {
            throw new DataFault("no body or link of the model has a sensor: there is nothing to compare");
        }
        this.recording = onRig() ? recording : SitterRate.usual(recording);
        sample = recording.clock().step();
        chosen = provedFrom.isPresent();
        split = chosen ? (int) this.recording.clock().nearest(provedFrom.getAsDouble())
                : (int) Math.round(FIT_SHARE * this.recording.length());
        Admission.longEnough(model, this.recording);
        Admission.moving(model, recording);
        input = Excitation.of(model, this.recording, this.recording.length());
        boolean[] driven = onRig() ? new Unseen(model, recording).driven() : driven();
        outputs = channels.stream().map(channel -> onRig() ? MeasuredOutput.onRig(recording, channel, driven)
                : MeasuredOutput.ofSitter(recording, this.recording, channel, driven)).toList();
        // Fewer samples hold less of a noise that is white.
        double slowed = Math.sqrt(this.recording.clock().rate() / recording.clock().rate());
        reading = new SensorNoise(model, this.recording, outputs, computed,
                stated.isPresent() ? OptionalDouble.of(slowed * stated.getAsDouble()) : stated);
        noise = onRig() ? reading.onRig(input, split) : reading.ofSitter();
        if (!onRig()) {
            model.base().sensor().filter(base -> base.quantity() == Quantity.ACCELERATION)
                    .ifPresent(base -> Admission.excited(this.recording.clock().rate(), base, input.series(input.baseSpectrum()),
                            computed ? 0 : inputNoise(), outputs.stream().map(MeasuredOutput::series).toArray(double[][]::new)));
        }
    }

    private Measured(Measured like, Recording recording, Excitation input, List<MeasuredOutput> outputs, int split,
            SensorNoise.Levels noise) {
        this.model = like.model;
        this.computed = like.computed;
        this.recording = recording;
        this.channels = like.channels;
        this.input = input;
        this.outputs = outputs;
        this.sample = like.sample;
        this.chosen = like.chosen;
        this.split = split;
        this.reading = like.reading;
        this.noise = noise;
    }

    /** Where what moves a sitter is known. */
    private boolean[] driven() {
        return model.base().sensor().map(sensor -> new Dropouts(recording, sensor).driven(recording.clock().rate())).orElseGet(() -> {
            boolean[] all = new boolean[recording.length()];
            Arrays.fill(all, true);
            return all;
        });
    }

    /** A stretch of it, as if no more had been recorded; what is known of the sensors stays known. */
    public Measured part(int from, int length) {
        Recording stretch = recording.part(from, from + length);
        return new Measured(this, stretch, Excitation.of(model, stretch, length),
                outputs.stream().map(output -> output.part(from, from + length)).toList(), length, noise);
    }

    /**
     * The same with less noise than it is bounded by, where a model leaves less; empty where nothing shows that.
     *
     * @param read what its outputs' sensors read by that model, by output, in their units. Not modified.
     */
    public Optional<Measured> beside(double[][] read) {
        SensorNoise.Levels levels = reading.onRig(input, split, IntStream.range(0, read.length)
                .mapToObj(o -> left(outputs.get(o), read[o])).toArray(double[][]::new));
        return IntStream.range(0, read.length).anyMatch(o -> levels.outputs()[o] < NOTICED * noise()[o])
                ? Optional.of(new Measured(this, recording, input, outputs, split, levels)) : Optional.empty();
    }

    /** What is left of what is fitted. */
    private double[] left(MeasuredOutput output, double[] read) {
        return IntStream.range(0, split).mapToDouble(i -> output.valid()[i] ? output.series()[i] - read[i] : Double.NaN).toArray();
    }

    /** The user's. */
    public Model model() {
        return model;
    }

    /** Whether the model is of a test rig, see {@link Model#subject}. */
    public boolean onRig() {
        return model.isRig();
    }

    /** Whether no sensor measured it, so that none can be wrong by a little. */
    public boolean computed() {
        return computed;
    }

    /** What is judged by: a fast one of a sitter brought to about 60 Hz, any other as it was read. */
    public Recording recording() {
        return recording;
    }

    /** Channels of the model's sensors, in the order in which all arrays by output have them. */
    public List<Channel> outputs() {
        return channels;
    }

    /** The whole input. */
    public Excitation input() {
        return input;
    }

    /** The series that was measured at an output, of a sitter without its mean, gaps filled, in its unit. Not a copy. */
    public double[] series(int output) {
        return outputs.get(output).series();
    }

    /** What was removed of {@link #series}, in the channel's unit. */
    public double mean(int output) {
        return outputs.get(output).mean();
    }

    /** Samples of an output that count. Not a copy. */
    public boolean[] valid(int output) {
        return outputs.get(output).valid();
    }

    /** Samples in which the whole sensor of an output repeats itself or reads zero. */
    public int repeated(int output) {
        return outputs.get(output).repeated();
    }

    /** First sample that serves for the proof only. */
    public int split() {
        return split;
    }

    /** Whether the user said what proves. */
    public boolean isChosen() {
        return chosen;
    }

    /**
     * Time between two samples as they were recorded [s], however slow the recording was made since: what clocks scatter by goes with it.
     */
    public double sample() {
        return sample;
    }

    /** Standard deviation of a sample of the input, in its unit. */
    public double inputNoise() {
        return noise.inputs().get(0).deviation();
    }

    /** That of each sensor of the base, by axis; of measured forces that of the first. */
    public List<InputNoise> inputNoises() {
        return noise.inputs();
    }

    /** Standard deviation of a sample, by output, in its unit. Not a copy. */
    public double[] noise() {
        return noise.outputs();
    }

    /** Whether how noisy the input's sensors are is known before a model tells it. */
    public boolean isInputNoiseKnown() {
        return !onRig();
    }

    /** Whether how noisy the sensors are is known, and not only that they are no noisier. */
    public boolean isNoiseKnown() {
        return reading.isKnown();
    }

    /** Channels of another kind, or of other axes than the sensor's own, that were recorded where it is. */
    public List<Channel> companions(Channel sensor, Quantity quantity) {
        return recording.channels().stream()
                .filter(channel -> channel.location().equals(sensor.location()) && channel.quantity() == quantity
                        && channel.axis() != sensor.axis())
                .toList();
    }

    /** Channels of other axes than the model's that may act beside the input: recorded at a place, and no part of the model. */
    public List<Channel> across(String location, Quantity quantity) {
        return recording.channels().stream().filter(channel -> channel.location().equals(location) && channel.quantity() == quantity
                && channel.axis() != model.axis() && !model.excitations().contains(channel) && !channels.contains(channel)).toList();
    }

    /**
     * A series less its mean, in its unit, a new array.
     *
     * @param x by sample, of any unit. Not modified.
     */
    public static double[] centred(double[] x) {
        double mean = Arrays.stream(x).average().orElse(0);
        return Arrays.stream(x).map(value -> value - mean).toArray();
    }

    /** Channels that hold what a simulation gave beside a model, which move its sensors and nobody measured. */
    public static Set<Channel> beside(Model model) {
        return Stream.concat(model.bodies().stream().map(Model.Body::faults), model.sensors().stream().map(Model.Sensor::faults))
                .flatMap(List::stream).filter(SensorFault.Beside.class::isInstance).map(fault -> ((SensorFault.Beside) fault).channel())
                .collect(Collectors.toSet());
    }
}

package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/** A recording as a model sees it: the input, what was measured at each output and which samples of it count, how noisy the sensors are. */
public final class Measured {

    /** Share of a recording that models are fitted to; the rest proves them. */
    public static final double FIT_SHARE = 0.7;
    private static final double SHORTEST = 15;
    /**
     * Periods of a rig's slowest mode. One tells two numbers, an amplitude and a phase. A mode has three, an offset and a law beside it as
     * many again: the three periods of the ten that are held out must tell them too.
     */
    private static final double PERIODS_ON_A_RIG = 10;
    /** Samples of a rig: a band that noise is read from holds no line of blocks that are shorter than a quarter of them. */
    private static final int FEWEST_ON_A_RIG = 256;
    /** Slowest rate at which something lies above what excites a sitter [Hz]. */
    private static final double SLOWEST = 45;
    /** Samples that a straight line stands for. */
    private static final int BRIDGED = 2;
    /** How long a sitter rings on [s]. */
    private static final double RINGING = 1;
    /** What the noise's level is read from. */
    private static final int FEWEST = 1024;

    private final Model model;
    private final boolean onRig;
    private final boolean computed;
    private final Recording recording;
    private final List<Channel> outputs;
    private final Excitation input;
    private final double[][] series;
    private final double[] mean;
    private final boolean[][] valid;
    private final int[] repeated;
    private final double sample;
    private final boolean chosen;
    private final int split;
    private final double inputNoise;
    private final List<InputNoise> inputNoises;
    private final double[] noise;
    /** What small errors of the sensors do in each window, since many whitenings ask for it. */
    private final Map<Window, ErrorShapes> shapes = new ConcurrentHashMap<>();

    /**
     * A recording of a sitter that is faster than about 60 Hz is slowed down.
     *
     * @param stated standard deviation of a sample of every sensor of the outputs' kind, where it is known
     * @param computed whether a simulation gave it
     * @param provedFrom see {@link wbv.diagnosis.Question#provedFrom}
     */
    Measured(Model model, Recording recording, OptionalDouble stated, boolean computed, OptionalDouble provedFrom) {
        this.model = model;
        this.computed = computed;
        onRig = model.isRig();
        outputs = model.outputs();
        if (outputs.isEmpty()) {
            throw new DataFault("no body or link of the model has a sensor: there is nothing to compare");
        }
        this.recording = onRig ? recording : SitterRate.usual(recording);
        sample = recording.clock().step();
        chosen = provedFrom.isPresent();
        split = chosen ? (int) this.recording.clock().nearest(provedFrom.getAsDouble())
                : (int) Math.round(FIT_SHARE * this.recording.length());
        longEnough();
        Admission.moving(model, recording);
        int n = this.recording.length();
        input = Excitation.of(model, this.recording, n);
        boolean[] driven = driven();
        series = new double[outputs.size()][];
        mean = new double[outputs.size()];
        valid = new boolean[outputs.size()][];
        repeated = new int[outputs.size()];
        for (int o = 0; o < series.length; o++) {
            double[] raw = this.recording.values(outputs.get(o));
            valid[o] = present(raw);
            if (!onRig) {   // rounded values of a slow stroke repeat without being lost
                Dropouts dropouts = new Dropouts(recording, outputs.get(o));
                repeated[o] = dropouts.found();
                boolean[] counts = this.recording == recording ? dropouts.valid() : valid[o];
                for (int i = 0; i < n; i++) {
                    valid[o][i] = counts[i] && driven[i];
                }
            }
            double[] counted = raw.clone();
            for (int i = 0; i < n; i++) {
                counted[i] = valid[o][i] ? raw[i] : Double.NaN;
            }
            double[] bridged = Excitation.bridged(counted);
            mean[o] = onRig ? 0 : Arrays.stream(counted).filter(value -> !Double.isNaN(value)).average().orElse(0);
            series[o] = onRig ? bridged : centred(bridged);
        }
        noise = new double[outputs.size()];
        // Fewer samples hold less of a noise that is white.
        double slowed = Math.sqrt(this.recording.clock().rate() / recording.clock().rate());
        OptionalDouble known = stated.isPresent() ? OptionalDouble.of(slowed * stated.getAsDouble()) : stated;
        inputNoise = onRig ? noiseOnRig(known) : noiseOfSensors(known);
        InputNoise first = new InputNoise(inputNoise, model.base().sensor().map(sensor -> Excitation.order(sensor.quantity())).orElse(0));
        inputNoises = Stream.concat(Stream.of(first), model.base().further().stream().map(this::furtherNoise)).toList();
    }

    /**
     * The noise of a sensor of the base along a further axis; none on a rig, where a fit tells it, see
     * {@link wbv.diagnosis.search.InputLevel}.
     */
    private InputNoise furtherNoise(Channel sensor) {
        boolean alike = model.base().sensor().map(first -> first.quantity() == sensor.quantity()).orElse(false);
        return new InputNoise(onRig || computed ? 0 : alike ? inputNoise : new NoiseLevel().of(recording.values(sensor)),
                Excitation.order(sensor.quantity()));
    }

    /**
     * The noise of a sensor of the base.
     *
     * @param deviation of a sample, in its unit
     * @param order     how often what it reads is differentiated to be an acceleration
     */
    public record InputNoise(double deviation, int order) {

        /**
         * Power of the noise of the acceleration, in the square of its unit.
         *
         * @param omega frequency [rad/s]
         */
        public double power(double omega) {
            return Math.pow(deviation * Math.pow(omega, order), 2);
        }
    }

    /** Where the input is known: not in its gaps, nor while what nobody saw there still rings. */
    private boolean[] driven() {
        boolean[] out = new boolean[recording.length()];
        Arrays.fill(out, true);
        if (!onRig && model.base().sensor().isPresent()) {
            boolean[] lost = new Dropouts(recording, model.base().sensor().get()).lost();
            int ringing = (int) (RINGING * recording.clock().rate());
            int run = 0;
            for (int i = 0; i < lost.length; i++) {
                run = lost[i] ? run + 1 : 0;
                if (run > BRIDGED) {
                    Arrays.fill(out, i - run + 1, Math.min(lost.length, i + 1 + ringing), false);
                }
            }
        }
        return out;
    }

    private void longEnough() {
        int n = recording.length();
        double rate = recording.clock().rate();
        if (!onRig && n / rate < SHORTEST) {
            throw new DataFault(String.format(Locale.ROOT, "a diagnosis needs at least %.0f s; the recording has %.3g s",
                    SHORTEST, n / rate));
        }
        int fewest = onRig ? FEWEST_ON_A_RIG : FEWEST;
        if (n < fewest) {
            throw new DataFault(String.format(Locale.ROOT,
                    "a diagnosis needs at least %d samples at %.4g Hz, which are %.1f s; the recording has %.1f s",
                    fewest, rate, fewest / rate, n / rate));
        }
        OptionalDouble slowest = onRig ? model.assembly().structure().slowestMode() : OptionalDouble.empty();
        slowest.ifPresent(f -> {
            if (n / rate * f < PERIODS_ON_A_RIG) {
                throw new DataFault(
                        String.format(Locale.ROOT,
                                "a diagnosis of a rig needs at least %.0f periods of its slowest mode, which the model has at "
                                        + "%.3g Hz: %.3g s; the recording has %.3g s",
                                PERIODS_ON_A_RIG, f, PERIODS_ON_A_RIG / f, n / rate));
            }
        });
    }

    /**
     * Fills in the outputs' noise.
     *
     * @return that of the input, as far as it is known before a fit tells it, see {@link wbv.diagnosis.search.InputLevel}
     */
    private double noiseOnRig(OptionalDouble stated) {
        NoiseLevel level = new NoiseLevel();
        for (int o = 0; o < noise.length; o++) {
            double floor = level.bound(series[o]);
            if (input.stroke().isPresent()) {
                floor = Math.max(floor, Repeatable.rest(input.stroke().get(), series[o], valid[o], split));
            }
            noise[o] = stated.orElse(floor);
        }
        boolean alike = !computed && outputs.stream()
                .anyMatch(output -> model.base().sensor().filter(base -> base.quantity() == output.quantity()).isPresent());
        // An encoder at the input is no better than the one at the output; and what reads in steps is known to a step.
        double own = model.base().sensor().filter(base -> !model.driven() && !computed)
                .map(base -> Math.max(
                        alike && Excitation.order(base.quantity()) > 0 ? level.bound(Excitation.bridged(recording.values(base))) : 0,
                        Rounding.coarse(recording.values(base)).map(Rounding::noise).orElse(0.0)))
                .orElse(0.0);
        return alike && !model.driven() && stated.isPresent() ? stated.getAsDouble() : own;
    }

    /**
     * Fills in the outputs' noise.
     *
     * @return that of the input
     */
    private double noiseOfSensors(OptionalDouble stated) {
        NoiseLevel level = new NoiseLevel();
        Channel base = model.base().sensor().orElseThrow(() -> new DataFault("the model's base '" + model.base().name()
                + "' has no sensor; name the channel that measures the excitation"));
        boolean moved = base.quantity() != Quantity.ACCELERATION;
        if (stated.isEmpty() && recording.clock().rate() < SLOWEST) {
            throw new DataFault(
                    String.format(Locale.ROOT, "sampled at %.4g Hz the recording has no band above the excitation to read the noise from; "
                            + "%.0f Hz or more is needed, or say how noisy its sensors are (--noise)", recording.clock().rate(), SLOWEST));
        }
        boolean alike = !computed && outputs.stream().anyMatch(output -> output.quantity() == base.quantity());
        double own = moved ? 0 : stated.isPresent() && alike ? stated.getAsDouble() : unshared(level, base);
        for (int o = 0; o < noise.length; o++) {
            Channel output = outputs.get(o);
            noise[o] = stated.orElseGet(() -> output.quantity() == base.quantity() && !moved ? own : level.of(recording.values(output)));
        }
        if (!moved) {
            Admission.excited(recording.clock().rate(), base, input.series(input.baseSpectrum()), own, series);
        }
        return own;
    }

    /** The noise of the input's sensor, without motion that it shares with outputs of its kind. */
    private double unshared(NoiseLevel level, Channel base) {
        double own = level.ofPlace(recording, base);
        List<double[]> alike = new ArrayList<>(List.of(Excitation.bridged(recording.values(base))));
        for (int o = 0; o < outputs.size(); o++) {
            if (!computed && outputs.get(o).quantity() == base.quantity()) {
                alike.add(series[o]);
            }
        }
        return Math.min(own, level.ofWhatIsNotShared(alike.toArray(double[][]::new)).orElse(own));
    }

    private Measured(Measured like, int from, int length) {
        model = like.model;
        onRig = like.onRig;
        computed = like.computed;
        recording = like.recording.part(from, from + length);
        outputs = like.outputs;
        input = Excitation.of(model, recording, length);
        series = Arrays.stream(like.series).map(y -> Arrays.copyOfRange(y, from, from + length)).toArray(double[][]::new);
        mean = like.mean;
        valid = Arrays.stream(like.valid).map(v -> Arrays.copyOfRange(v, from, from + length)).toArray(boolean[][]::new);
        repeated = like.repeated;
        sample = like.sample;
        chosen = like.chosen;
        split = length;
        inputNoise = like.inputNoise;
        inputNoises = like.inputNoises;
        noise = like.noise;
    }

    /** A stretch of it, as if no more had been recorded; what is known of the sensors stays known. */
    Measured part(int from, int length) {
        return new Measured(this, from, length);
    }

    Model model() {
        return model;
    }

    /** See {@link Evidence#onRig}. */
    boolean onRig() {
        return onRig;
    }

    /** Whether no sensor measured it, so that none can be wrong by a little. */
    boolean computed() {
        return computed;
    }

    Recording recording() {
        return recording;
    }

    List<Channel> outputs() {
        return outputs;
    }

    /** The whole input. */
    Excitation input() {
        return input;
    }

    /** What was measured at an output, mean removed, gaps filled. Not a copy. */
    double[] series(int output) {
        return series[output];
    }

    double mean(int output) {
        return mean[output];
    }

    /** Whether an output reads neither acceleration nor force. */
    boolean isPlaceOrRate(int output) {
        Quantity quantity = outputs.get(output).quantity();
        return quantity != Quantity.ACCELERATION && quantity != Quantity.FORCE;
    }

    /** Samples of an output that count. Not a copy. */
    boolean[] valid(int output) {
        return valid[output];
    }

    /** Samples in which the whole sensor of an output repeats itself or reads zero. */
    int repeated(int output) {
        return repeated[output];
    }

    /** First sample that serves for the proof only. */
    int split() {
        return split;
    }

    /** Whether the user said what proves. */
    boolean isChosen() {
        return chosen;
    }

    /**
     * Time between two samples as they were recorded [s], however slow the recording was made since: what clocks scatter by goes with it.
     */
    double sample() {
        return sample;
    }

    /** Standard deviation of a sample of the input. */
    double inputNoise() {
        return inputNoise;
    }

    /** That of each sensor of the base, by axis; of measured forces that of the first. */
    List<InputNoise> inputNoises() {
        return inputNoises;
    }

    /** Standard deviation of a sample, by output. Not a copy. */
    double[] noise() {
        return noise;
    }

    /**
     * What small errors of the sensors do in a window.
     *
     * @param make asked once
     */
    ErrorShapes shapes(Window window, Function<Window, ErrorShapes> make) {
        return shapes.computeIfAbsent(window, make);
    }

    /** Channels of another kind, or of other axes than the sensor's own, that were recorded where it is. */
    List<Channel> companions(Channel sensor, Quantity quantity) {
        return recording.channels().stream()
                .filter(channel -> channel.location().equals(sensor.location()) && channel.quantity() == quantity
                        && channel.axis() != sensor.axis())
                .toList();
    }

    /** Channels of other axes than the model's that may act beside the input: recorded at a place, and no part of the model. */
    List<Channel> across(String location, Quantity quantity) {
        return recording.channels().stream().filter(channel -> channel.location().equals(location) && channel.quantity() == quantity
                && channel.axis() != model.axis() && !model.excitations().contains(channel) && !outputs.contains(channel)).toList();
    }

    private static boolean[] present(double[] x) {
        boolean[] out = new boolean[x.length];
        for (int i = 0; i < x.length; i++) {
            out[i] = !Double.isNaN(x[i]);
        }
        return out;
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
}

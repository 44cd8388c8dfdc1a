package wbv.diagnosis.measured;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/**
 * How noisy the sensors of a model are, standard deviations of a sample: what was stated, or what the recording shows. Of a sitter that is
 * the band above all excitation; on a rig no band is known to be free of it, and only what bounds the noise is read.
 *
 * @param recording at the rate at which it is judged
 * @param outputs what was measured there
 * @param computed whether a simulation gave them, whose noise is not that of the input's sensors
 * @param stated standard deviation of a sample of every sensor of the outputs' kind, in its unit, where it is known
 */
record SensorNoise(Model model, Recording recording, List<MeasuredOutput> outputs, boolean computed, OptionalDouble stated) {

    /** Slowest rate at which something lies above what excites a sitter [Hz]. */
    private static final double SLOWEST = 45;

    /**
     * What was found.
     *
     * @param outputs standard deviation of a sample, by output, in its unit. Not a copy
     * @param inputs of each sensor of the base, by axis; of measured forces that of the first
     */
    record Levels(double[] outputs, List<InputNoise> inputs) {}

    /**
     * On a rig: at the outputs no less than what does not repeat where a stroke does. That of the input is what is known before a fit tells
     * it, see {@link wbv.diagnosis.search.InputLevel}.
     *
     * @param split end of what is fitted, and looked at [samples]
     */
    Levels onRig(Excitation input, int split) {
        return onRig(input, split, outputs.stream().map(MeasuredOutput::read).toArray(double[][]::new));
    }

    /**
     * The same where a model is known that makes some of what was measured: where a rig is moved in all of the band, only what is left of
     * that shows how noisy the outputs are at most.
     *
     * @param left what is left, by output, NaN where lost. Not modified.
     */
    Levels onRig(Excitation input, int split, double[][] left) {
        double[] all = IntStream.range(0, left.length)
                .mapToDouble(o -> stated.orElseGet(() -> floor(outputs.get(o), left[o], input, split))).toArray();
        boolean stands = model.base().sensor().filter(this::isOfOutputs).isPresent() && !model.driven() && stated.isPresent();
        return with(all, stands ? stated.getAsDouble() : known());
    }

    private static double floor(MeasuredOutput output, double[] left, Excitation input, int split) {
        double quietest = new NoiseLevel().bound(output.read(), left);
        return input.stroke().map(stroke -> Math.max(quietest, Repeatable.rest(stroke, output.series(), output.valid(), split)))
                .orElse(quietest);
    }

    /** An encoder at the input is no better than the one at the output; and what reads in steps is known to a step. */
    private double known() {
        return model.base().sensor().filter(base -> !model.driven() && !computed).map(base -> {
            double[] read = recording.values(base);
            boolean encoder = isOfOutputs(base) && Excitation.order(base.quantity()) > 0;
            return Math.max(encoder ? new NoiseLevel().bound(read) : 0,
                    Rounding.coarse(read).map(Rounding::noise).orElse(0.0));
        }).orElse(0.0);
    }

    /** Whether it is known, and not only bounded. */
    boolean isKnown() {
        return stated.isPresent() || !model.isRig();
    }

    /** Of a sitter. */
    Levels ofSitter() {
        Channel base = model.base().sensor().orElseThrow(() -> new DataFault("the model's base '" + model.base().name()
                + "' has no sensor; name the channel that measures the excitation"));
        if (stated.isEmpty() && recording.clock().rate() < SLOWEST) {
            throw new DataFault(
                    String.format(Locale.ROOT, "sampled at %.4g Hz the recording has no band above the excitation to read the noise from; "
                            + "%.0f Hz or more is needed, or say how noisy its sensors are (--noise)", recording.clock().rate(), SLOWEST));
        }
        boolean moved = base.quantity() != Quantity.ACCELERATION;
        double own = moved ? 0 : stated.isPresent() && isOfOutputs(base) ? stated.getAsDouble() : unshared(base);
        double[] all = outputs.stream().map(MeasuredOutput::channel).mapToDouble(output -> stated.orElseGet(
                () -> output.quantity() == base.quantity() && !moved ? own : new NoiseLevel().of(recording.values(output)))).toArray();
        return with(all, own);
    }

    /** The noise of the input's sensor, without motion that it shares with outputs of its kind. */
    private double unshared(Channel base) {
        NoiseLevel level = new NoiseLevel();
        double own = level.ofPlace(recording, base);
        List<double[]> alike = new ArrayList<>(List.of(LostSamples.filled(recording.values(base))));
        outputs.stream().filter(output -> !computed && output.channel().quantity() == base.quantity()).map(MeasuredOutput::series)
                .forEach(alike::add);
        return Math.min(own, level.ofWhatIsNotShared(alike.toArray(double[][]::new)).orElse(own));
    }

    /** Whether a sensor of the base is of the kind of an output's, and both were measured: then one is as good as the other. */
    private boolean isOfOutputs(Channel base) {
        return !computed && outputs.stream().anyMatch(output -> output.channel().quantity() == base.quantity());
    }

    private Levels with(double[] all, double input) {
        InputNoise first = new InputNoise(input, model.base().sensor().map(sensor -> Excitation.order(sensor.quantity())).orElse(0));
        return new Levels(all,
                Stream.concat(Stream.of(first), model.base().further().stream().map(sensor -> further(sensor, input))).toList());
    }

    /** The noise of a sensor of the base along a further axis; none on a rig, where a fit tells it. */
    private InputNoise further(Channel sensor, double input) {
        boolean alike = model.base().sensor().map(first -> first.quantity() == sensor.quantity()).orElse(false);
        double own = model.isRig() || computed ? 0 : alike ? input : new NoiseLevel().of(recording.values(sensor));
        return new InputNoise(own, Excitation.order(sensor.quantity()));
    }
}

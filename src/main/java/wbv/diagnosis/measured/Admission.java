package wbv.diagnosis.measured;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.signal.ScalarProduct;

/** Refuses recordings that no diagnosis can be made of, each with its reason. */
final class Admission {

    private static final double LEAST_COHERENCE = 0.4;
    /** Length of a ride that holds enough of what a sitter does [s]. */
    private static final double SHORTEST = 15;
    /** Samples of a ride that its noise can be read from. */
    private static final int FEWEST = 1024;
    /** Samples of a rig: a band that noise is read from holds no line of blocks that are shorter than a quarter of them. */
    private static final int FEWEST_ON_A_RIG = 256;
    /**
     * Periods of a rig's slowest mode. One tells two numbers, an amplitude and a phase. A mode has three, an offset and a law beside it as
     * many again: the three periods of the ten that are held out must tell them too.
     */
    private static final double PERIODS_ON_A_RIG = 10;

    private Admission() {}

    /**
     * Refuses a recording that is too short to tell a model's numbers and how noisy its sensors are.
     *
     * @param recording at the rate at which it is judged
     */
    static void longEnough(Model model, Recording recording) {
        int n = recording.length();
        double rate = recording.clock().rate();
        if (!model.isRig() && n / rate < SHORTEST) {
            throw fault("a diagnosis needs at least %.0f s; the recording has %.3g s", SHORTEST, n / rate);
        }
        int fewest = model.isRig() ? FEWEST_ON_A_RIG : FEWEST;
        if (n < fewest) {
            throw fault("a diagnosis needs at least %d samples at %.4g Hz, which are %.1f s; the recording has %.1f s", fewest, rate,
                    fewest / rate, n / rate);
        }
        OptionalDouble slowest = model.isRig() ? model.assembly().structure().slowestMode() : OptionalDouble.empty();
        slowest.ifPresent(f -> {
            if (n / rate * f < PERIODS_ON_A_RIG) {
                throw fault("a diagnosis of a rig needs at least %.0f periods of its slowest mode, which the model has at %.3g Hz: %.3g s; "
                        + "the recording has %.3g s", PERIODS_ON_A_RIG, f, PERIODS_ON_A_RIG / f, n / rate);
            }
        });
    }

    /** Refuses a channel that stands still where the model needs one that moves. */
    static void moving(Model model, Recording recording) {
        for (Channel input : model.excitations()) {
            still(recording, input).ifPresent(value -> {
                throw new DataFault(input + " is " + value + " throughout: nothing excites the model; is it the right input?");
            });
        }
        for (Channel output : model.outputs()) {
            still(recording, output).ifPresent(value -> {
                throw new DataFault(output + " is " + value + " throughout: nothing was measured there; take the sensor out of "
                        + "the model");
            });
        }
    }

    /** The only value that a channel has. */
    private static Optional<Double> still(Recording recording, Channel channel) {
        double[] present = Arrays.stream(recording.values(channel)).filter(v -> !Double.isNaN(v)).distinct().limit(2).toArray();
        return present.length == 1 ? Optional.of(present[0]) : Optional.empty();
    }

    /**
     * Refuses a recording without excitation, and one whose input does not cause the outputs.
     *
     * @param rate [Hz]
     * @param base what the input measured, mean removed
     * @param noise of its sensor
     * @param measured by output. None modified.
     */
    static void excited(double rate, Channel input, double[] base, double noise, double[][] measured) {
        double rms = rms(base);
        if (!(rms > 3 * noise)) {
            throw fault("%s has no excitation: %.3g %s rms, of which the sensor's noise is %.3g; record a ride", input, rms,
                    input.quantity().unit(), noise);
        }
        Coherence best = Coherence.NONE;
        for (double[] output : measured) {
            Coherence own = Coherence.of(rate, base, output, Coherence.Weight.INPUT);
            best = own.share() > best.share() ? own : best;
        }
        if (best.share() < LEAST_COHERENCE || !best.isSure()) {
            throw fault(
                    "%s does not cause what the model's sensors measured: the coherence with the best of them is %.2f beyond what chance "
                            + "gives, at least %.2f is needed; is it the right input, in the same time?",
                    input, Math.max(0, best.share()),
                    Math.max(LEAST_COHERENCE, best.sure()));
        }
    }

    private static DataFault fault(String format, Object... values) {
        return new DataFault(String.format(Locale.ROOT, format, values));
    }

    private static double rms(double[] x) {
        return Math.sqrt(ScalarProduct.of(x, x) / x.length);
    }
}

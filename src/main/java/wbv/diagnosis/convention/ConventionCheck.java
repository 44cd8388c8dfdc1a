package wbv.diagnosis.convention;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.body.Model;
import wbv.diagnosis.measured.SitterRate;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/**
 * Asks for conventions: does the model agree with the recording far better if one channel, two names or a unit of the model are meant
 * otherwise, than with whatever numbers it may have? And is there a channel that has nothing to do with the others?
 *
 * <p>Each convention is a hypothesis beside the recording as it is read, with the same numbers free and the same prior of their errors; its
 * evidence is what {@link NumberFit} leaves. It is held where it is more probable than chance lets it be, and where it leaves next to
 * nothing of what it touches: no physics that is missing makes a channel agree that has another sign.
 */
public final class ConventionCheck {

    /** Samples that are looked at, the liveliest: more tell no more of a factor. */
    private static final int MOST = 8192;
    /** Samples below which nothing is asked. */
    private static final int FEWEST = 256;
    /** Times what is told from chance that the model must expect of a channel for its silence to say anything. */
    private static final double TOLD = 2;

    /** The least part that is said. */
    private static final double LEAST = 1e-4;

    private final Model model;
    private final Recording recording;
    private final List<Channel> channels;

    private ConventionCheck(Model model, Recording recording) {
        this.model = model;
        this.recording = recording;
        this.channels = model.channels();
    }

    /**
     * How the model and the recording are meant; empty where they are as they are read, or nothing tells.
     *
     * @param units whether units are in question, not signs and names alone
     * @param modelsOwn whether the model's numbers are its user's
     * @throws DataFault if nothing that moves the model has to do with what its sensors measured
     */
    public static Optional<Meant> of(Model model, Recording recording, boolean units, boolean modelsOwn) {
        Recording slow = model.isRig() ? recording : SitterRate.usual(recording);
        return comparable(model, slow) ? new ConventionCheck(model, slow).meant(recording, units, modelsOwn) : Optional.empty();
    }

    /** Whether all is there to be compared: what lacks a channel, or any motion of one, is refused elsewhere. */
    private static boolean comparable(Model model, Recording recording) {
        return !model.outputs().isEmpty() && !model.excitations().isEmpty() && recording.length() >= FEWEST
                && model.channels().stream().allMatch(channel -> recording.has(channel)
                        && Arrays.stream(recording.values(channel)).filter(Double::isFinite).distinct().limit(2).count() == 2);
    }

    private Optional<Meant> meant(Recording recorded, boolean units, boolean modelsOwn) {
        List<Convention> all = Conventions.of(model, recording, units, modelsOwn);
        Agreement agreement = new Agreement(model, liveliest());
        if (!agreement.asks(all.size())) {
            return Optional.empty();
        }
        List<Channel> silent = silent(agreement);
        return silent.isEmpty() ? agreement.held(all).map(held -> meant(held, recorded)) : Optional.of(Meant.without(silent, recorded));
    }

    /** Sensors that carry nothing. */
    private List<Channel> silent(Agreement agreement) {
        Unmoved unmoved = new Unmoved(model, recording);
        boolean all = agreement.unexplained(0).size() == model.outputs().size();
        if (all && model.isRig() && unmoved.all()) {
            throw new DataFault(String.format("no more of what the model's sensors measured goes with %s than chance gives: "
                    + "is it the right input, connected, and on the same clock?", named(model.excitations())));
        }
        return all ? List.of() : model.outputs().stream()
                .filter(output -> agreement.unexplained(TOLD * unmoved.told(output)).contains(output) && unmoved.beside(output, channels))
                .toList();
    }

    private Meant meant(Agreement.Held held, Recording recorded) {
        String others = held.others().isEmpty() ? ""
                : " The same would show if " + held.others().stream().map(Convention::amiss).collect(Collectors.joining(", or if "))
                        .replace(" is of", " were of").replace(" reads ", " read ").replace(" have ", " had ")
                        .replace(" look to be ", " were ") + ".";
        return new Meant(held.convention()::read, held.convention().read(recorded),
                String.format("%s, and %s: as recorded the model leaves %s of %s, whatever its numbers, and %s read so; %s.%s",
                        held.convention().amiss(), held.convention().done(), percent(held.before()),
                        held.outputs().size() == model.outputs().size() ? "what its sensors measured" : named(held.outputs()),
                        percent(held.after()), held.convention().remedy(), others));
    }

    private static String percent(double part) {
        return part < LEAST ? "less than " + percent(LEAST) : String.format(Locale.ROOT, part < 0.1 ? "%.2g %%" : "%.0f %%", 100 * part);
    }

    private static String named(List<Channel> some) {
        return some.stream().map(Channel::toString).collect(Collectors.joining(" and "));
    }

    /** The part of a long recording in which the model's sensors read most, each beside its own usual level. */
    private Recording liveliest() {
        int n = recording.length();
        if (n <= MOST) {
            return recording;
        }
        double[] level = new double[n + 1];
        for (Channel output : model.outputs()) {
            double[] read = recording.values(output);
            double mean = LostSamples.mean(read);
            double[] x = Arrays.stream(read).map(value -> Double.isNaN(value) ? 0 : value - mean).toArray();
            double square = Arrays.stream(x).map(value -> value * value).sum();
            for (int i = 0; i < n; i++) {
                level[i + 1] += x[i] * x[i] / square;
            }
        }
        Arrays.parallelPrefix(level, Double::sum);
        int from = IntStream.iterate(0, at -> at + MOST <= n, at -> at + MOST / 4).boxed()
                .max(Comparator.comparingDouble(at -> level[at + MOST] - level[at])).orElseThrow();
        return recording.part(from, from + MOST);
    }
}

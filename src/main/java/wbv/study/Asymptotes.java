package wbv.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BiConsumer;
import wbv.filter.CorrectionFunction;
import wbv.filter.CorrectionFunction.Value;
import wbv.filter.Method;
import wbv.filter.model.Spec;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.recording.TableText;
import wbv.recording.inspect.Inspection;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;

/**
 * Where the extended filter and the adapted one converge on a recording, by their asymptotic correction functions
 * (Ljung 1979; Figures 4-6 to 4-8 of the thesis): along frequency, along damping, and in the plane of both.
 */
public final class Asymptotes {

    /** The recording's first minutes say enough [s]. */
    private static final double LONGEST = 120;
    private static final int LINE = 41;
    private static final double LOW = 1;
    private static final double HIGH = 15;
    private static final double LIGHT = 0.05;
    private static final double HEAVY = 0.95;
    private static final int COLUMNS = 10;
    private static final int ROWS = 7;
    private static final double[][] STARTS = {{1.5, 0.1}, {3, 0.8}, {5, 0.4}, {9, 0.15}, {14, 0.9}};

    /** One filter: its name, its function along both axes through the rest, in the plane, and where it went from each start. */
    public record Portrait(String name, List<Value> alongFrequency, List<Value> alongDamping, List<Value> plane, List<Value> ends) {}

    private final Channel input;
    private final Channel output;
    private final double seconds;
    private final List<Portrait> portraits = new ArrayList<>();

    private Asymptotes(Channel input, Channel output, double seconds) {
        this.input = input;
        this.output = output;
        this.seconds = seconds;
    }

    /**
     * Works the functions out and writes {@code asymptotes.csv} and {@code results.json}.
     *
     * @param request its designs are not used
     * @throws DataFault if the recording does not have the channels, or is too short
     */
    public static Asymptotes run(TrackingRequest request, OutputFolder out, BiConsumer<String, Double> progress)
            throws IOException {
        Inspection inspection = request.source().inspect(share -> progress.accept("reading", share));
        List<Channel> channels = List.copyOf(inspection.summaries().keySet());
        Channel input = request.channels().chooseInput(channels, inspection.name());
        List<Channel> outputs = request.channels().chooseOutputs(channels, input, inspection.name());
        Channel output = outputs.stream().filter(channel -> channel.location().equals("head")).findFirst()
                .orElse(outputs.get(outputs.size() - 1));
        inspection.require(input);
        inspection.require(output);
        Recording recording = request.source().load(inspection);
        double rate = inspection.clock().rate();
        int samples = (int) Math.min(recording.values(input).length, LONGEST * rate);
        double[] u = Arrays.copyOf(recording.values(input), samples);
        double[] y = Arrays.copyOf(recording.values(output), samples);
        Spec spec = request.spec(input.quantity() == Quantity.ANGULAR_RATE ? Quantity.ANGULAR_RATE : Quantity.ACCELERATION, rate);
        Asymptotes asymptotes = new Asymptotes(input, output, samples / rate);
        try {
            asymptotes.portraits.add(portrait(Method.EKF, new CorrectionFunction(spec, u, y, false), progress, 0));
            asymptotes.portraits.add(portrait(Method.EKF_ADWIN, new CorrectionFunction(spec, u, y, true), progress, 0.5));
        } catch (IllegalArgumentException tooShort) {
            throw DataFault.in(inspection.name(), tooShort.getMessage());
        }
        asymptotes.write(request, out);
        return asymptotes;
    }

    private static Portrait portrait(Method method, CorrectionFunction function, BiConsumer<String, Double> progress,
            double done) {
        List<Value> ends = new ArrayList<>();
        for (double[] start : STARTS) {
            progress.accept("following " + method.word(), done + 0.3 * ends.size() / STARTS.length);
            ends.add(function.converge(start[0], start[1]));
        }
        Value rest = rest(ends);
        List<Value> alongFrequency = new ArrayList<>();
        List<Value> alongDamping = new ArrayList<>();
        List<Value> plane = new ArrayList<>();
        for (int i = 0; i < LINE; i++) {
            progress.accept("drawing " + method.word(), done + 0.3 + 0.1 * i / LINE);
            alongFrequency.add(function.at(between(LOW, HIGH, i, LINE), rest.damping()));
            alongDamping.add(function.at(rest.frequency(), between(LIGHT, HEAVY, i, LINE)));
        }
        for (int i = 0; i < COLUMNS * ROWS; i++) {
            plane.add(function.at(between(LOW, HIGH, i % COLUMNS, COLUMNS), between(LIGHT, HEAVY, i / COLUMNS, ROWS)));
        }
        return new Portrait(method.word(), alongFrequency, alongDamping, plane, ends);
    }

    /** The stable rest that explains most, or the end that does. */
    private static Value rest(List<Value> ends) {
        return ends.stream().min((a, b) -> a.stable() == b.stable() ? Double.compare(a.meanSquare(), b.meanSquare())
                : a.stable() ? -1 : 1).orElseThrow();
    }

    /** Evenly in the logarithm. */
    private static double between(double low, double high, int i, int count) {
        return low * Math.pow(high / low, i / (count - 1.0));
    }

    private void write(TrackingRequest request, OutputFolder out) throws IOException {
        StringBuilder csv = new StringBuilder();
        request.provenance().forEach((name, value) -> csv.append("# ").append(TableText.comment(name + ": " + value)).append('\n'));
        csv.append("estimator,part,frequency_Hz,damping,f_ln_omega,f_ln_zeta,move_ln_omega,move_ln_zeta,innovation_ms,stable\n");
        for (Portrait portrait : portraits) {
            lines(csv, portrait.name(), "frequency", portrait.alongFrequency());
            lines(csv, portrait.name(), "damping", portrait.alongDamping());
            lines(csv, portrait.name(), "plane", portrait.plane());
            lines(csv, portrait.name(), "end", portrait.ends());
        }
        AtomicFile.write(out.file("asymptotes.csv"), csv);
        ResultsJson.write(new Facts(request.title(), input.toString(), output.toString(), seconds,
                portraits.stream().map(Asymptotes::facts).toList(), request.provenance()), out.file("results.json"));
    }

    private static void lines(StringBuilder csv, String name, String part, List<Value> values) {
        for (Value v : values) {
            csv.append(name + "," + part + "," + v.frequency() + "," + v.damping() + "," + v.correction()[0] + ","
                    + v.correction()[1]
                    + "," + v.move()[0] + "," + v.move()[1] + "," + v.meanSquare() + "," + (v.stable() ? 1 : 0) + "\n");
        }
    }

    /** {@code results.json}. */
    record Facts(String recording, String input, String output, double duration_s, List<FilterFacts> filters,
            Map<String, String> provenance) {}

    /** Where one filter comes to rest. */
    record FilterFacts(String estimator, double rest_frequency_hz, double rest_damping_ratio, boolean stable, int starts,
            int starts_that_end_there) {}

    private static FilterFacts facts(Portrait portrait) {
        Value rest = rest(portrait.ends());
        return new FilterFacts(portrait.name(), rest.frequency(), rest.damping(), rest.stable(), portrait.ends().size(),
                (int) portrait.ends().stream().filter(end -> same(end, rest)).count());
    }

    /** Where starts end that do not end where the filter rests, each place once. */
    private static List<Value> others(List<Value> ends) {
        List<Value> places = new ArrayList<>(List.of(rest(ends)));
        for (Value end : ends) {
            if (places.stream().noneMatch(place -> same(place, end))) {
                places.add(end);
            }
        }
        return places.subList(1, places.size());
    }

    private static boolean same(Value a, Value b) {
        return Math.abs(a.frequency() / b.frequency() - 1) < 0.01 && Math.abs(a.damping() / b.damping() - 1) < 0.03;
    }

    /** Where each comes to rest, in a few lines of text. */
    public String summary() {
        StringBuilder text = new StringBuilder(input + " to " + output + ":\n");
        for (Portrait portrait : portraits) {
            FilterFacts facts = facts(portrait);
            text.append(String.format(Locale.ROOT, "  %-10s rests at %.3f Hz, damping ratio %.4f%s; %d of %d starts end there%n",
                    facts.estimator(), facts.rest_frequency_hz(), facts.rest_damping_ratio(), facts.stable() ? ""
                            : " (not stable)",
                    facts.starts_that_end_there(), facts.starts()));
            for (Value other : others(portrait.ends())) {
                text.append(String.format(Locale.ROOT, "  %-10s %d of them at %.3f Hz, damping ratio %.4f%s%n", "",
                        portrait.ends().stream().filter(end -> same(end, other)).count(), other.frequency(), other.damping(),
                        other.stable() ? "" : " (not stable)"));
            }
        }
        return text.toString();
    }

    /** What moves the body. */
    public Channel input() {
        return input;
    }

    /** What answers. */
    public Channel output() {
        return output;
    }

    /** Length of the stretch that was looked at [s]. */
    public double seconds() {
        return seconds;
    }

    /** One for each estimator. */
    public List<Portrait> portraits() {
        return portraits;
    }
}

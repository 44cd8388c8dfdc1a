package wbv.recording;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Text exported by Xsens MT Manager, one sensor a file, tabs or commas: comment lines {@code //}, a header
 * {@code PacketCounter SampleTimeFine Acc_X …} (older: {@code Counter}), rows. The time is the packet counter over the update
 * rate; exports of 2019 and later do not state it, then it is inferred from {@code SampleTimeFine} where that is filled in.
 */
final class MtManagerFormat implements Format {

    private static final List<String> COUNTERS = List.of("PacketCounter", "Counter", "SampleTimeFine");
    private static final Pattern SERIAL = Pattern.compile(".*?([0-9A-Fa-f]{8})");
    private static final double COUNTER_RANGE = 65_536;

    @Override
    public boolean recognises(Head head) {
        String header = head.firstAfter("//");
        List<String> names = Table.names(header, Table.separator(header));
        return head.first().startsWith("//") || COUNTERS.stream().anyMatch(names::contains);
    }

    @Override
    public RowReader open(Source source, Context context) throws IOException {
        Lines lines = new Lines(source);
        List<String> comments = new ArrayList<>();
        boolean header = false;
        while (!header && lines.next()) {
            String line = lines.text().strip();
            header = !line.isEmpty() && !line.startsWith("//");
            if (!header) {
                comments.add(line.replaceFirst("^/+", "").strip());
            }
        }
        char separator = Table.separator(lines.text());
        List<String> names = Table.names(lines.text(), separator);
        String counter = COUNTERS.stream().filter(names::contains).findFirst().orElseThrow(() -> DataFault.at(source.name(),
                lines.line(), "the header has no PacketCounter; export it from MT Manager with the packet counter"));
        Header.requireDistinct(source.name(), lines.line(), names);
        Metadata file = Provenance.parse(comments);
        OptionalDouble stated = stated(file.notes());
        OptionalDouble rate = context.rate(stated);
        if (rate.isEmpty()) {
            rate = inferred(Head.of(source), names, counter, separator);
        }
        double hertz = rate.orElseThrow(() -> DataFault.in(source.name(),
                "states no Update Rate and has no SampleTimeFine to infer it from; say the rate in Hz with --rate"));
        boolean clock = counter.equals("SampleTimeFine");
        String serial = serial(context);
        String location = context.location(serial);
        SensorColumns columns = SensorColumns.of(names, counter, location, "rad/s");
        if (columns.channels().isEmpty()) {
            throw DataFault.at(source.name(), lines.line(), "the header names no Acc_, FreeAcc_, Gyr_, Mag_, Quat_ or Mat column");
        }
        Map<String, String> notes = new LinkedHashMap<>(file.notes());
        Metadata metadata = context.metadata(new Metadata(rate, Map.of(location, serial), file.subject(), file.task(),
                file.dailyMinutes(), file.source().isPresent() ? file.source() : Optional.of("MT Manager export"), notes));
        Table table = new Table(lines, names, columns.slots(), separator, '/');
        double tick = tick(Head.of(source), names, separator);
        return new SensorReader(table, columns, metadata, clock ? tick : hertz, clock ? 4_294_967_296.0 : COUNTER_RANGE);
    }

    private static OptionalDouble stated(Map<String, String> notes) {
        for (Map.Entry<String, String> note : notes.entrySet()) {
            String key = note.getKey().toLowerCase(Locale.ROOT);
            if (key.equals("update rate") || key.equals("sample rate")) {
                Matcher number = Pattern.compile("([0-9.]+)\\s*(Hz)?").matcher(note.getValue());
                if (number.matches() && Double.parseDouble(number.group(1)) > 0) {
                    return OptionalDouble.of(Double.parseDouble(number.group(1)));
                }
            }
        }
        return OptionalDouble.empty();
    }

    private static String serial(Context context) {
        String bare = context.path().getFileName().toString().replaceFirst("\\..*$", "");
        Matcher serial = SERIAL.matcher(bare);
        return serial.matches() ? serial.group(1) : bare;
    }

    /** The rate by the sample times of the first rows; empty where they are blank. */
    private static OptionalDouble inferred(Head head, List<String> names, String counter, char separator) {
        double[] times = column(head, names, "SampleTimeFine", separator);
        double[] counts = column(head, names, counter, separator);
        if (times.length < 2 || counts.length != times.length) {
            return OptionalDouble.empty();
        }
        double[] steps = new double[times.length - 1];
        for (int i = 0; i < steps.length; i++) {
            double count = counter.equals("SampleTimeFine") ? 1 : counts[i + 1] - counts[i];
            steps[i] = (times[i + 1] - times[i]) / Math.max(count, 1);
        }
        Arrays.sort(steps);
        double median = steps[steps.length / 2];
        return median > 0 ? OptionalDouble.of(tick(head, names, separator) / median) : OptionalDouble.empty();
    }

    /** What SampleTimeFine counts: 0.1 ms in MT Manager's exports; µs where steps are too long to be that. */
    private static double tick(Head head, List<String> names, char separator) {
        double[] times = column(head, names, "SampleTimeFine", separator);
        return times.length > 1 && (times[times.length - 1] - times[0]) / (times.length - 1) > 2500 ? 1e6 : 1e4;
    }

    private static double[] column(Head head, List<String> names, String name, char separator) {
        int index = names.indexOf(name);
        return index < 0 ? new double[0] : head.lines().stream().map(line -> line.split(String.valueOf(separator), -1))
                .filter(cells -> cells.length > index && cells[index].strip().matches("\\d+")).limit(300)
                .mapToDouble(cells -> Double.parseDouble(cells[index].strip())).toArray();
    }
}

package wbv.recording.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Header;
import wbv.recording.Metadata;
import wbv.recording.Provenance;
import wbv.recording.RowReader;

/**
 * Text exported by Xsens MT Manager, one sensor a file, tabs or commas: comment lines {@code //}, a header
 * {@code PacketCounter SampleTimeFine Acc_X …} (older: {@code Counter}), rows. The time is the packet counter over the update
 * rate; exports of 2019 and later do not state it, then it is inferred from {@code SampleTimeFine} where that is filled in.
 */
final class MtManagerFormat implements Format {

    private static final String CLOCK = "SampleTimeFine";
    private static final List<String> COUNTERS = List.of("PacketCounter", "Counter", CLOCK);
    private static final Pattern SERIAL = Pattern.compile(".*?([0-9A-Fa-f]{8})");
    private static final double COUNTER_RANGE = 65_536;
    private static final double CLOCK_RANGE = 4_294_967_296.0;
    private static final Pattern HERTZ = Pattern.compile("([0-9]+(?:[.,][0-9]+)?)\\s*(?:Hz)?");

    @Override
    public boolean recognises(Head head) {
        String header = head.firstAfter("//");
        List<String> names = DelimitedTable.names(header, DelimitedTable.separator(header));
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
        char separator = DelimitedTable.separator(lines.text());
        List<String> names = DelimitedTable.names(lines.text(), separator);
        Header.requireDistinct(source.name(), lines.line(), names);
        String counter = COUNTERS.stream().filter(names::contains).findFirst().orElseThrow(() -> DataFault.at(source.name(),
                lines.line(), "the header has no PacketCounter; export it from MT Manager with the packet counter"));
        String serial = serial(context);
        String location = context.location(serial);
        SensorColumns columns = SensorColumns.of(names, counter, location, "rad/s");
        if (columns.channels().isEmpty()) {
            throw DataFault.at(source.name(), lines.line(),
                    "the header names no Acc_, FreeAcc_, Gyr_, Mag_, Quat_ or Mat column");
        }
        Map<String, String> notes = Provenance.parse(comments).notes();
        FirstRows first = new FirstRows(Head.of(source), names, separator);
        OptionalDouble stated = context.rate(stated(notes));
        OptionalDouble rate = stated.isPresent() ? stated : first.rate(counter);
        double hertz = rate.orElseThrow(() -> DataFault.in(source.name(),
                "states no Update Rate and has no SampleTimeFine to infer it from; say the rate in Hz with --rate"));
        Metadata metadata = context.metadata(new Metadata(rate, Map.of(location, serial), Optional.empty(), Optional.empty(),
                OptionalDouble.empty(), Optional.of("MT Manager export"), columns.notes(notes)));
        DelimitedTable table = new DelimitedTable(lines, names, columns.slots(), separator, '/');
        boolean clock = counter.equals(CLOCK);
        return new SensorReader(table, columns, metadata, clock ? first.tick() : hertz, clock ? CLOCK_RANGE : COUNTER_RANGE,
                Double.POSITIVE_INFINITY);
    }

    private static OptionalDouble stated(Map<String, String> notes) {
        for (Map.Entry<String, String> note : notes.entrySet()) {
            String key = note.getKey().toLowerCase(Locale.ROOT);
            if (key.equals("update rate") || key.equals("sample rate")) {
                Matcher number = HERTZ.matcher(note.getValue());
                double rate = number.matches() ? Double.parseDouble(number.group(1).replace(',', '.')) : 0;
                return Clock.isRate(rate) ? OptionalDouble.of(rate) : OptionalDouble.empty();
            }
        }
        return OptionalDouble.empty();
    }

    private static String serial(Context context) {
        String bare = context.path().getFileName().toString().replaceFirst("\\..*$", "");
        Matcher serial = SERIAL.matcher(bare);
        return serial.matches() ? serial.group(1) : bare;
    }

    /** The first rows, for what can be told from their sample times. */
    private record FirstRows(Head head, List<String> names, char separator) {

        /** The rate [Hz]; empty where the sample times are blank. */
        private OptionalDouble rate(String counter) {
            double[] times = column(CLOCK);
            double[] counts = column(counter);
            if (times.length < 2 || counts.length != times.length) {
                return OptionalDouble.empty();
            }
            double[] steps = new double[times.length - 1];
            for (int i = 0; i < steps.length; i++) {
                double count = counter.equals(CLOCK) ? 1 : counts[i + 1] - counts[i];
                steps[i] = (times[i + 1] - times[i]) / Math.max(count, 1);
            }
            Arrays.sort(steps);
            double median = steps[steps.length / 2];
            return Clock.isRate(tick() / median) ? OptionalDouble.of(tick() / median) : OptionalDouble.empty();
        }

        /** Ticks of SampleTimeFine in a second: 0.1 ms each in MT Manager's exports, 1 µs where steps are too long for that. */
        private double tick() {
            double[] times = column(CLOCK);
            return times.length > 1 && (times[times.length - 1] - times[0]) / (times.length - 1) > 2500 ? 1e6 : 1e4;
        }

        private double[] column(String name) {
            int index = names.indexOf(name);
            return index < 0 ? new double[0] : head.lines().stream().map(line -> line.split(String.valueOf(separator), -1))
                    .filter(cells -> cells.length > index && cells[index].strip().matches("\\d+")).limit(300)
                    .mapToDouble(cells -> Double.parseDouble(cells[index].strip())).toArray();
        }
    }
}

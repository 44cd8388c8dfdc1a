package wbv.recording.format;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Header;
import wbv.recording.Metadata;
import wbv.recording.RowReader;

/**
 * CSV of an Xsens or Movella DOT, one sensor a file: perhaps {@code sep=,}, lines {@code key:,value}, a header
 * {@code PacketCounter,SampleTimeFine,…}, rows. The time is SampleTimeFine, in µs, which wraps at 2³²; angular rates are in °/s.
 */
final class DotFormat implements Format {

    private static final double MICROSECONDS = 1e6;
    /** A DOT sends 1 row a second at least. */
    private static final double SLOWEST = MICROSECONDS;
    private static final double RANGE = 4_294_967_296.0;

    @Override
    public boolean recognises(Head head) {
        boolean own = head.first().startsWith("sep=") || head.lines().stream().limit(15)
                .anyMatch(line -> line.startsWith("DeviceTag") || line.startsWith("PacketCounter") && dotNames(line));
        return own && head.lines().stream().limit(40).anyMatch(line -> line.startsWith("PacketCounter"));
    }

    private static boolean dotNames(String header) {
        return header.contains("Euler_X") || header.contains("Quat_W") || header.contains("dq_W") || header.contains("dv[");
    }

    @Override
    public RowReader open(Source source, Context context) throws IOException {
        Lines lines = new Lines(source);
        Map<String, String> notes = new LinkedHashMap<>();
        while (lines.next() && !lines.text().startsWith("PacketCounter")) {
            String[] pair = lines.text().split("[,;\t]", 2);
            String key = pair[0].strip().replaceFirst(":$", "");
            if (pair.length == 2 && pair[0].strip().endsWith(":") && !pair[1].isBlank()) {
                notes.put(key, pair[1].strip());
            }
        }
        char separator = DelimitedTable.separator(lines.text());
        List<String> names = DelimitedTable.names(lines.text(), separator);
        Header.requireDistinct(source.name(), lines.line(), names);
        if (!names.contains("SampleTimeFine")) {
            throw DataFault.at(source.name(), lines.line(), "the header has no SampleTimeFine; export it with the sample time");
        }
        String tag = notes.getOrDefault("DeviceTag", bare(context));
        String location = context.location(tag);
        SensorColumns columns = SensorColumns.of(names, "SampleTimeFine", location, "deg/s");
        if (columns.channels().isEmpty()) {
            throw DataFault.at(source.name(), lines.line(),
                    "the header names no Acc_, FreeAcc_, Gyr_, Mag_, Quat_ or Euler_ column");
        }
        Metadata metadata = new Metadata(rate(notes), Map.of(location, tag), Optional.empty(), Optional.empty(),
                OptionalDouble.empty(), Optional.of("Xsens DOT export"), columns.notes(notes));
        return new SensorReader(new DelimitedTable(lines, names, columns.slots(), separator, '#'), columns, context.metadata(metadata),
                MICROSECONDS, RANGE, SLOWEST);
    }

    private static String bare(Context context) {
        return context.path().getFileName().toString().replaceFirst("\\..*$", "");
    }

    private static OptionalDouble rate(Map<String, String> notes) {
        String text = notes.getOrDefault("OutputRate", "").toLowerCase(Locale.ROOT);
        text = text.endsWith("hz") ? text.substring(0, text.length() - 2).strip() : text;
        return text.matches("[0-9]+(\\.[0-9]+)?") && Clock.isRate(Double.parseDouble(text)) ? OptionalDouble.of(Double.parseDouble(text))
                : OptionalDouble.empty();
    }
}

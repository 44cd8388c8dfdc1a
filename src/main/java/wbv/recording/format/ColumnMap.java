package wbv.recording.format;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Json;
import wbv.recording.Quantity;
import wbv.recording.Unit;

/**
 * Which columns of a foreign table are which channels, in which unit. As JSON:
 *
 * <pre>{@code
 * {"time": {"column": "t_ms", "unit": "ms"},
 *  "channels": {"seat.acc.z": {"column": "Az", "unit": "g", "scale": -1}},
 *  "patterns": [{"column": "{location}_w{axis}_dps", "channel": "{location}.gyr.{axis}", "unit": "deg/s"}]}
 * }</pre>
 *
 * <p>A table without a column of times has {@code "time": {"rate_hz": 100}} instead; a file that knows its times or its rate, such as a
 * WAV, needs no {@code time}. {@code "from_zero": true} counts times from the first row's. {@code scale} multiplies after the unit; -1
 * turns an axis round, and of a WAV it is what full scale means. {@code questions} are what a draft ({@link MapDraft}) could not know; they
 * change nothing.
 *
 * @param name     what the map is called in messages: its file
 * @param time     where the time comes from
 * @param channels the column of each channel that is named one by one
 * @param patterns rules for many columns, tried in order on those not named
 */
public record ColumnMap(String name, Time time, Map<Channel, Column> channels, List<ColumnPattern> patterns) {

    public ColumnMap {
        channels = Collections.unmodifiableMap(new LinkedHashMap<>(channels));
        patterns = List.copyOf(patterns);
        if (channels.isEmpty() && patterns.isEmpty()) {
            throw DataFault.in(name, "'channels' must name at least one column, or 'patterns' hold one pattern");
        }
    }

    /**
     * Where the time comes from: a column, or the row's number over a rate, or neither, but from the file itself.
     *
     * @param fromZero true to count from the first row's time
     */
    public record Time(Optional<Column> column, OptionalDouble rate, boolean fromZero) {
        public Time {
            if (column.isPresent() && rate.isPresent()) {
                throw new IllegalArgumentException("the time comes either from a column or from a rate");
            }
        }

        /** Whether the file is to say it. */
        boolean own() {
            return column.isEmpty() && rate.isEmpty();
        }
    }

    /**
     * A column of the table.
     *
     * @param name  in its header
     * @param unit  what its numbers are in
     * @param scale factor by which they are multiplied further
     */
    public record Column(String name, String unit, double scale) {
        public Column {
            if (!Double.isFinite(scale) || scale == 0) {
                throw new IllegalArgumentException("scale must be finite and not 0: " + scale);
            }
        }
    }

    /** The same with another time. */
    ColumnMap timed(Time other) {
        return new ColumnMap(name, other, channels, patterns);
    }

    /**
     * Reads a map from a JSON file.
     *
     * @throws DataFault if it is none, naming the field
     */
    public static ColumnMap read(Path path) throws IOException {
        Json json = Json.read(path);
        json.only("comment", "questions", "time", "channels", "patterns");
        Map<Channel, Column> channels = new LinkedHashMap<>();
        json.object("channels").ifPresent(all -> all.objects().forEach(
                (channel, column) -> channels.put(channel(all, channel), column(column, channel(all, channel).quantity().unit()))));
        return new ColumnMap(path.toString(), time(json), channels, patterns(json));
    }

    private static Time time(Json json) {
        if (!json.has("time")) {
            return new Time(Optional.empty(), OptionalDouble.empty(), false);
        }
        Json time = json.object("time").orElseThrow();
        time.only("column", "unit", "scale", "rate_hz", "from_zero");
        boolean fromZero = time.text("from_zero").map(Boolean::parseBoolean).orElse(false);
        OptionalDouble rate = time.number("rate_hz", Clock.SLOWEST, Clock.FASTEST);
        if (rate.isPresent() == time.has("column")) {
            throw json.fault("time", "must have either 'column' or 'rate_hz'");
        }
        return new Time(rate.isPresent() ? Optional.empty() : Optional.of(columnIn(time, "s")), rate, fromZero);
    }

    private static Column column(Json json, String dimension) {
        json.only("column", "unit", "scale");
        return columnIn(json, dimension);
    }

    private static Column columnIn(Json json, String dimension) {
        String name = json.text("column").orElseThrow(() -> json.fault("column", "is missing: the name of a column"));
        return new Column(name, unit(json, dimension), scale(json));
    }

    private static String unit(Json json, String dimension) {
        String unit = json.text("unit").orElse(dimension);
        if (unit.equals(MapDraft.OPEN)) {
            throw json.fault("unit", "is still to be answered: write one of " + Unit.symbols(dimension) + " in place of '" + unit + "'");
        }
        Unit.of(unit).filter(known -> known.dimension().equals(dimension))
                .orElseThrow(() -> json.fault("unit", "must be one of " + Unit.symbols(dimension) + ": '" + unit + "'"));
        return unit;
    }

    private static double scale(Json json) {
        double scale = json.number("scale", -1e12, 1e12).orElse(1);
        if (scale == 0) {
            throw json.fault("scale", "must not be 0");
        }
        return scale;
    }

    private static Channel channel(Json json, String name) {
        try {
            return Channel.parse(name);
        } catch (IllegalArgumentException wrong) {
            throw json.fault(name, "names no channel: " + wrong.getMessage());
        }
    }

    private static List<ColumnPattern> patterns(Json json) {
        List<ColumnPattern> patterns = new ArrayList<>();
        if (!json.has("patterns")) {
            return patterns;
        }
        JsonNode list = json.node().get("patterns");
        if (!list.isArray()) {
            throw json.fault("patterns", "must be a list [{…}, …]");
        }
        for (int i = 0; i < list.size(); i++) {
            Json item = new Json(json.file(), "patterns[" + i + "]", list.get(i));
            item.only("column", "channel", "unit", "scale");
            String column = item.text("column").orElseThrow(() -> item.fault("column", "is missing: {location}_a{axis}, say"));
            String channel = item.text("channel").orElseThrow(() -> item.fault("channel",
                    "is missing: {location}.acc.{axis}, say"));
            Quantity quantity = ColumnPattern.quantity(channel).orElseThrow(() -> item.fault("channel",
                    "must be location.quantity.axis, with {location} and {axis} where they vary: '" + channel + "'"));
            try {
                patterns.add(new ColumnPattern(column, channel, unit(item, quantity.unit()), scale(item)));
            } catch (IllegalArgumentException wrong) {
                throw item.fault("column", "is no pattern: " + wrong.getMessage());
            }
        }
        return patterns;
    }
}

package wbv.recording.format;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import wbv.recording.AtomicFile;
import wbv.recording.AxisSigns;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Json;
import wbv.recording.Metadata;
import wbv.recording.signals.UnitWords;

/**
 * What stands in {@code name.json} beside {@code name.csv}: everything that no column can hold.
 *
 * <pre>{@code
 * {"rate_hz": 60, "task": "haul road, loaded", "daily_minutes": 380, "source": "…",
 *  "subject": {"mass_kg": 79.4, "height_m": 1.8, "age": 44, "sex": "male"},
 *  "serials": {"seat": "00B42235"}, "locations": {"00B42235": "seat"},
 *  "axis_signs": {"seat": {"y": -1, "z": -1}}, "units": {"t": "ms", "seat.acc": "g"}, "notes": {"firmware": "4.0.2"}}
 * }</pre>
 *
 * @param metadata  what it says about the recording
 * @param locations location by sensor serial, device tag or file name
 * @param signs     by location, the axes that a sensor was mounted the wrong way round on, as factors of x, y and z
 * @param units     what the numbers of a table are in, by {@code t}, channel, {@code place.quantity} or quantity
 */
public record Sidecar(Metadata metadata, Map<String, String> locations, Map<String, AxisSigns> signs, Map<String, String> units) {

    /** Nothing beside the file. */
    public static final Sidecar NONE = new Sidecar(Metadata.NONE, Map.of(), Map.of(), Map.of());

    public Sidecar {
        locations = Map.copyOf(locations);
        signs = Map.copyOf(signs);
        units = Collections.unmodifiableMap(new LinkedHashMap<>(units));
    }

    /** Where the sidecar of a recording is, or would be. */
    public static Path beside(Path recording) {
        String name = recording.getFileName().toString();
        String bare = name.toLowerCase(Locale.ROOT).endsWith(".gz") ? name.substring(0, name.length() - 3) : name;
        int dot = bare.lastIndexOf('.');
        return recording.resolveSibling((dot > 0 ? bare.substring(0, dot) : bare) + ".json");
    }

    /**
     * The sidecar of a recording; {@link #NONE} where there is no such file.
     *
     * @throws DataFault naming the field that is wrong
     */
    public static Sidecar of(Path recording) throws IOException {
        Path path = beside(recording);
        return Files.isRegularFile(path) ? read(path) : NONE;
    }

    /**
     * Reads a sidecar.
     *
     * @throws DataFault naming the field that is wrong
     */
    public static Sidecar read(Path path) throws IOException {
        Json json = Json.read(path);
        json.only("comment", "rate_hz", "serials", "locations", "axis_signs", "units", "subject", "task", "daily_minutes", "source",
                "notes");
        Map<String, AxisSigns> signs = new LinkedHashMap<>();
        json.object("axis_signs").ifPresent(all -> all.objects().forEach((location, axes) -> {
            axes.only("x", "y", "z");
            signs.put(location, new AxisSigns(sign(axes, "x"), sign(axes, "y"), sign(axes, "z")));
        }));
        Metadata metadata = new Metadata(json.number("rate_hz", Clock.SLOWEST, Clock.FASTEST), json.texts("serials"),
                json.object("subject").map(Sidecar::subject), json.text("task"), json.number("daily_minutes", 0, 1440),
                json.text("source"), json.texts("notes"));
        return new Sidecar(metadata, json.texts("locations"), signs, units(json));
    }

    private static Map<String, String> units(Json json) {
        Map<String, String> units = new LinkedHashMap<>();
        json.texts("units").forEach((key, written) -> units.put(key, UnitWords.of(written).orElseThrow(
                () -> json.fault("units." + key, "is no unit that is known, such as g, m/s2, ms, mm or kN: '" + written + "'"))));
        return units;
    }

    private static Metadata.Subject subject(Json json) {
        json.only("mass_kg", "height_m", "age", "sex");
        return new Metadata.Subject(json.number("mass_kg", 1, 500), json.number("height_m", 0.3, 3), json.number("age", 0, 130),
                json.text("sex"));
    }

    private static int sign(Json axes, String axis) {
        double sign = axes.number(axis, -1, 1).orElse(1);
        if (Math.abs(sign) != 1) {
            throw axes.fault(axis, "must be 1 or -1: " + sign);
        }
        return (int) sign;
    }

    /**
     * Faults a file where the sidecar of a new recording would go, if writing it would lose what only a person can have said: a
     * comment, locations, axis signs and units (which the new recording has behind it), or a file that is no sidecar at all.
     *
     * @param recording that is to be written
     */
    public static void requireReplaceable(Path recording) throws IOException {
        Path path = beside(recording);
        if (!Files.exists(path)) {
            return;
        }
        boolean ours;
        try {
            read(path);
            Json json = Json.read(path);
            ours = !json.has("comment") && !json.has("locations") && !json.has("axis_signs") && !json.has("units");
        } catch (DataFault foreign) {
            ours = false;
        }
        if (!ours) {
            throw DataFault.in(path.toString(), "would be replaced by what is written beside " + recording.getFileName()
                    + "; choose another name for that");
        }
    }

    /** Writes what is known about a recording beside it, unless nothing is known and nothing stands there. */
    public static void writeBeside(Path recording, Metadata metadata) throws IOException {
        Path path = beside(recording);
        if (!metadata.withUnits(Map.of()).equals(Metadata.NONE) || Files.exists(path)) {
            write(path, metadata);
        }
    }

    /** Writes what is known about a recording. */
    public static void write(Path path, Metadata metadata) throws IOException {
        ObjectNode json = Json.MAPPER.createObjectNode();
        metadata.rate().ifPresent(rate -> json.put("rate_hz", rate));
        metadata.task().ifPresent(task -> json.put("task", task));
        metadata.dailyMinutes().ifPresent(minutes -> json.put("daily_minutes", minutes));
        metadata.source().ifPresent(source -> json.put("source", source));
        metadata.subject().ifPresent(subject -> {
            ObjectNode object = json.putObject("subject");
            subject.mass().ifPresent(mass -> object.put("mass_kg", mass));
            subject.height().ifPresent(height -> object.put("height_m", height));
            subject.age().ifPresent(age -> object.put("age", age));
            subject.sex().ifPresent(sex -> object.put("sex", sex));
        });
        put(json, "serials", metadata.serials());
        put(json, "notes", metadata.notes());
        AtomicFile.write(path, Json.MAPPER.writerWithDefaultPrettyPrinter().writeValueAsString(json) + "\n");
    }

    private static void put(ObjectNode json, String field, Map<String, String> texts) {
        if (!texts.isEmpty()) {
            ObjectNode object = json.putObject(field);
            texts.forEach(object::put);
        }
    }

    /** The location that this sidecar gives one of these names of a sensor, tried in order. */
    Optional<String> location(String... names) {
        for (String name : names) {
            if (locations.containsKey(name)) {
                return Optional.of(locations.get(name));
            }
        }
        return Optional.empty();
    }
}

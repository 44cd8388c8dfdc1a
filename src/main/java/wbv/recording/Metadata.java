package wbv.recording;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What no column of a recording can hold. Everything is optional; what is not known is empty. The maps keep their order.
 *
 * @param rate         nominal sampling rate [Hz] that the file states
 * @param serials      sensor serial number by location
 * @param subject      the sitter
 * @param task         what was done, such as {@code haul road, loaded}
 * @param dailyMinutes minutes a day of this task, for exposure
 * @param source       where the samples came from, in words
 * @param notes        anything else, by name: firmware, filter profile, seed
 * @param units        the unit that the file, its sidecar or its map states, by channel or {@code t}; none where SI is taken for granted
 */
public record Metadata(OptionalDouble rate, Map<String, String> serials, Optional<Subject> subject, Optional<String> task,
        OptionalDouble dailyMinutes, Optional<String> source, Map<String, String> notes, Map<String, String> units) {

    /** Nothing known. */
    public static final Metadata NONE = new Metadata(OptionalDouble.empty(), Map.of(), Optional.empty(), Optional.empty(),
            OptionalDouble.empty(), Optional.empty(), Map.of());

    public Metadata {
        if (rate.isPresent() && !Clock.isRate(rate.getAsDouble())) {
            throw new IllegalArgumentException("rate must be " + Clock.SLOWEST + " to " + Clock.FASTEST + " Hz: " + rate.getAsDouble());
        }
        if (dailyMinutes.isPresent() && !(dailyMinutes.getAsDouble() >= 0 && dailyMinutes.getAsDouble() <= 1440)) {
            throw new IllegalArgumentException("daily exposure must be 0 to 1440 minutes: " + dailyMinutes.getAsDouble());
        }
        serials = Collections.unmodifiableMap(new LinkedHashMap<>(serials));
        notes = Collections.unmodifiableMap(new LinkedHashMap<>(notes));
        units = Collections.unmodifiableMap(new LinkedHashMap<>(units));
    }

    /** What is known of a recording of which nobody states a unit. */
    public Metadata(OptionalDouble rate, Map<String, String> serials, Optional<Subject> subject, Optional<String> task,
            OptionalDouble dailyMinutes, Optional<String> source, Map<String, String> notes) {
        this(rate, serials, subject, task, dailyMinutes, source, notes, Map.of());
    }

    /** The same with units that are stated, by channel or {@code t}. */
    public Metadata withUnits(Map<String, String> stated) {
        return new Metadata(rate, serials, subject, task, dailyMinutes, source, notes, stated);
    }

    /** The same with another nominal rate [Hz]. */
    public Metadata withRate(OptionalDouble other) {
        return new Metadata(other, serials, subject, task, dailyMinutes, source, notes, units);
    }

    /** What this one knows, and where it is silent what the other knows. */
    public Metadata orElse(Metadata other) {
        Map<String, String> bothSerials = new LinkedHashMap<>(other.serials);
        bothSerials.putAll(serials);
        Map<String, String> bothNotes = new LinkedHashMap<>(other.notes);
        bothNotes.putAll(notes);
        Map<String, String> bothUnits = new LinkedHashMap<>(other.units);
        bothUnits.putAll(units);
        return new Metadata(rate.isPresent() ? rate : other.rate, bothSerials, subject.or(other::subject), task.or(other::task),
                dailyMinutes.isPresent() ? dailyMinutes : other.dailyMinutes, source.or(other::source), bothNotes, bothUnits);
    }

    /**
     * The sitter.
     *
     * @param mass [kg]
     * @param height [m]
     * @param age [years]
     * @param sex as stated; all may be empty
     */
    public record Subject(OptionalDouble mass, OptionalDouble height, OptionalDouble age, Optional<String> sex) {}
}

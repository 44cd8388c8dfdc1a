package wbv.recording.format;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What the user says about a file beside naming it.
 *
 * @param map       which columns are which channels, for a table that is not named as ours are
 * @param rate      sampling rate [Hz], for a file that does not state it; goes before what file and sidecar state
 * @param locations location by sensor serial, device tag or file name, for files of one sensor; goes before the sidecar's
 */
public record ReadOptions(Optional<ColumnMap> map, OptionalDouble rate, Map<String, String> locations) {

    /** Nothing said. */
    public static final ReadOptions DEFAULT = new ReadOptions(Optional.empty(), OptionalDouble.empty(), Map.of());

    public ReadOptions {
        if (rate.isPresent() && !(rate.getAsDouble() > 0)) {
            throw new IllegalArgumentException("rate must be > 0 Hz: " + rate.getAsDouble());
        }
        locations = Collections.unmodifiableMap(new LinkedHashMap<>(locations));
    }
}

package wbv.study;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.exposure.SeatMeter;
import wbv.recording.inspect.RowSource;

/**
 * A day whose exposure is to be evaluated.
 *
 * @param recordings one for each task, at least one
 * @param setup      what is measured in each
 * @param career     for the risk of the spine
 * @param provenance what the report says of its own making, by name
 */
public record ExposureRequest(List<Recorded> recordings, SeatMeter.Setup setup, Career career, Map<String, String> provenance) {

    public ExposureRequest {
        recordings = List.copyOf(recordings);
        if (recordings.isEmpty()) {
            throw new IllegalArgumentException("a day needs at least one recording");
        }
    }

    /**
     * A recording of a task.
     *
     * @param title   what the report calls the recording
     * @param task    its name; empty to take the sidecar's
     * @param minutes daily; empty to take the sidecar's
     */
    public record Recorded(RowSource source, String title, Optional<String> task, OptionalDouble minutes) {}

    /**
     * Years of daily exposure.
     *
     * @param from age at which it began
     * @param years of it
     * @param days of it a year [days]
     */
    public record Career(int from, int years, double days) {}
}

package wbv.recording.signals;

import java.io.Closeable;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.CalendarTime;

/** An opened file of signals that were sampled together, row by row, each in the unit that it stands in. */
public interface SignalFile extends Closeable {

    /** What is said of each signal. Never empty. */
    List<Label> labels();

    /** The signal that holds the time [s], if one does. */
    Optional<String> time();

    /** What a calendar says at time 0, where the times are dates: known once one was read. */
    default Optional<CalendarTime> origin() {
        return Optional.empty();
    }

    /** Samples per second [Hz], where there is no signal of times but a rate; Parquet states it beside the times. */
    OptionalDouble rate();

    /** What else the file says, by name. */
    Map<String, String> notes();

    /**
     * Reads the next samples.
     *
     * @param row as long as the labels, each number in the unit that it stands in; NaN where missing. Modified.
     * @return false at the end
     * @throws wbv.recording.DataFault if the file is cut off
     */
    boolean read(double[] row) throws IOException;

    /** Share of the file that was read, 0 to 1. */
    double fractionRead();
}

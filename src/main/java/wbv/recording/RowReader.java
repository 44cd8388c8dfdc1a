package wbv.recording;

import java.io.Closeable;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/**
 * A recording read row by row, in the order of the file, with memory that does not grow with its length.
 *
 * <p>A row is {@code 1 + channels().size()} values: the time [s] at index 0, then the channels in their order, in SI units.
 * A cell that is empty, {@code ?} or {@code NaN} is NaN. Rows come as they stand: gaps, duplicates and time running
 * backwards are the {@link wbv.recording.inspect.Inspector}'s and the {@link wbv.recording.inspect.UniformReader}'s business.
 */
public interface RowReader extends Closeable {

    /** The channels, in column order. Never empty. */
    List<Channel> channels();

    /** What the file and its sidecar say beside the samples. */
    Metadata metadata();

    /**
     * Reads the next row.
     *
     * @param row filled with time [s] and values, each in its SI unit, {@code 1 + channels().size()} long. Modified only if a row was read.
     * @return false at the end of the recording
     * @throws DataFault   if a cell is not a number, or a row has too few or too many cells
     * @throws IOException if the file cannot be read on
     */
    boolean read(double[] row) throws IOException;

    /** Line of the file that the last row came from, counted from 1; 0 before the first row or where lines mean nothing. */
    long line();

    /** Share of the recording that was read, 0 to 1, by bytes; NaN where that is unknown. */
    default double fractionRead() {
        return Double.NaN;
    }

    /** Rows before the first sample that the sensor sent without having measured, and that {@link #read} gives none of. */
    default long passedOver() {
        return 0;
    }

    /** What a calendar said at {@code t = 0}, where rows are dated: known once one was read. */
    default Optional<CalendarTime> origin() {
        return Optional.empty();
    }

    /** The sensor's own counter or clock that {@code t} was made from, where it was: holes in it are packets lost. */
    default Optional<SensorClock> sensorClock() {
        return Optional.empty();
    }
}

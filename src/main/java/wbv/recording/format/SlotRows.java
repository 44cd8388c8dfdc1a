package wbv.recording.format;

import java.io.Closeable;
import java.io.IOException;
import java.util.Optional;
import wbv.recording.CalendarTime;
import wbv.recording.DataFault;

/** Rows of numbers in slots, in whatever units the file has. */
interface SlotRows extends Closeable {

    /**
     * Reads the next row into its slots; false at the end.
     *
     * @param row Modified.
     */
    boolean read(double[] row) throws IOException;

    /** A fault at the row that was read last. */
    DataFault fault(String message);

    /** Line of the file that the last row stood on; 0 where lines mean nothing. */
    long line();

    /** What a calendar said at the first row, whose time counts from there; empty where it is a number. */
    default Optional<CalendarTime> origin() {
        return Optional.empty();
    }

    /** Share of the file that was read, 0 to 1. */
    double fractionRead();
}

package wbv.recording.format;

import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.zip.ZipException;
import wbv.recording.DataFault;

/** The lines of a text file as spans of one byte buffer: nothing is allocated per line. */
final class Lines implements Closeable {

    private static final int LONGEST = 1 << 24;

    private final Source source;
    private final InputStream in;
    private byte[] buffer = new byte[1 << 16];
    private int next;
    private int end;
    private int from;
    private int to;
    private long line;

    Lines(Source source) {
        this.source = source;
        this.in = source.content();
    }

    /** Moves to the next line; false at the end of the file. A final line without a line feed counts. */
    boolean next() throws IOException {
        int scan = next;
        while (true) {
            while (scan < end && buffer[scan] != '\n') {
                scan++;
            }
            if (scan < end) {
                break;
            }
            int ahead = scan - next;
            boolean more = fill();
            scan = next + ahead;
            if (!more) {
                if (next == end) {
                    return false;
                }
                break;
            }
        }
        from = next;
        to = scan > from && buffer[scan - 1] == '\r' ? scan - 1 : scan;
        next = Math.min(scan + 1, end);
        line++;
        if (line == 1 && to - from >= 3 && buffer[from] == (byte) 0xEF && buffer[from + 1] == (byte) 0xBB
                && buffer[from + 2] == (byte) 0xBF) {
            from += 3;
        }
        return true;
    }

    private boolean fill() throws IOException {
        if (next > 0) {
            System.arraycopy(buffer, next, buffer, 0, end - next);
            end -= next;
            next = 0;
        }
        if (end == buffer.length) {
            if (end >= LONGEST) {
                throw DataFault.at(source.name(), line + 1, "is longer than 16 MiB; this is not a table of numbers");
            }
            buffer = Arrays.copyOf(buffer, 2 * end);
        }
        try {
            int read = in.read(buffer, end, buffer.length - end);
            end += Math.max(read, 0);
            return read >= 0;
        } catch (EOFException | ZipException damaged) {
            throw Source.damaged(source.name(), damaged);
        }
    }

    /** The buffer that {@link #from} and {@link #to} point into. Not to be modified. */
    byte[] bytes() {
        return buffer;
    }

    int from() {
        return from;
    }

    int to() {
        return to;
    }

    /** Number of the present line, from 1; 0 before the first. */
    long line() {
        return line;
    }

    /** The present line as text. */
    String text() {
        return Head.text(buffer, from, to);
    }

    String name() {
        return source.name();
    }

    double fractionRead() {
        return source.fractionRead();
    }

    @Override
    public void close() throws IOException {
        source.close();
    }
}

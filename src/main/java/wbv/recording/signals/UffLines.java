package wbv.recording.signals;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import wbv.recording.DataFault;

/** A universal file: lines of fixed columns, with bytes between them where a dataset is binary. */
final class UffLines {

    private static final int LONGEST = 1 << 16;

    private final String file;
    private final InputStream in;
    private long line;
    private String text = "";

    UffLines(String file, InputStream content) {
        this.file = file;
        this.in = new BufferedInputStream(content, 1 << 16);
    }

    /** Moves to the next line; false at the end of the file. */
    boolean next() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream(96);
        int b = in.read();
        boolean some = b >= 0;
        while (b >= 0 && b != '\n') {
            if (bytes.size() == LONGEST) {
                throw DataFault.at(file, line + 1, "is longer than 64 KiB; this is no line of a universal file");
            }
            bytes.write(b);
            b = in.read();
        }
        String whole = bytes.toString(StandardCharsets.ISO_8859_1);
        text = whole.endsWith("\r") ? whole.substring(0, whole.length() - 1) : whole;
        line += some ? 1 : 0;
        return some;
    }

    /**
     * The next line.
     *
     * @throws DataFault if there is none
     */
    String required() throws IOException {
        if (!next()) {
            throw DataFault.in(file, "is cut off within a dataset");
        }
        return text;
    }

    /** The present line. */
    String text() {
        return text;
    }

    /** Whether the present line begins or ends a dataset. */
    boolean delimits() {
        return text.strip().equals("-1");
    }

    /**
     * As many bytes as there should be.
     *
     * @throws DataFault if there are fewer
     */
    byte[] bytes(long count) throws IOException {
        if (count < 0 || count > Integer.MAX_VALUE - 8) {
            throw fault("a dataset of " + count + " bytes is not read");
        }
        byte[] read = in.readNBytes((int) count);
        if (read.length < count) {
            throw DataFault.in(file, "is cut off: a dataset states " + count + " bytes and holds " + read.length);
        }
        return read;
    }

    /** The text in some columns of the present line, stripped; {@code NONE} is nothing. */
    String field(int from, int to) {
        String cut = from >= text.length() ? "" : text.substring(from, Math.min(to, text.length())).strip();
        return cut.equalsIgnoreCase("NONE") ? "" : cut;
    }

    /** The whole number in some columns; 0 where they are blank. */
    int whole(int from, int to) {
        String cut = field(from, to);
        try {
            return cut.isEmpty() ? 0 : Integer.parseInt(cut.replaceFirst("^\\+", ""));
        } catch (NumberFormatException other) {
            throw fault("columns " + (from + 1) + " to " + to + " must hold a whole number: '" + cut + "'");
        }
    }

    /** The number in some columns; 0 where they are blank. */
    double number(int from, int to) {
        String cut = field(from, to);
        try {
            return cut.isEmpty() ? 0 : Double.parseDouble(cut.replace('D', 'E').replace('d', 'e'));
        } catch (NumberFormatException other) {
            throw fault("columns " + (from + 1) + " to " + to + " must hold a number: '" + cut + "'");
        }
    }

    DataFault fault(String message) {
        return DataFault.at(file, line, message);
    }
}

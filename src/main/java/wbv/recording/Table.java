package wbv.recording;

import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Rows of delimited cells under known columns. A cell that is empty, {@code ?} or {@code NaN} is NaN; a trailing separator is
 * allowed; blank lines and comment lines are passed over; nothing is allocated per row.
 */
final class Table implements Closeable {

    /** The slot of a column that is not wanted. */
    static final int SKIP = -1;

    private final Lines lines;
    private final List<String> columns;
    private final int[] slots;
    private final char separator;
    private final char comment;
    private final char point;

    /**
     * @param lines   positioned at the header: the next line is the first row
     * @param columns the names of the columns
     * @param slots   where in a row each column's number goes, or {@link #SKIP}
     * @param comment the byte that begins a comment line
     */
    Table(Lines lines, List<String> columns, int[] slots, char separator, char comment) {
        this.lines = lines;
        this.columns = List.copyOf(columns);
        this.slots = slots.clone();
        this.separator = separator;
        this.comment = comment;
        this.point = separator == ',' ? '.' : ',';
    }

    /** The separator that a header line uses: tab, semicolon or comma, whichever comes first in that order. */
    static char separator(String header) {
        return header.indexOf('\t') >= 0 ? '\t' : header.indexOf(';') >= 0 ? ';' : ',';
    }

    /** The names of a header line, without blanks and quotes around them; a trailing separator names nothing. */
    static List<String> names(String header, char separator) {
        List<String> names = new ArrayList<>();
        for (String cell : header.split(String.valueOf(separator), -1)) {
            String name = cell.strip();
            boolean quoted = name.length() >= 2 && name.charAt(0) == '"' && name.endsWith("\"");
            names.add(quoted ? name.substring(1, name.length() - 1).strip() : name);
        }
        if (names.size() > 1 && names.get(names.size() - 1).isEmpty()) {
            names.remove(names.size() - 1);
        }
        return names;
    }

    /**
     * Reads the next row into its slots; false at the end.
     *
     * @throws DataFault if a wanted cell is not a number, or the row has too few or too many cells
     */
    boolean read(double[] row) throws IOException {
        do {
            if (!lines.next()) {
                return false;
            }
        } while (passedOver());
        byte[] text = lines.bytes();
        int position = lines.from();
        int to = lines.to();
        int last = slots.length - 1;
        for (int column = 0; column <= last; column++) {
            int stop = cellEnd(text, position, to);
            if (stop == to && column < last) {
                throw ragged(column + 1);
            }
            if (slots[column] != SKIP) {
                row[slots[column]] = number(text, position, stop, column);
            }
            position = stop + 1;
        }
        while (position < to && text[position] == ' ') {
            position++;
        }
        if (position < to) {
            throw ragged(names(lines.text(), separator).size());
        }
        return true;
    }

    private boolean passedOver() {
        byte[] text = lines.bytes();
        int i = lines.from();
        while (i < lines.to() && (text[i] == ' ' || text[i] == '\t')) {
            i++;
        }
        return i == lines.to() || text[i] == comment;
    }

    private int cellEnd(byte[] text, int from, int to) {
        int i = from;
        if (i < to && text[i] == '"') {
            i++;
            while (i < to && text[i] != '"') {
                i++;
            }
        }
        while (i < to && text[i] != separator) {
            i++;
        }
        return i;
    }

    private double number(byte[] text, int start, int stop, int column) {
        int from = start;
        int to = stop;
        while (from < to && (text[from] == ' ' || text[from] == '"')) {
            from++;
        }
        while (to > from && (text[to - 1] == ' ' || text[to - 1] == '"')) {
            to--;
        }
        if (from == to || to - from == 1 && text[from] == '?') {
            return Double.NaN;
        }
        try {
            return Decimal.parse(text, from, to, point);
        } catch (NumberFormatException notNumber) {
            throw fault("column " + columns.get(column) + " must be a finite number, or empty where it is missing: '"
                    + shortened(text, from, to) + "'");
        }
    }

    private static String shortened(byte[] text, int from, int to) {
        String cell = new String(text, from, Math.min(to - from, 40), StandardCharsets.UTF_8);
        return to - from > 40 ? cell + "…" : cell;
    }

    private DataFault ragged(int cells) {
        return fault("the row has " + cells + (cells == 1 ? " cell" : " cells") + " where the header names " + slots.length
                + "; mend or remove the line");
    }

    /** A fault at the line that was read last. */
    DataFault fault(String message) {
        return DataFault.at(lines.name(), lines.line(), message);
    }

    /** Line of the file that the last row stood on. */
    long line() {
        return lines.line();
    }

    String name() {
        return lines.name();
    }

    double fractionRead() {
        return lines.fractionRead();
    }

    @Override
    public void close() throws IOException {
        lines.close();
    }
}

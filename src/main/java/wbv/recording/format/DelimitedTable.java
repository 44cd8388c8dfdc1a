package wbv.recording.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import wbv.recording.CalendarTime;
import wbv.recording.DataFault;

/**
 * Rows of delimited cells under known columns. A cell that is empty, {@code ?} or {@code NaN} is NaN; a trailing separator is
 * allowed; blank lines and comment lines are passed over; nothing is allocated per row.
 */
final class DelimitedTable implements SlotRows {

    /** The slot of a column that is not wanted. */
    static final int SKIP = Cells.SKIP;

    private final Lines lines;
    private final Cells cells;
    private final char comment;
    private boolean below;

    /**
     * @param lines   positioned at the header: the next line is the first row
     * @param columns the names of the columns
     * @param slots   where in a row each column's number goes, or {@link #SKIP}
     * @param comment the byte that begins a comment line
     */
    DelimitedTable(Lines lines, List<String> columns, int[] slots, char separator, char comment) {
        this.lines = lines;
        this.cells = new Cells(columns, slots, separator);
        this.comment = comment;
    }

    /** Passes over a line without numbers directly below the header: it holds the units. */
    DelimitedTable withUnitsBelow() {
        below = true;
        return this;
    }

    /** Takes dates and times for times, where the column of times holds them. */
    DelimitedTable withTimestamps() {
        cells.stamped();
        return this;
    }

    @Override
    public Optional<CalendarTime> origin() {
        return cells.origin();
    }

    /** The separator that a header line uses: tab, semicolon or comma, whichever comes first in that order. */
    static char separator(String header) {
        return header.indexOf('\t') >= 0 ? '\t' : header.indexOf(';') >= 0 ? ';' : ',';
    }

    /** The names of a header line, without blanks and quotes around them; a trailing separator names nothing. */
    static List<String> names(String header, char separator) {
        List<String> names = new ArrayList<>();
        StringBuilder name = new StringBuilder();
        boolean quoted = false;
        for (char c : header.toCharArray()) {
            if (c == '"') {
                quoted = !quoted;
            } else if (c == separator && !quoted) {
                names.add(name.toString().strip());
                name.setLength(0);
            } else {
                name.append(c);
            }
        }
        names.add(name.toString().strip());
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
    @Override
    public boolean read(double[] row) throws IOException {
        do {
            if (!lines.next()) {
                return false;
            }
        } while (passedOver() || below && cells.areWords(lines.bytes(), lines.from(), lines.to()));
        below = false;
        try {
            cells.read(lines.bytes(), lines.from(), lines.to(), row);
        } catch (DataFault wrong) {
            throw fault(wrong.getMessage());
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

    @Override
    public DataFault fault(String message) {
        return DataFault.at(lines.name(), lines.line(), message);
    }

    @Override
    public long line() {
        return lines.line();
    }

    String name() {
        return lines.name();
    }

    @Override
    public double fractionRead() {
        return lines.fractionRead();
    }

    @Override
    public void close() throws IOException {
        lines.close();
    }
}

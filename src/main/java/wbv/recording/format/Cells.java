package wbv.recording.format;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import wbv.recording.CalendarTime;
import wbv.recording.DataFault;
import wbv.recording.Decimal;

/**
 * One line of delimited cells under known columns, as numbers. A cell that is empty, {@code ?} or {@code NaN} is NaN; a trailing
 * separator is allowed; nothing is allocated.
 */
final class Cells {

    /** The slot of a column that is not wanted. */
    static final int SKIP = -1;
    /** The slot of the one column that holds a word, which is kept as it stands. */
    static final int WORD = -2;

    private final List<String> columns;
    private final int[] slots;
    private final char separator;
    private final char point;
    private final boolean word;
    /** Of the time's column where it may hold dates and times; its first cell tells which it holds. */
    private Optional<Timestamps> stamps = Optional.empty();
    private boolean numbered;
    private boolean stamped;
    private int wordFrom;
    private int wordTo;

    /**
     * @param columns their names
     * @param slots   where in a row each column's number goes, {@link #SKIP} or {@link #WORD}
     */
    Cells(List<String> columns, int[] slots, char separator) {
        this.columns = List.copyOf(columns);
        this.slots = slots.clone();
        this.separator = separator;
        this.word = Arrays.stream(slots).anyMatch(slot -> slot == WORD);
        this.point = separator == ',' ? '.' : ',';
    }

    /** Reads dates and times where the column of slot 0 holds them. */
    Cells stamped() {
        stamps = Optional.of(new Timestamps());
        return this;
    }

    /** See {@link Timestamps#origin}; empty too where times are numbers. */
    Optional<CalendarTime> origin() {
        return stamps.flatMap(Timestamps::origin);
    }

    /**
     * Reads a line into its slots.
     *
     * @throws DataFault that knows no file, if a wanted cell is not a number, or the row has too few or too many cells
     */
    void read(byte[] text, int from, int to, double[] row) {
        int position = from;
        int last = slots.length - 1;
        for (int column = 0; column <= last; column++) {
            int stop = cellEnd(text, position, to);
            if (stop == to && column < last) {
                throw ragged(column + 1);
            }
            if (slots[column] >= 0) {
                row[slots[column]] = number(text, position, stop, column);
            } else if (slots[column] == WORD) {
                wordFrom = position;
                wordTo = stop;
            }
            position = stop + 1;
        }
        while (position < to && text[position] == ' ') {
            position++;
        }
        if (position < to) {
            throw ragged(DelimitedTable.names(Head.text(text, from, to), separator).size());
        }
    }

    /** Whether no cell of a line begins as a number does, and there are letters in it. */
    boolean areWords(byte[] text, int from, int to) {
        List<String> words = DelimitedTable.names(Head.text(text, from, to), separator);
        return words.stream().noneMatch(word -> !word.isEmpty() && "+-.0123456789?".indexOf(word.charAt(0)) >= 0 && !word.equals("-"))
                && words.stream().anyMatch(word -> !word.isEmpty() && !word.equalsIgnoreCase("nan"));
    }

    /** Whether a column holds a word. */
    boolean hasWord() {
        return word;
    }

    /**
     * The word of the line that was read last, without blanks and quotes around it.
     *
     * @param text of that line
     */
    String word(byte[] text) {
        return DelimitedTable.names(Head.text(text, wordFrom, wordTo), separator).get(0);
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
            if (slots[column] == 0 && stamps.isPresent()) {
                return time(stamps.get(), text, from, to);
            }
            return Decimal.parse(text, from, to, point);
        } catch (NumberFormatException notNumber) {
            String cell = shortened(text, from, to);
            throw new DataFault("column " + columns.get(column) + " must be "
                    + (slots[column] == 0 && stamps.isPresent() ? time(cell) : number(cell)) + ": '" + cell + "'");
        }
    }

    private String time(String cell) {
        return stamped ? "a date and time as before"
                : cell.indexOf(':') < 0 ? number(cell) : "a number, or a date and time of ISO 8601, such as 2025-03-04T10:15:00.005";
    }

    private static String number(String cell) {
        boolean thousands = cell.indexOf('.') >= 0 && cell.indexOf(',') >= 0;
        return "a finite number" + (thousands ? " without marks between thousands" : "") + ", or empty where it is missing";
    }

    private double time(Timestamps clock, byte[] text, int from, int to) {
        stamped |= !numbered && Timestamps.begins(text, from, to);
        double time = stamped ? clock.seconds(text, from, to) : Decimal.parse(text, from, to, point);
        numbered |= !stamped;
        return time;
    }

    private static String shortened(byte[] text, int from, int to) {
        String cell = Head.text(text, from, Math.min(to, from + 40));
        return to - from > 40 ? cell + "…" : cell;
    }

    private DataFault ragged(int cells) {
        return new DataFault("the row has " + cells + (cells == 1 ? " cell" : " cells") + " where the header names " + slots.length
                + (separator == ',' && cells >= 2 * slots.length - 1
                        ? "; where commas are decimal, part the cells by semicolons" : "; mend or remove the line"));
    }
}

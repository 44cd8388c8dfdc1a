package wbv.report.page;

import java.util.List;

/**
 * A table of ready text.
 *
 * @param caption what it shows, may be empty
 * @param columns at least one
 * @param rows    cells by row, as many as columns
 */
public record Table(String caption, List<Column> columns, List<List<String>> rows) implements Block {

    /** Which edge the cells of a column stand at. */
    public enum Align { LEFT, RIGHT }

    /**
     * A column.
     *
     * @param header with the unit, such as {@code Rate [Hz]}
     */
    public record Column(String header, Align align) {

        /** A column of words. */
        public static Column words(String header) {
            return new Column(header, Align.LEFT);
        }

        /** A column of numbers. */
        public static Column numbers(String header) {
            return new Column(header, Align.RIGHT);
        }
    }

    public Table {
        columns = List.copyOf(columns);
        rows = rows.stream().map(List::copyOf).toList();
        if (columns.isEmpty()) {
            throw new IllegalArgumentException("a table needs at least one column");
        }
        for (List<String> row : rows) {
            if (row.size() != columns.size()) {
                throw new IllegalArgumentException("a row needs " + columns.size() + " cells: " + row.size());
            }
        }
    }
}

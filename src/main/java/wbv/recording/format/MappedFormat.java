package wbv.recording.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import wbv.recording.DataFault;
import wbv.recording.Provenance;
import wbv.recording.RowReader;

/** Any delimited table whose columns a {@link ColumnMap} names. Lines above the header are passed over. */
record MappedFormat(ColumnMap map) implements Format {

    /** @throws DataFault if the map does not say where the time comes from, which a table does not know by itself */
    MappedFormat {
        if (map.time().own()) {
            throw DataFault.in(map.name(),
                    "'time' is missing: {\"column\": …, \"unit\": \"s\"}, or {\"rate_hz\": …} for a table without times");
        }
    }

    @Override
    public boolean recognises(Head head) {
        return true;
    }

    @Override
    public RowReader open(Source source, Context context) throws IOException {
        Lines lines = new Lines(source);
        List<String> comments = new ArrayList<>();
        List<String> names = List.of();
        char separator = ',';
        while (names.isEmpty()) {
            if (!lines.next()) {
                throw DataFault.in(source.name(), "has no header with " + sought() + ", which the map " + map.name()
                        + " asks for");
            }
            String line = lines.text();
            separator = DelimitedTable.separator(line);
            List<String> cells = DelimitedTable.names(line, separator);
            if (header(cells)) {
                names = cells;
            } else if (line.startsWith("#")) {
                comments.add(line.substring(1).strip());
            }
        }
        MappedColumns columns = MappedColumns.of(source.name(), lines.line(), names, map);
        return new MappedReader(new DelimitedTable(lines, names, columns.slots(), separator, '#').withUnitsBelow().withTimestamps(),
                columns, map.time(),
                context.metadata(Provenance.parse(comments)).withUnits(NamedColumns.known(columns.channels())));
    }

    private String sought() {
        return map.time().column().map(column -> "the column '" + column.name() + "'").orElse("any of the columns");
    }

    /** Whether these cells name the columns that the map asks for. */
    boolean header(List<String> cells) {
        Optional<ColumnMap.Column> time = map.time().column();
        return time.isPresent() ? cells.contains(time.get().name())
                : cells.stream().anyMatch(cell -> map.patterns().stream().anyMatch(pattern -> pattern.match(cell).isPresent())
                        || map.channels().values().stream().anyMatch(column -> column.name().equals(cell)));
    }
}

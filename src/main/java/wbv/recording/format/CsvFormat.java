package wbv.recording.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import wbv.recording.DataFault;
import wbv.recording.Header;
import wbv.recording.Metadata;
import wbv.recording.Provenance;
import wbv.recording.RowReader;

/**
 * Our CSV: comment lines {@code # key: value}, the header {@code t,head.acc.z,…}, perhaps a row of units, rows. Semicolons and tabs are
 * read too.
 */
final class CsvFormat implements Format {

    private static final String ADVICE = "say which columns are which channels with a column map (--map; 'wbv map' drafts one)";

    @Override
    public boolean recognises(Head head) {
        String header = head.firstAfter("#");
        return NamedColumns.bare(DelimitedTable.names(header, DelimitedTable.separator(header))).contains(Header.TIME);
    }

    @Override
    public boolean statesUnits() {
        return false;
    }

    @Override
    public RowReader open(Source source, Context context) throws IOException {
        Lines lines = new Lines(source);
        List<String> comments = comments(lines);
        if (lines.line() == 0 || lines.text().startsWith("#") || lines.text().isBlank()) {
            throw DataFault.in(source.name(), "has no header; a recording begins with t,head.acc.z,…");
        }
        String text = lines.text();
        char separator = DelimitedTable.separator(text);
        List<String> names = DelimitedTable.names(text, separator);
        List<String> below = below(Head.of(source), separator);
        Metadata metadata = context.metadata(Provenance.parse(comments));
        NamedColumns columns = NamedColumns.of(source.name(), lines.line(), names, below, context.sidecar().units(), metadata.rate(),
                ADVICE);
        DelimitedTable table = new DelimitedTable(lines, names, columns.columns().slots(), separator, '#').withTimestamps();
        return new MappedReader(below.isEmpty() ? table : table.withUnitsBelow(), columns.columns(), columns.time(metadata.rate()),
                metadata.withUnits(columns.stated()));
    }

    /** The cells below the header, where they are units. */
    private static List<String> below(Head head, char separator) {
        List<String> cells = head.lines().stream().filter(line -> !line.startsWith("#")).skip(1).findFirst()
                .map(line -> DelimitedTable.names(line, separator)).orElse(List.of());
        return NamedColumns.areUnits(cells) ? cells : List.of();
    }

    /** Reads the comment lines before the header and stands on the header. */
    static List<String> comments(Lines lines) throws IOException {
        List<String> comments = new ArrayList<>();
        while (lines.next()) {
            String line = lines.text();
            if (line.startsWith("#")) {
                comments.add(line.substring(1).strip());
            } else if (!line.isBlank() && !Head.isParted(line)) {
                break;
            }
        }
        return comments;
    }
}

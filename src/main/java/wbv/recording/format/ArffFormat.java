package wbv.recording.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Provenance;
import wbv.recording.RowReader;

/**
 * ARFF, the format of Weka and MOA: numeric attributes named as our CSV columns are, {@code t} and channels. Comment lines
 * {@code %} at its head say where it came from.
 */
final class ArffFormat implements Format {

    private static final Set<String> NUMERIC = Set.of("numeric", "real", "integer");

    @Override
    public boolean recognises(Head head) {
        return head.firstAfter("%").toLowerCase(Locale.ROOT).startsWith("@relation");
    }

    @Override
    public boolean statesUnits() {
        return false;
    }

    @Override
    public RowReader open(Source source, Context context) throws IOException {
        Lines lines = new Lines(source);
        List<String> comments = new ArrayList<>();
        List<String> names = new ArrayList<>();
        boolean data = false;
        while (!data && lines.next()) {
            String line = lines.text().strip();
            String lower = line.toLowerCase(Locale.ROOT);
            if (line.startsWith("%")) {
                comments.add(line.substring(1).strip());
            } else if (lower.startsWith("@attribute")) {
                names.add(attribute(lines.name(), lines.line(), line.substring("@attribute".length()).strip()));
            } else if (lower.startsWith("@data")) {
                data = true;
            } else if (!line.isEmpty() && !lower.startsWith("@relation")) {
                throw DataFault.at(source.name(), lines.line(), "before @data there may be @attribute lines only: '" + line
                        + "'");
            }
        }
        if (!data) {
            throw DataFault.in(source.name(), "has no @data line; the ARFF file is cut off");
        }
        Metadata metadata = context.metadata(Provenance.parse(comments));
        NamedColumns columns = NamedColumns.of(source.name(), lines.line(), names, List.of(), context.sidecar().units(), metadata.rate(),
                "attributes of other data are not read");
        DelimitedTable table = new DelimitedTable(lines, names, columns.columns().slots(), ',', '%');
        return new MappedReader(table, columns.columns(), columns.time(metadata.rate()), metadata.withUnits(columns.stated()));
    }

    /**
     * The name in an attribute's declaration.
     *
     * @throws DataFault if it is not numeric
     */
    static String attribute(String file, long line, String declaration) {
        char quote = declaration.isEmpty() ? ' ' : declaration.charAt(0);
        boolean quoted = quote == '\'' || quote == '"';
        int end = quoted ? declaration.indexOf(quote, 1) : blank(declaration);
        if (end < 0) {
            throw DataFault.at(file, line, "an attribute needs a name and a type: @attribute head.acc.z numeric");
        }
        String name = declaration.substring(quoted ? 1 : 0, end);
        String type = declaration.substring(quoted ? end + 1 : end).strip();
        String word = type.split("[\\s%]", 2)[0].toLowerCase(Locale.ROOT);
        if (!NUMERIC.contains(word)) {
            throw DataFault.at(file, line, "attribute " + name
                    + " must be numeric, as every channel of a recording: '"
                    + (type.length() > 40 ? type.substring(0, 40) + "…" : type) + "'");
        }
        return name;
    }

    private static int blank(String declaration) {
        for (int i = 0; i < declaration.length(); i++) {
            if (Character.isWhitespace(declaration.charAt(i))) {
                return i;
            }
        }
        return -1;
    }
}

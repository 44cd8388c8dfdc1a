package wbv.recording.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Header;
import wbv.recording.Provenance;
import wbv.recording.RowReader;
import wbv.recording.Unit;

/** Any delimited table whose columns a {@link ColumnMap} names. Lines above the header are passed over. */
record MappedFormat(ColumnMap map) implements Format {

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
            separator = Table.separator(line);
            List<String> cells = Table.names(line, separator);
            if (header(cells)) {
                names = cells;
            } else if (line.startsWith("#")) {
                comments.add(line.substring(1).strip());
            }
        }
        Map<Channel, Integer> columns = new LinkedHashMap<>();
        List<Unit> units = new ArrayList<>();
        int[] slots = slots(source.name(), lines.line(), names, columns, units);
        return new MappedReader(new Table(lines, names, slots, separator, '#'), List.copyOf(columns.keySet()),
                units.toArray(Unit[]::new), map.time(), context.metadata(Provenance.parse(comments)));
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

    /** Finds where every wanted column goes; fills in the channels, with their columns, and the units by slot. */
    int[] slots(String file, long line, List<String> names, Map<Channel, Integer> columns, List<Unit> units) {
        int[] slots = new int[names.size()];
        Arrays.fill(slots, Table.SKIP);
        units.add(map.time().column().map(MappedFormat::unit).orElse(new Unit("s", 1, 1)));
        map.time().column().ifPresent(column -> slots[column(file, line, names, column.name())] = 0);
        map.channels().forEach((channel, column) -> {
            int index = column(file, line, names, column.name());
            if (slots[index] != Table.SKIP) {
                throw DataFault.in(map.name(), "gives the column '" + column.name() + "' two uses");
            }
            columns.put(channel, index);
            slots[index] = columns.size();
            units.add(unit(column));
        });
        for (int i = 0; i < slots.length; i++) {
            for (ColumnPattern pattern : slots[i] == Table.SKIP ? map.patterns() : List.<ColumnPattern>of()) {
                Optional<Channel> channel = pattern.match(names.get(i)).filter(found -> !columns.containsKey(found));
                if (channel.isPresent() && slots[i] == Table.SKIP) {
                    columns.put(channel.get(), i);
                    slots[i] = columns.size();
                    units.add(unit(new ColumnMap.Column(names.get(i), pattern.unit(), pattern.scale())));
                }
            }
        }
        if (columns.isEmpty()) {
            throw DataFault.at(file, line, "no column fits a pattern of the map " + map.name() + "; there are "
                    + Header.shortened(names));
        }
        return slots;
    }

    private int column(String file, long line, List<String> names, String name) {
        int index = names.indexOf(name);
        if (index < 0 || names.lastIndexOf(name) != index) {
            throw DataFault.at(file, line, "the map " + map.name() + " asks for the column '" + name + "', which is there "
                    + (index < 0 ? "not; there are " + Header.shortened(names) : "twice"));
        }
        return index;
    }

    private static Unit unit(ColumnMap.Column column) {
        return Unit.of(column.unit()).orElseThrow(() -> new IllegalArgumentException("unit is not known: " + column.unit()))
                .scaled(column.scale());
    }
}

package wbv.recording.format;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Header;
import wbv.recording.Unit;

/**
 * Where the columns of a table go by a {@link ColumnMap}.
 *
 * @param slots    by column: its slot in a row, or {@link Cells#SKIP}
 * @param channels by slot from 1
 * @param units    by slot, the time's first
 */
record MappedColumns(int[] slots, List<Channel> channels, Unit[] units) {

    /** @throws DataFault if a column of the map is not there, or there twice, or has two uses, or no column fits */
    static MappedColumns of(String file, long line, List<String> names, ColumnMap map) {
        int[] slots = new int[names.size()];
        Arrays.fill(slots, Cells.SKIP);
        Map<Channel, Integer> columns = new LinkedHashMap<>();
        List<Unit> units = new ArrayList<>();
        units.add(map.time().column().map(MappedColumns::unit).orElse(new Unit("s", 1, 1)));
        map.time().column().ifPresent(column -> slots[column(file, line, names, column.name(), map)] = 0);
        map.channels().forEach((channel, column) -> {
            int index = column(file, line, names, column.name(), map);
            if (slots[index] != Cells.SKIP) {
                throw DataFault.in(map.name(), "gives the column '" + column.name() + "' two uses");
            }
            columns.put(channel, index);
            slots[index] = columns.size();
            units.add(unit(column));
        });
        for (int i = 0; i < slots.length; i++) {
            for (ColumnPattern pattern : slots[i] == Cells.SKIP ? map.patterns() : List.<ColumnPattern>of()) {
                Optional<Channel> channel = pattern.match(names.get(i)).filter(found -> !columns.containsKey(found));
                if (channel.isPresent() && slots[i] == Cells.SKIP) {
                    columns.put(channel.get(), i);
                    slots[i] = columns.size();
                    units.add(unit(new ColumnMap.Column(names.get(i), pattern.unit(), pattern.scale())));
                }
            }
        }
        if (columns.isEmpty()) {
            throw fault(file, line, "no column fits a pattern of the map " + map.name() + "; there are " + Header.shortened(names));
        }
        return new MappedColumns(slots, List.copyOf(columns.keySet()), units.toArray(Unit[]::new));
    }

    private static int column(String file, long line, List<String> names, String name, ColumnMap map) {
        int index = names.indexOf(name);
        if (index < 0 || names.lastIndexOf(name) != index) {
            throw fault(file, line, "the map " + map.name() + " asks for the column '" + name + "', which is there "
                    + (index < 0 ? "not; there are " + Header.shortened(names) : "twice"));
        }
        return index;
    }

    private static DataFault fault(String file, long line, String message) {
        return line > 0 ? DataFault.at(file, line, message) : DataFault.in(file, message);
    }

    private static Unit unit(ColumnMap.Column column) {
        return Unit.of(column.unit()).orElseThrow(() -> new IllegalArgumentException("unit is not known: " + column.unit()))
                .scaled(column.scale());
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof MappedColumns columns && Arrays.equals(slots, columns.slots) && channels.equals(columns.channels)
                && Arrays.equals(units, columns.units);
    }

    @Override
    public int hashCode() {
        return channels.hashCode();
    }
}

package wbv.recording.format;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Header;
import wbv.recording.Unit;
import wbv.recording.signals.UnitWords;

/**
 * The columns of a table that is named as ours are, with the units that it states: behind a name ({@code t_ms}, {@code seat.acc.z [g]},
 * {@code seat.acc.z_g}), in a row below the names, or in the sidecar. What states none is in SI.
 *
 * @param columns where they go
 * @param timed   whether one of them is the time
 * @param stated  units as they were stated, by channel or {@code t}
 */
record NamedColumns(MappedColumns columns, boolean timed, Map<String, String> stated) {

    private static final String SECONDS = "s";
    private static final Pattern WITH_UNIT = Pattern
            .compile("(t|[^\\s\\[({_.]\\S*\\.[a-z]+\\.[a-z])(?:\\s*[\\[({]\\s*(?<bracket>.*?)\\s*[\\])}]|[_ ](?<tail>\\S+))");

    NamedColumns {
        stated = Map.copyOf(stated);
    }

    /** A name without its unit, and the unit. */
    private record Named(String name, Optional<String> unit) {

        static Named of(String written) {
            Matcher matcher = WITH_UNIT.matcher(written);
            if (!matcher.matches()) {
                return new Named(written, Optional.empty());
            }
            String behind = matcher.group("bracket") == null ? matcher.group("tail").replace("_", "/") : matcher.group("bracket");
            Optional<String> unit = UnitWords.of(behind);
            boolean other = matcher.group(1).equals(Header.TIME) && unit.flatMap(Unit::of).filter(Named::isTime).isEmpty();
            return other ? new Named(written, Optional.empty()) : new Named(matcher.group(1), Optional.of(unit.orElse(behind)));
        }

        private static boolean isTime(Unit unit) {
            return unit.dimension().equals(SECONDS);
        }
    }

    /** The names without the units that stand behind them. */
    static List<String> bare(List<String> names) {
        return names.stream().map(name -> Named.of(name).name()).toList();
    }

    /** Whether these cells below names are nothing but their units. */
    static boolean areUnits(List<String> cells) {
        return !cells.isEmpty() && cells.stream().allMatch(cell -> cell.isEmpty() || cell.equals("-")
                || Character.isLetter(cell.charAt(cell.length() > 1 && "[({".indexOf(cell.charAt(0)) >= 0 ? 1 : 0))
                        && UnitWords.of(cell).isPresent());
    }

    /**
     * The columns of a table.
     *
     * @param line   where the names stand
     * @param below  units in a row below them; empty where there is none
     * @param beside units that the sidecar states, by {@code t}, channel, {@code place.quantity} or quantity
     * @param rate   samples a second where they are known, for a table without times [Hz]
     * @param advice how to read a file with other columns
     * @throws DataFault if there is neither a time nor a rate, a name is no channel or stands twice, or a unit is not one of its quantity
     */
    static NamedColumns of(String file, long line, List<String> names, List<String> below, Map<String, String> beside,
            OptionalDouble rate, String advice) {
        List<String> bare = bare(names);
        boolean timed = bare.contains(Header.TIME) || rate.isEmpty();
        if (!bare.contains(Header.TIME) && rate.isEmpty() && bare.stream().allMatch(NamedColumns::isChannel)) {
            throw DataFault.at(file, line, "the header has channels, but no column t of times; say the rate: --rate HZ, or \"rate_hz\" in "
                    + "the sidecar");
        }
        Header header = timed ? Header.of(file, line, bare, advice) : Header.untimed(file, line, bare, advice);
        Map<String, String> stated = new LinkedHashMap<>();
        for (int i = 0; i < names.size(); i++) {
            String name = bare.get(i);
            String under = i < below.size() ? below.get(i) : "";
            Optional<String> own = Named.of(names.get(i)).unit().or(() -> UnitWords.of(under));
            own.ifPresent(unit -> stated.put(name, unit));
        }
        for (String name : bare) {
            closest(name).stream().filter(beside::containsKey).findFirst().map(beside::get).ifPresent(said -> {
                String before = stated.putIfAbsent(name, said);
                if (before != null && !before.equals(said)) {
                    throw DataFault.at(file, line, "the column '" + name + "' is in " + before + " by the header and in " + said
                            + " by the sidecar");
                }
            });
        }
        beside.keySet().stream().filter(key -> bare.stream().noneMatch(name -> closest(name).contains(key))).findFirst().ifPresent(key -> {
            throw DataFault.at(file, line, "has no column that '" + key + "' in the sidecar's 'units' is about; it has "
                    + Header.shortened(bare));
        });
        if (!bare.contains(Header.TIME)) {
            stated.put(Header.TIME, SECONDS);
        }
        Unit[] units = new Unit[1 + header.channels().size()];
        units[0] = unit(file, line, Header.TIME, stated, SECONDS);
        for (int i = 1; i < units.length; i++) {
            Channel channel = header.channels().get(i - 1);
            units[i] = unit(file, line, channel.toString(), stated, channel.quantity().unit());
        }
        return new NamedColumns(new MappedColumns(header.slots(), header.channels(), units), timed, stated);
    }

    private static boolean isChannel(String name) {
        try {
            return Channel.parse(name).toString().equals(name);
        } catch (IllegalArgumentException other) {
            return false;
        }
    }

    /** Where a row's time comes from. */
    ColumnMap.Time time(OptionalDouble rate) {
        return timed ? new ColumnMap.Time(Optional.of(new ColumnMap.Column(Header.TIME, SECONDS, 1)), OptionalDouble.empty(), false)
                : new ColumnMap.Time(Optional.empty(), rate, false);
    }

    /** Units of columns that are known by what wrote the file or by a map: SI as it is read. */
    static Map<String, String> known(List<Channel> channels) {
        Map<String, String> known = new LinkedHashMap<>(Map.of(Header.TIME, SECONDS));
        channels.forEach(channel -> known.put(channel.toString(), channel.quantity().unit()));
        return known;
    }

    /** Under what the sidecar may state a column's unit, the closest first. */
    private static List<String> closest(String name) {
        String[] words = name.split("\\.", -1);
        return words.length == 3 ? List.of(name, words[0] + "." + words[1], words[1]) : List.of(name);
    }

    private static Unit unit(String file, long line, String name, Map<String, String> stated, String dimension) {
        String symbol = stated.getOrDefault(name, dimension);
        return Unit.of(symbol).filter(unit -> unit.dimension().equals(dimension)).orElseThrow(() -> DataFault.at(file, line,
                "the unit of '" + name + "' must be one of " + Unit.symbols(dimension) + ": '" + symbol + "'"));
    }
}

package wbv.recording.format;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import wbv.recording.BoundedReader;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Header;
import wbv.recording.Unit;

/**
 * What the columns of rows mean that come one by one, by their names: ours ({@code t} and channels), those of a Movella DOT
 * ({@code SampleTimeFine} in µs, which wraps at 2³²; angular rates in °/s), or those of a map; and {@code seat}, a word, in any.
 */
final class RowColumns {

    /** The column, or field, that says whose row it is. */
    static final String SEAT = "seat";
    /** The column of a Movella DOT's clock. */
    static final String SAMPLE_TIME = "SampleTimeFine";

    private static final double MICROSECONDS = 1e6;
    private static final double RANGE = 4_294_967_296.0;
    private static final String ADVICE = "say which columns are which channels with a column map (--map)";

    private final List<String> names;
    private final int[] slots;
    private final List<Channel> channels;
    private final Unit[] units;
    private final boolean counted;
    private final ReadOptions options;
    private final double[] raw;
    private final double[] row;
    private double last = Double.NaN;
    private double ticks;
    private double zero = Double.NaN;
    private long rows;

    private RowColumns(List<String> names, int[] slots, List<Channel> channels, Unit[] units, boolean counted, ReadOptions options) {
        this.names = List.copyOf(names);
        this.slots = slots;
        this.channels = List.copyOf(channels);
        this.units = units;
        this.counted = counted;
        this.options = options;
        this.raw = new double[1 + channels.size()];
        this.row = new double[raw.length];
    }

    /** Whether these cells are names of columns, and not numbers. */
    static boolean names(List<String> cells, ReadOptions options) {
        if (cells.stream().anyMatch(cell -> !cell.isEmpty() && "+-.0123456789".indexOf(cell.charAt(0)) >= 0)) {
            return false;
        }
        return options.map().isPresent() ? new MappedFormat(options.map().get()).header(cells)
                : NamedColumns.bare(cells).contains(Header.TIME) || cells.contains(SAMPLE_TIME);
    }

    /**
     * The meaning of named columns.
     *
     * @param where  the stream, for messages
     * @param line where they are named
     * @param sensor tag or serial number of the one sensor that a DOT's columns are of; may be empty
     * @throws DataFault if there is no time or no channel, a name is no channel, or one stands twice
     */
    static RowColumns of(String where, long line, List<String> names, String sensor, ReadOptions options) {
        List<String> others = new ArrayList<>(names);
        int seat = others.indexOf(SEAT);
        if (seat >= 0) {
            others.remove(seat);
        }
        Header.requireDistinct(where, line, names);
        RowColumns found = options.map().isPresent() ? mapped(where, line, others, options)
                : others.contains(SAMPLE_TIME) ? counted(where, line, others, sensor, options) : own(where, line, others, options);
        int[] slots = new int[names.size()];
        for (int i = 0; i < slots.length; i++) {
            slots[i] = i == seat ? Cells.WORD : found.slots[seat >= 0 && i > seat ? i - 1 : i];
        }
        return new RowColumns(names, slots, found.channels, found.units, found.counted, options);
    }

    private static RowColumns own(String where, long line, List<String> names, ReadOptions options) {
        Header.of(where, line, NamedColumns.bare(names), ADVICE); // rows that come one by one say their times themselves
        MappedColumns columns = NamedColumns.of(where, line, names, List.of(), Map.of(), OptionalDouble.empty(), ADVICE).columns();
        return new RowColumns(names, columns.slots(), columns.channels(), columns.units(), false, options);
    }

    private static RowColumns counted(String where, long line, List<String> names, String sensor, ReadOptions options) {
        SensorColumns columns = SensorColumns.of(names, SAMPLE_TIME, place(where, sensor, options), "deg/s");
        if (columns.channels().isEmpty() || columns.matrix() > 0) {
            throw DataFault.at(where, line, "a DOT's rows need Acc_, FreeAcc_, Gyr_, Mag_, Quat_ or Euler_ columns; there are "
                    + Header.shortened(names));
        }
        List<Unit> units = new ArrayList<>(List.of(new Unit("s", 1, 1)));
        units.addAll(columns.units());
        return new RowColumns(names, columns.slots(), columns.channels(), units.toArray(Unit[]::new), true, options);
    }

    /** Where a sensor sat: by the user's word, else its tag made a word; one without a tag is the seat's. */
    private static String place(String where, String sensor, ReadOptions options) {
        String place = options.locations().getOrDefault(sensor, sensor.isEmpty() ? SEAT : Context.word(sensor));
        if (!Channel.isLocation(place)) {
            throw DataFault.in(where, "the location given to " + sensor + " must be a word of a-z, 0-9 and _: '" + place + "'");
        }
        return place;
    }

    private static RowColumns mapped(String where, long line, List<String> names, ReadOptions options) {
        MappedColumns columns = MappedColumns.of(where, line, names, new MappedFormat(options.map().orElseThrow()).map());
        return new RowColumns(names, columns.slots(), columns.channels(), columns.units(), false, options);
    }

    List<String> names() {
        return names;
    }

    /** Where each column goes in {@link #raw}. */
    int[] slots() {
        return slots.clone();
    }

    List<Channel> channels() {
        return channels;
    }

    /** Numbers as they came, to be filled in by {@link #slots}; those of one row alone. */
    double[] raw() {
        return raw;
    }

    /** Begins a row of which nothing is known yet. */
    void clear() {
        Arrays.fill(raw, Double.NaN);
    }

    /**
     * The row that {@link #raw} makes: time [s], then the channels in SI. The same array always.
     *
     * @throws DataFault that knows no file, if there is no time, or a value that no sensor measures
     */
    double[] row() {
        if (options.map().isPresent() && options.map().get().time().rate().isPresent()) {
            raw[0] = rows / options.map().get().time().rate().getAsDouble();
        }
        if (Double.isNaN(raw[0])) {
            throw new DataFault("the row has no time; every row needs one");
        }
        double time = counted ? seconds(raw[0]) : units.length > 0 ? units[0].toSi(raw[0]) : raw[0];
        if (!(Math.abs(time) <= BoundedReader.LATEST)) {
            throw new DataFault("the time " + time + " s is not within " + BoundedReader.LATEST + " s");
        }
        if (options.map().isPresent() && options.map().get().time().fromZero()) {
            zero = Double.isNaN(zero) ? time : zero;
            time -= zero;
        }
        row[0] = time;
        for (int i = 1; i < row.length; i++) {
            row[i] = units.length > 0 ? units[i].toSi(raw[i]) : raw[i];
            if (Math.abs(row[i]) > BoundedReader.MOST) {
                throw new DataFault(channels.get(i - 1) + " is " + row[i] + " " + channels.get(i - 1).quantity().unit()
                        + ", which no sensor measures");
            }
        }
        rows++;
        return row;
    }

    /** Counts on, over wraps; a step of more than half the range is one backwards. */
    private double seconds(double count) {
        if (!(count >= 0 && count < RANGE)) {
            throw new DataFault(SAMPLE_TIME + " counts microseconds from 0 to 4294967295: " + count);
        }
        double step = Double.isNaN(last) ? count : count - last;
        ticks += step - RANGE * Math.rint(step / RANGE);
        last = count;
        return ticks / MICROSECONDS;
    }
}

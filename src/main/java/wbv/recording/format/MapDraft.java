package wbv.recording.format;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Header;
import wbv.recording.Json;
import wbv.recording.Quantity;
import wbv.recording.Unit;
import wbv.recording.signals.Label;

/**
 * A column map drafted from what a foreign file's columns are called and what numbers stand in them. What they do not say is assumed, and
 * asked for as a question; nothing is assumed in silence.
 */
public final class MapDraft {

    /** The length of the mean of an accelerometer at rest is within this share of gravity; it is tilted and it is moved. */
    private static final double ABOUT = 0.08;
    /** Counts of a g that digital accelerometers have. */
    private static final int[] COUNTS = {1024, 2048, 4096, 8192, 16384, 32768};
    /** Counts of a degree a second of the gyroscope that most hobby loggers have. */
    private static final double COUNTS_PER_DEGREE = 131;
    /** What is recorded beside motion. */
    private static final Set<Quantity> BESIDE = EnumSet.of(Quantity.TEMPERATURE, Quantity.VOLTAGE);
    /** Times that begin later than this [s] are counted from some epoch. */
    private static final double EPOCH = 1e5;

    /** A unit that its user has to write; no map with it is read. */
    static final String OPEN = "?";

    private final ForeignTable table;
    private final Specimen specimen;
    private final List<NameWords> words = new ArrayList<>();
    private final List<String> lines = new ArrayList<>();
    private final Set<String> questions = new LinkedHashSet<>();
    private final Map<Channel, ColumnMap.Column> channels = new LinkedHashMap<>();
    private final ObjectNode time = Json.MAPPER.createObjectNode();
    private int clock = -1;
    private boolean counted;
    /** Columns of which an axis is all that is known. */
    private final List<Integer> axesAlone = new ArrayList<>();

    private MapDraft(ForeignTable table) {
        this.table = table;
        table.asked().filter(question -> table.timed()).ifPresent(questions::add);
        for (int i = 0; i < table.labels().size(); i++) {
            words.add(NameWords.of(table.labels().get(i), table.units().get(i)));
        }
        specimen = Specimen.of(words.stream().map(NameWords::label).toList());
    }

    /**
     * Drafts the map of a file.
     *
     * @throws DataFault if it holds no table, or no column that measures anything
     */
    public static MapDraft of(Path file) throws IOException {
        MapDraft draft = new MapDraft(ForeignTable.of(file));
        draft.time();
        draft.channels();
        if (draft.channels.isEmpty()) {
            throw DataFault.in(file.toString(), "no column's name says what it measures; there are "
                    + Header.shortened(draft.table.labels().stream().map(Label::name).toList()) + "; write the map by hand");
        }
        return draft;
    }

    /** How the file is laid out, in words. */
    public String where() {
        return table.where();
    }

    /** One line for each column: what it is taken for. */
    public List<String> lines() {
        return List.copyOf(lines);
    }

    /** What the file does not say, in the order of its columns. */
    public List<String> questions() {
        return List.copyOf(questions);
    }

    /** What the columns are taken for, in their order. */
    public Set<Channel> drafted() {
        return Collections.unmodifiableSet(channels.keySet());
    }

    /** The command that suits what the columns are, with what it needs beside recording and map. */
    public String command() {
        return specimen.command(channels.keySet());
    }

    /**
     * The map as {@link ColumnMap#read} takes it.
     *
     * @param file that it was drafted for
     */
    public String json(String file) throws IOException {
        ObjectNode json = Json.MAPPER.createObjectNode();
        json.put("comment", "drafted by wbv map for " + file);
        if (!questions.isEmpty()) {
            ArrayNode open = json.putArray("questions");
            questions.forEach(open::add);
        }
        if (!time.isEmpty()) {
            json.set("time", time);
        }
        ObjectNode all = json.putObject("channels");
        channels.forEach((channel, column) -> {
            ObjectNode each = all.putObject(channel.toString());
            each.put("column", column.name()).put("unit", column.unit());
            if (column.scale() != 1) {
                each.put("scale", column.scale());
            }
        });
        return Json.MAPPER.writerWithDefaultPrettyPrinter().writeValueAsString(json) + "\n";
    }

    private void time() {
        for (int i = 0; i < words.size() && clock < 0; i++) {
            boolean named = table.time().map(table.labels().get(i).name()::equals)
                    .orElse(words.get(i).time() && words.get(i).label().quantity().isEmpty());
            clock = named && rises(table.values()[i]) ? i : clock;
        }
        if (clock < 0 && table.rate().isPresent()) {
            if (!table.timed()) {
                time.put("rate_hz", table.rate().getAsDouble());
                lines.add("times: " + table.rate().getAsDouble() + " samples a second, as the file states");
            }
            return;
        }
        if (clock < 0) {
            table.asked().ifPresent(questions::add);
            questions.add("How many samples a second? No column is a time: write \"time\": {\"rate_hz\": …}.");
            time.putNull("rate_hz");
            return;
        }
        String name = table.labels().get(clock).name();
        double step = step(table.values()[clock]);
        if (table.timed()) {
            lines.add(name + ": time in s, " + brief(1 / step) + " samples a second");
            return;
        }
        Optional<String> stated = words.get(clock).label().unit().filter(unit -> Unit.of(unit).orElseThrow().dimension().equals("s"))
                .or(() -> name.toLowerCase(Locale.ROOT).contains("millis") ? Optional.of("ms") : Optional.empty())
                .or(() -> name.toLowerCase(Locale.ROOT).contains("micros") ? Optional.of("us") : Optional.empty());
        String unit = stated.orElseGet(() -> step < 0.2 ? "s" : step < 200 ? "ms" : step < 2e5 ? "us" : "ns");
        Unit seconds = Unit.of(unit).orElseThrow();
        double rate = 1 / seconds.toSi(step);
        if (stated.isEmpty()) {
            questions.add(
                    "Is '" + name + "' in " + unit + "? Its name does not say; its steps would make " + brief(rate) + " samples a second.");
        }
        time.put("column", name).put("unit", unit);
        if (seconds.toSi(table.values()[clock][0]) > EPOCH) {
            time.put("from_zero", true);
        }
        lines.add(name + ": time in " + unit + ", " + brief(rate) + " samples a second");
    }

    private void channels() {
        Map<String, List<Integer>> sensors = new LinkedHashMap<>();
        boolean silent = words.stream().flatMap(each -> each.label().quantity().stream()).allMatch(BESIDE::contains);
        for (int i = 0; i < words.size(); i++) {
            NameWords each = words.get(i);
            boolean guessed = each.number() > 0 && each.label().quantity().isEmpty() && each.label().unit().isEmpty() && !each.time();
            if (i == clock) {
                continue;
            }
            boolean axisAlone = silent && each.label().quantity().isEmpty() && each.label().unit().isEmpty() && !each.time()
                    && each.label().axis().isPresent();
            if (each.magnitude() || each.label().quantity().isEmpty() && !guessed && !axisAlone
                    || Arrays.stream(table.values()[i]).allMatch(Double::isNaN)) {
                lines.add(each.label().name() + ": not read" + (each.magnitude() ? ", the length of a vector" : ""));
                continue;
            }
            if (guessed) {
                questions.add("What does '" + each.label().name() + "' measure? It is taken for an acceleration.");
            }
            if (axisAlone) {
                axesAlone.add(i);
            }
            Quantity quantity = each.label().quantity().orElse(Quantity.ACCELERATION);
            sensors.computeIfAbsent(each.label().place().orElse("") + " " + quantity.symbol() + (each.linear() ? " linear" : ""),
                    key -> new ArrayList<>()).add(i);
        }
        if (!axesAlone.isEmpty()) {
            questions.add("What do " + names(axesAlone) + " measure? An axis is all that the names say: accelerations are assumed.");
        }
        List<Integer> nowhere = sensors.values().stream().flatMap(List::stream).filter(i -> words.get(i).label().place().isEmpty())
                .toList();
        if (!nowhere.isEmpty()) {
            questions.add("Where was the sensor of " + names(nowhere) + "? '" + specimen.place() + "' stands for it.");
        }
        sensors.values().forEach(this::sensor);
    }

    /** The columns of one quantity at one place. */
    private void sensor(List<Integer> columns) {
        NameWords first = words.get(columns.get(0));
        Quantity named = first.label().quantity().orElse(Quantity.ACCELERATION);
        String place = first.label().place().orElse(specimen.place());
        Scale scale = scale(named, columns, first.linear());
        boolean inOrder = columns.size() == 3 && columns.stream().allMatch(i -> words.get(i).label().axis().isEmpty());
        for (int k = 0; k < columns.size(); k++) {
            Label label = words.get(columns.get(k)).label();
            String axes = scale.quantity.axes();
            Optional<Character> said = axes.length() == 1 ? Optional.of(axes.charAt(0))
                    : label.axis().filter(axis -> axes.indexOf(axis) >= 0);
            char axis = said.orElse(inOrder ? axes.charAt(k) : 'z');
            if (said.isEmpty()) {
                questions.add("Along which axis is '" + label.name() + "'? " + axis + " stands for it (x forward, y left, z up).");
            }
            Channel channel = new Channel(place, scale.quantity, axis);
            for (int more = 2; channels.containsKey(channel); more++) {
                channel = new Channel(place + "_" + more, scale.quantity, axis);
            }
            double factor = label.sign() * scale.factor;
            channels.put(channel, new ColumnMap.Column(label.name(), scale.unit, factor));
            lines.add(label.name() + ": " + channel + " in " + scale.unit + (factor == 1 ? "" : " × " + brief(factor)) + scale.why);
        }
    }

    /** @param why in words, to be put behind it */
    private record Scale(Quantity quantity, String unit, double factor, String why) {}

    private Scale scale(Quantity named, List<Integer> columns, boolean linear) {
        Optional<String> stated = words.get(columns.get(0)).label().unit()
                .filter(unit -> Unit.of(unit).orElseThrow().dimension().equals(named.unit()));
        if (named != Quantity.ACCELERATION && named != Quantity.SPECIFIC_FORCE) {
            if (stated.isEmpty() && named == Quantity.ANGULAR_RATE && counted) {
                questions.add("How many counts of " + names(columns) + " are one deg/s? 131 is assumed, as of an MPU-6050 at ±250 deg/s.");
                return new Scale(named, "deg/s", 1 / COUNTS_PER_DEGREE, "");
            }
            if (stated.isEmpty() && named == Quantity.ANGULAR_RATE) {
                questions.add("Are " + names(columns) + " in deg/s or rad/s? deg/s is assumed.");
                return new Scale(named, "deg/s", 1, "");
            }
            if (stated.isEmpty() && named != Quantity.QUATERNION && named != Quantity.MAGNETIC_FIELD) {
                questions.add("In which unit are " + names(columns) + "? " + named.unit() + " is assumed.");
            }
            return new Scale(named, stated.orElse(named.unit().replace("²", "2")), 1, "");
        }
        double rest = 0;
        for (int column : columns) {
            double mean = Arrays.stream(table.values()[column]).filter(Double::isFinite).average().orElse(0);
            rest += mean * mean;
        }
        double length = Math.sqrt(rest);
        if (stated.isPresent()) {
            double metres = Unit.of(stated.get()).orElseThrow().toSi(length);
            boolean gravity = !linear && metres > Unit.STANDARD_GRAVITY / 2 && metres < 2 * Unit.STANDARD_GRAVITY;
            if (gravity && !near(metres, Unit.STANDARD_GRAVITY)) {
                questions.add("Is gravity in " + names(columns) + "? Their mean is " + brief(length) + " " + stated.get()
                        + " long, nearer to one g than to none or two, which says so; then look after their scale.");
            }
            return gravity ? new Scale(Quantity.SPECIFIC_FORCE, stated.get(), 1, ", gravity in it") : new Scale(named, stated.get(), 1, "");
        }
        for (String unit : List.of("m/s2", "g", "mg")) {
            if (near(Unit.of(unit).orElseThrow().toSi(length), Unit.STANDARD_GRAVITY)) {
                questions.add("Are " + names(columns) + " in " + unit + ", with gravity in them? Their mean is " + brief(length)
                        + " long, which says so.");
                return new Scale(Quantity.SPECIFIC_FORCE, unit, 1, ", gravity in it");
            }
        }
        for (int counts : COUNTS) {
            if (near(length, counts)) {
                questions.add("Are " + counts + " counts of " + names(columns) + " one g? Their mean is " + brief(length)
                        + " long, which says so.");
                counted = true;
                return new Scale(Quantity.SPECIFIC_FORCE, "g", 1.0 / counts, ", gravity in it");
            }
        }
        if (axesAlone.containsAll(columns)) {
            questions
                    .add("In which unit are " + names(columns) + ", and is gravity in them (accg in place of acc)? Write the unit in place "
                            + "of each \"" + OPEN + "\": until then the map is not read.");
            return new Scale(Quantity.ACCELERATION, OPEN, 1, ", a unit that is to be written");
        }
        questions.add("In which unit are " + names(columns) + ", and is gravity in them? m/s2 without gravity is assumed.");
        return new Scale(Quantity.ACCELERATION, "m/s2", 1, "");
    }

    private String names(List<Integer> columns) {
        List<String> names = columns.stream().map(i -> "'" + words.get(i).label().name() + "'").toList();
        return names.size() == 1 ? names.get(0)
                : String.join(", ", names.subList(0, names.size() - 1)) + " and " + names.get(names.size() - 1);
    }

    private static boolean near(double value, double truth) {
        return Math.abs(value - truth) <= ABOUT * truth;
    }

    static boolean rises(double[] values) {
        int up = 0;
        for (int i = 1; i < values.length; i++) {
            up += values[i] > values[i - 1] ? 1 : 0;
        }
        return values.length > 1 && up >= 0.9 * (values.length - 1);
    }

    /** The mean step, or the median one where gaps make the mean another. */
    private static double step(double[] values) {
        double[] steps = new double[values.length - 1];
        for (int i = 0; i < steps.length; i++) {
            steps[i] = values[i + 1] - values[i];
        }
        Arrays.sort(steps);
        double median = steps[steps.length / 2];
        double mean = (values[values.length - 1] - values[0]) / steps.length;
        return Math.abs(mean - median) <= 0.1 * median ? mean : median;
    }

    private static String brief(double value) {
        return new BigDecimal(value).round(new MathContext(4)).stripTrailingZeros().toPlainString();
    }
}

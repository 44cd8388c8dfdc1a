package wbv.recording.format;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Decimal;
import wbv.recording.signals.Label;
import wbv.recording.signals.SignalFile;
import wbv.recording.signals.SignalKind;
import wbv.recording.signals.UnitWords;

/**
 * The beginning of a file whose columns are not known yet: what each says of itself, and its first numbers.
 *
 * @param where  how it is laid out, in words
 * @param labels of its columns
 * @param units  by column, from a row of units below the names
 * @param values by column, the first of them; NaN where there is no number
 * @param time   the column of times that the file itself names, if it does
 * @param rate   samples a second that the file states
 * @param timed  whether the file knows its times without a map
 * @param asked  what no file of this kind says; of one that does not know its times, about these
 */
record ForeignTable(String where, List<Label> labels, List<Optional<String>> units, double[][] values, Optional<String> time,
        OptionalDouble rate, boolean timed, Optional<String> asked) {

    /** Rows that are looked at. */
    private static final int ROWS = 300;
    /** Rows of numbers that a table begins with. */
    private static final int ENOUGH = 3;
    private static final String FULL_SCALE = "What is full scale? Whole numbers of a WAV are shares of it: write it as the \"scale\" of "
            + "each channel.";
    /** Clocks as people write them, with a day or without. */
    private static final Pattern CLOCK = Pattern
            .compile("(?:\\d{1,4}[./-]\\d{1,2}[./-]\\d{1,4}[ T,]+)?\\d{1,2}:\\d{2}(?::\\d{2}(?:[.,]\\d+)?)?(?: ?[AaPp][Mm])?");
    private static final Pattern RATE = Pattern
            .compile("(?i)(?:sampl\\w*[ _]?(?:rate|freq\\w*)|update rate|\\bfs)\\W+([0-9]+(?:[.,][0-9]+)?)\\s*(k?)(?:hz)?");

    /**
     * Looks into a file.
     *
     * @throws DataFault if it holds no table
     */
    static ForeignTable of(Path path) throws IOException {
        try (Source source = Source.open(path)) {
            Head head = Head.of(source);
            Optional<SignalKind> kind = SignalKind.of(head.bytes());
            if (kind.isPresent()) {
                return signals(kind.get(), source);
            }
            head.requireText();
            return text(source.name(), head.lines());
        }
    }

    private static ForeignTable signals(SignalKind kind, Source source) throws IOException {
        try (SignalFile signals = kind.open(source.name(), source.path(), source.content())) {
            List<double[]> rows = new ArrayList<>();
            double[] row = new double[signals.labels().size()];
            while (rows.size() < ROWS && signals.read(row)) {
                rows.add(row.clone());
            }
            List<Optional<String>> none = signals.labels().stream().map(label -> Optional.<String>empty()).toList();
            return new ForeignTable("a " + kind + " file", signals.labels(), none, columns(rows, row.length), signals.time(),
                    signals.rate(), signals.time().isPresent() || signals.rate().isPresent(),
                    Optional.of(FULL_SCALE).filter(question -> kind == SignalKind.WAV));
        }
    }

    private static ForeignTable text(String file, List<String> lines) {
        for (int i = 1; i < lines.size(); i++) {
            char separator = DelimitedTable.separator(lines.get(i));
            int width = DelimitedTable.names(lines.get(i), separator).size();
            if (width > 1 && numbers(lines.get(i), separator) >= 1 && ahead(lines, i, separator, width)) {
                List<String> above = DelimitedTable.names(lines.get(i - 1), DelimitedTable.separator(lines.get(i - 1)));
                boolean units = i > 1 && above.size() == width && unitsOnly(above)
                        && DelimitedTable.names(lines.get(i - 2), separator).size() == width;
                List<String> names = units ? DelimitedTable.names(lines.get(i - 2), separator)
                        : DelimitedTable.names(lines.get(i - 1), separator);
                if (names.size() != width || names.stream().anyMatch(name -> isNumber(name, separator))) {
                    throw DataFault.in(file, "has no line with the names of its " + width + " columns above the numbers; write one");
                }
                return table(lines, i, separator, names, units ? above : List.of());
            }
        }
        throw DataFault.in(file, "holds no table: rows of numbers parted by comma, semicolon or tab, below a line with their names");
    }

    private static ForeignTable table(List<String> lines, int first, char separator, List<String> names, List<String> units) {
        List<double[]> rows = new ArrayList<>();
        List<Timestamps> clocks = names.stream().map(name -> new Timestamps()).toList();
        for (String line : lines.subList(first, Math.min(lines.size() - 1, first + ROWS))) { // the last may have been cut
            List<String> cells = DelimitedTable.names(line, separator);
            if (cells.size() == names.size()) {
                double[] row = new double[cells.size()];
                for (int i = 0; i < row.length; i++) {
                    String cell = cells.get(i);
                    Timestamps clock = clocks.get(i);
                    row[i] = number(cell, separator).or(() -> clock.of(cell)).orElse(Double.NaN);
                }
                rows.add(row);
            }
        }
        double[][] columns = columns(rows, names.size());
        Optional<Integer> dated = IntStream.range(0, names.size()).boxed()
                .filter(i -> clocks.get(i).origin().isPresent() && MapDraft.rises(columns[i])).findFirst();
        OptionalDouble rate = OptionalDouble.empty();
        for (String line : lines.subList(0, first)) {
            Matcher stated = RATE.matcher(line);
            if (stated.find() && rate.isEmpty()) {
                double hertz = Double.parseDouble(stated.group(1).replace(',', '.')) * (stated.group(2).isEmpty() ? 1 : 1000);
                rate = Clock.isRate(hertz) ? OptionalDouble.of(hertz) : rate;
            }
        }
        String parted = separator == '\t' ? "tabs" : separator == ';' ? "semicolons" : "commas";
        List<Label> labels = names.stream()
                .map(name -> new Label(name, Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), 1)).toList();
        List<Optional<String>> beside = new ArrayList<>();
        for (int i = 0; i < names.size(); i++) {
            beside.add(dated.equals(Optional.of(i)) ? Optional.of("s") : units.isEmpty() ? Optional.empty() : Optional.of(units.get(i)));
        }
        return new ForeignTable("a table parted by " + parted + (units.isEmpty() ? "" : ", with a row of units"), labels, beside,
                columns, dated.map(names::get), rate, false,
                dated.isPresent() ? Optional.empty() : unread(names, DelimitedTable.names(lines.get(first), separator)));
    }

    /** What to do where a clock was written as none reads it for certain. */
    private static Optional<String> unread(List<String> names, List<String> cells) {
        return IntStream.range(0, names.size()).filter(i -> CLOCK.matcher(cells.get(i)).matches()).mapToObj(i -> "When is '" + cells.get(i)
                + "' of '" + names.get(i) + "'? Only dates and times of ISO 8601 are read, such as 2025-03-04T10:15:00.005: write them so, "
                + "or say the rate.").findFirst();
    }

    private static boolean ahead(List<String> lines, int from, char separator, int width) {
        int most = numbers(lines.get(from), separator);
        int good = 0;
        for (int i = from; i < Math.min(lines.size(), from + ENOUGH); i++) {
            good += DelimitedTable.names(lines.get(i), separator).size() == width && numbers(lines.get(i), separator) == most ? 1 : 0;
        }
        return good == ENOUGH && 2 * most >= width;
    }

    private static boolean unitsOnly(List<String> cells) {
        return cells.stream().allMatch(cell -> cell.isEmpty() || cell.equals("-") || UnitWords.of(cell).isPresent());
    }

    private static int numbers(String line, char separator) {
        return (int) DelimitedTable.names(line, separator).stream().filter(cell -> isNumber(cell, separator)).count();
    }

    private static boolean isNumber(String cell, char separator) {
        return number(cell, separator).isPresent() || new Timestamps().of(cell).isPresent();
    }

    private static Optional<Double> number(String cell, char separator) {
        byte[] bytes = cell.getBytes(StandardCharsets.UTF_8);
        try {
            return bytes.length == 0 ? Optional.empty() : Optional.of(Decimal.parse(bytes, 0, bytes.length, separator == ',' ? '.' : ','));
        } catch (NumberFormatException word) {
            return Optional.empty();
        }
    }

    private static double[][] columns(List<double[]> rows, int width) {
        double[][] columns = new double[width][rows.size()];
        for (int i = 0; i < rows.size(); i++) {
            for (int j = 0; j < width; j++) {
                columns[j][i] = rows.get(i)[j];
            }
        }
        return columns;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ForeignTable table && labels.equals(table.labels) && Arrays.deepEquals(values, table.values);
    }

    @Override
    public int hashCode() {
        return labels.hashCode();
    }
}

package wbv.recording.format;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonFactoryBuilder;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/**
 * Rows from lines that come one by one, of a stream that has no end. What a line is, it says itself:
 *
 * <ul>
 * <li>CSV: a header {@code t,seat.acc.z,…} (or the columns of a Movella DOT, {@code PacketCounter,SampleTimeFine,…}, or of a map),
 * then rows; a header may come again, and be another from then on. ARFF likewise.</li>
 * <li>JSON: an object with the same names, {@code {"seat": "7", "t": 0.1, "seat.acc.z": 0.3}}; lists hold several rows. A DOT's
 * tag stands in {@code "sensor"}.</li>
 * </ul>
 *
 * <p>A column or field {@code seat} says whose row it is. A line that cannot be read is refused by itself: the next one is read
 * as if it had not been there. One object for each sender, since each has its own header.
 */
public final class RowLines {

    /** Takes what lines hold. */
    public interface Sink {

        /**
         * A row.
         *
         * @param seat     whose it is; empty where the line does not say
         * @param channels of the row, the same list for all rows under one header
         * @param row      time [s], then the channels in SI units, one more than channels long; NaN is missing. Not to be modified. Used
         *                 again: copy what is kept.
         */
        void row(String seat, List<Channel> channels, double[] row);
    }

    /** Rows that one JSON object may hold. */
    private static final int MOST_ROWS = 100_000;
    /** Headers of JSON objects that are remembered. */
    private static final int MOST_HEADERS = 64;
    private static final int LONGEST_SEAT = 128;
    private static final String SENSOR = "sensor";

    private final String name;
    private final ReadOptions options;
    private final JsonFactory factory = new JsonFactoryBuilder().streamReadConstraints(StreamReadConstraints.builder()
            .maxNestingDepth(4).maxStringLength(1024).maxNumberLength(64).maxNameLength(256).build())
            .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).build();
    private final Map<List<String>, RowColumns> objects = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<List<String>, RowColumns> eldest) {
            return size() > MOST_HEADERS;
        }
    };
    private final List<String> attributes = new ArrayList<>();
    private final List<Object> fields = new ArrayList<>();
    private String tag = "";
    private RowColumns columns;
    private Cells cells;
    private long line;

    /**
     * Knows no columns before a header comes.
     *
     * @param name the stream, for messages
     * @param options what the user says of it
     */
    public RowLines(String name, ReadOptions options) {
        this.name = name;
        this.options = options;
    }

    /**
     * Takes the next line, without its end: the bytes from one index to before another, in UTF-8. Not modified.
     *
     * @throws DataFault if it cannot be read, naming stream and line; rows of the same line before the fault were given
     */
    public void accept(byte[] text, int from, int to, Sink sink) {
        line++;
        int start = from;
        int stop = to;
        if (line == 1 && stop - start >= 3 && text[start] == (byte) 0xEF && text[start + 1] == (byte) 0xBB
                && text[start + 2] == (byte) 0xBF) {
            start += 3;
        }
        while (stop > start && text[stop - 1] >= 0 && text[stop - 1] <= ' ' && text[stop - 1] != '\t') {
            stop--;
        }
        while (start < stop && text[start] == ' ') {
            start++;
        }
        if (start == stop || text[start] == '#' || text[start] == '%') {
            return;
        }
        try {
            if (text[start] == '{') {
                object(text, start, stop, sink);
            } else if (text[start] == '@') {
                attribute(new String(text, start, stop - start, StandardCharsets.UTF_8));
            } else if (!header(text, start, stop)) {
                row(text, start, stop, sink);
            }
        } catch (DataFault wrong) {
            throw wrong.at(name, line);
        }
    }

    /** Lines taken. */
    public long line() {
        return line;
    }

    private void row(byte[] text, int from, int to, Sink sink) {
        if (cells == null) {
            throw new DataFault("there is no header yet: a stream of CSV begins with t,seat.acc.z,… or says its columns by --columns");
        }
        cells.read(text, from, to, columns.raw());
        String seat = cells.hasWord() ? seat(cells.word(text)) : "";
        sink.row(seat, columns.channels(), columns.row());
    }

    /** Takes a line that names columns, or stands above one in a DOT's export. */
    private boolean header(byte[] text, int from, int to) {
        if ("+-.0123456789?,;\t".indexOf(text[from]) >= 0) {
            return false;
        }
        String words = new String(text, from, to - from, StandardCharsets.UTF_8);
        char separator = DelimitedTable.separator(words);
        List<String> names = DelimitedTable.names(words, separator);
        if (RowColumns.names(names, options)) {
            head(names, separator);
            return true;
        }
        if (words.startsWith("sep=")) {
            return true;
        }
        boolean note = names.get(0).endsWith(":") && names.get(0).length() > 1;
        if (note && names.get(0).equals("DeviceTag:") && names.size() > 1) {
            tag = names.get(1);
        }
        return note;
    }

    private void head(List<String> names, char separator) {
        if (columns == null || !columns.names().equals(names)) {
            RowColumns found = RowColumns.of(name, line, names, tag, options);
            columns = found;
            cells = new Cells(names, found.slots(), separator);
        }
    }

    private void attribute(String text) {
        String lower = text.toLowerCase(Locale.ROOT);
        if (lower.startsWith("@relation")) {
            attributes.clear();
        } else if (lower.startsWith("@attribute")) {
            if (attributes.size() >= 10_000) {
                throw new DataFault("more than 10000 attributes");
            }
            attributes.add(ArffFormat.attribute(name, line, text.substring("@attribute".length()).strip()));
        } else if (lower.startsWith("@data")) {
            head(List.copyOf(attributes), ',');
        } else {
            throw new DataFault("before @data there may be @attribute lines only");
        }
    }

    private void object(byte[] text, int from, int to, Sink sink) {
        List<String> names = new ArrayList<>();
        fields.clear();
        String seat = "";
        String sensor = "";
        try (JsonParser parser = factory.createParser(text, from, to - from)) {
            parser.nextToken();
            while (parser.nextToken() == JsonToken.FIELD_NAME) {
                String field = parser.currentName();
                JsonToken token = parser.nextToken();
                if (field.equals(RowColumns.SEAT)) {
                    seat = seat(word(field, token, parser));
                } else if (field.equals(SENSOR)) {
                    sensor = word(field, token, parser);
                } else {
                    names.add(field);
                    fields.add(token == JsonToken.START_ARRAY ? numbers(field, parser) : (Object) number(field, token, parser));
                }
            }
            if (parser.currentToken() != JsonToken.END_OBJECT || parser.nextToken() != null) {
                throw new DataFault("is not one JSON object");
            }
        } catch (JsonProcessingException wrong) {
            String why = wrong.getOriginalMessage();
            throw new DataFault("is not JSON: " + (why == null ? "cut off" : why.lines().findFirst().orElse("")));
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        rows(seat, meaning(names, sensor), sink);
    }

    private RowColumns meaning(List<String> names, String sensor) {
        List<String> key = new ArrayList<>(names);
        key.add(sensor);
        RowColumns known = objects.get(key);
        if (known == null) {
            known = RowColumns.of(name, line, names, sensor, options);
            objects.put(key, known);
        }
        return known;
    }

    private void rows(String seat, RowColumns meaning, Sink sink) {
        int length = -1;
        for (Object field : fields) {
            if (field instanceof double[] list) {
                if (length >= 0 && list.length != length || list.length == 0) {
                    throw new DataFault("its lists must be equally long: " + length + " and " + list.length);
                }
                length = list.length;
            }
        }
        int count = Math.max(1, length);
        int[] slots = meaning.slots();
        for (int i = 0; i < count; i++) {
            meaning.clear();
            for (int k = 0; k < slots.length; k++) {
                if (slots[k] >= 0) {
                    if (fields.get(k) instanceof double[] list) {
                        meaning.raw()[slots[k]] = list[i];
                    } else if (length < 0) {
                        meaning.raw()[slots[k]] = (Double) fields.get(k);
                    } else {
                        throw new DataFault(meaning.names().get(k) + " must be a list as the others are");
                    }
                }
            }
            sink.row(seat, meaning.channels(), meaning.row());
        }
    }

    private double[] numbers(String field, JsonParser parser) throws IOException {
        double[] list = new double[16];
        int length = 0;
        for (JsonToken token = parser.nextToken(); token != JsonToken.END_ARRAY; token = parser.nextToken()) {
            if (length == MOST_ROWS) {
                throw new DataFault(field + " holds more than " + MOST_ROWS + " numbers");
            }
            if (length == list.length) {
                list = java.util.Arrays.copyOf(list, 2 * length);
            }
            list[length++] = number(field, token, parser);
        }
        return java.util.Arrays.copyOf(list, length);
    }

    private static double number(String field, JsonToken token, JsonParser parser) throws IOException {
        if (token == JsonToken.VALUE_NULL) {
            return Double.NaN;
        }
        if (token == null || !token.isNumeric()) {
            throw new DataFault("field " + shortened(field) + " must be a number, null where it is missing, or a list of these");
        }
        double value = parser.getDoubleValue();
        if (!Double.isFinite(value)) {
            throw new DataFault("field " + shortened(field) + " must be a finite number");
        }
        return value;
    }

    private static String word(String field, JsonToken token, JsonParser parser) throws IOException {
        if (token == JsonToken.VALUE_STRING || token == JsonToken.VALUE_NUMBER_INT) {
            return parser.getText();
        }
        throw new DataFault("field " + field + " must be a word");
    }

    /**
     * Whose row it is.
     *
     * @throws DataFault if a name is longer than any is
     */
    private static String seat(String word) {
        if (word.length() > LONGEST_SEAT) {
            throw new DataFault("a seat's name has " + LONGEST_SEAT + " letters at most: " + word.substring(0, 40) + "…");
        }
        return word;
    }

    private static String shortened(String text) {
        return text.length() > 40 ? text.substring(0, 40) + "…" : text;
    }
}

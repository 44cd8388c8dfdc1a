package wbv.result;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.JsonSerializer;
import com.fasterxml.jackson.databind.ObjectWriter;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.SerializerProvider;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.module.SimpleModule;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.recording.AtomicFile;

/**
 * Results as JSON for machines: records, lists, maps, arrays, strings and numbers.
 *
 * <p>Deterministic: records in the order of their components, maps in the order of their keys, one line ending. Doubles are
 * written so that they read back equal; NaN, the infinities and empty optionals become null.
 */
public final class ResultsJson {

    private static final ObjectWriter WRITER = writer();

    private ResultsJson() {}

    /** The JSON text, ending with a line feed. */
    public static String render(Object results) throws IOException {
        return WRITER.writeValueAsString(results) + '\n';
    }

    /** Writes the JSON text to a file, whole or not at all. */
    public static void write(Object results, Path file) throws IOException {
        AtomicFile.write(file, render(results).getBytes(StandardCharsets.UTF_8));
    }

    private static ObjectWriter writer() {
        SimpleModule numbers = new SimpleModule();
        numbers.addSerializer(Double.class, serializer((value, json, all) -> number(value, json)));
        numbers.addSerializer(double.class, serializer((value, json, all) -> number(value, json)));
        numbers.addSerializer(double[].class, serializer((values, json, all) -> {
            json.writeStartArray();
            for (double value : values) {
                number(value, json);
            }
            json.writeEndArray();
        }));
        numbers.addSerializer(OptionalDouble.class, serializer((value, json, all) -> number(value.orElse(Double.NaN), json)));
        numbers.addSerializer(Optional.class,
                serializer((value, json, all) -> all.defaultSerializeValue(value.isPresent() ? value.get() : null, json)));
        DefaultIndenter lines = new DefaultIndenter("  ", "\n");
        return JsonMapper.builder().addModule(numbers).enable(SerializationFeature.ORDER_MAP_ENTRIES_BY_KEYS).build()
                .writer(new DefaultPrettyPrinter().withObjectIndenter(lines));
    }

    private static void number(double value, JsonGenerator json) throws IOException {
        if (Double.isFinite(value)) {
            json.writeNumber(value);
        } else {
            json.writeNull();
        }
    }

    /** How one kind of value is written. */
    private interface Form<T> {
        void write(T value, JsonGenerator json, SerializerProvider all) throws IOException;
    }

    private static <T> JsonSerializer<T> serializer(Form<T> form) {
        return new JsonSerializer<>() {
            @Override
            public void serialize(T value, JsonGenerator json, SerializerProvider all) throws IOException {
                form.write(value, json, all);
            }
        };
    }
}

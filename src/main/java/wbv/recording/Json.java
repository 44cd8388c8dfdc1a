package wbv.recording;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * An object in a JSON file that knows where it stands, so that every fault names its field.
 *
 * @param file  the file, for messages
 * @param where the field that this object is the value of, dotted; empty for the whole file
 */
public record Json(String file, String where, JsonNode node) {

    /** Plain Jackson: what is read or written has no types in it. */
    public static final ObjectMapper MAPPER = new ObjectMapper();

    public Json {
        if (!node.isObject()) {
            throw DataFault.in(file, (where.isEmpty() ? "the file" : "'" + where + "'") + " must be a JSON object {…}");
        }
    }

    /** The object that a file holds. */
    public static Json read(Path path) throws IOException {
        try {
            return new Json(path.toString(), "", MAPPER.readTree(InputFile.text(path, "it should hold a JSON object {…}")));
        } catch (JsonProcessingException wrong) {
            throw InputFile.notJson(path.toString(), wrong);
        }
    }

    /** Faults a field that is none of those known, such as one misspelt. */
    public void only(String... known) {
        List<String> fields = List.of(known);
        for (Iterator<String> names = node.fieldNames(); names.hasNext();) {
            String name = names.next();
            if (!fields.contains(name)) {
                throw fault(name, "is not known; known are " + String.join(", ", fields));
            }
        }
    }

    /** A fault that names the field: {@code 'dotted.path' message}. */
    public DataFault fault(String field, String message) {
        return DataFault.in(file, "'" + path(field) + "' " + message);
    }

    private String path(String field) {
        return where.isEmpty() ? field : where + "." + field;
    }

    /** Whether the field is there and not JSON's null. */
    public boolean has(String field) {
        return node.hasNonNull(field);
    }

    /** A text, or a number or truth value as text; empty where it is absent. A list or an object is a fault. */
    public Optional<String> text(String field) {
        if (!has(field)) {
            return Optional.empty();
        }
        JsonNode value = node.get(field);
        if (!value.isValueNode()) {
            throw fault(field, "must be a text: " + value);
        }
        return Optional.of(value.asText());
    }

    /**
     * A number between two bounds, both included.
     *
     * @param least in the unit of the field
     * @param most likewise
     */
    public OptionalDouble number(String field, double least, double most) {
        if (!has(field)) {
            return OptionalDouble.empty();
        }
        JsonNode value = node.get(field);
        if (!value.isNumber() || !(value.asDouble() >= least && value.asDouble() <= most)) {
            throw fault(field, "must be a number from " + least + " to " + most + ": " + value);
        }
        return OptionalDouble.of(value.asDouble());
    }

    /** The object that is the field's value, knowing its place; empty where it is absent. */
    public Optional<Json> object(String field) {
        return has(field) ? Optional.of(new Json(file, path(field), node.get(field))) : Optional.empty();
    }

    /** The fields of an object of objects, in their order. */
    public Map<String, Json> objects() {
        Map<String, Json> objects = new LinkedHashMap<>();
        node.fieldNames().forEachRemaining(name -> objects.put(name, new Json(file, path(name), node.get(name))));
        return objects;
    }

    /** The texts of an object of texts, in their order; none if there is no such field. */
    public Map<String, String> texts(String field) {
        Map<String, String> texts = new LinkedHashMap<>();
        object(field).ifPresent(inner -> inner.node.fieldNames()
                .forEachRemaining(name -> texts.put(name, inner.text(name).orElse(""))));
        return texts;
    }
}

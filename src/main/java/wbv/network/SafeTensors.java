package wbv.network;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import wbv.recording.DataFault;

/**
 * Named arrays of 32-bit numbers with words beside them, as a file of Hugging Face's format safetensors: the length of a JSON
 * header (64 bits, little end first), the header, the numbers. Nothing in it can be executed; Python reads it with
 * {@code safetensors.numpy.load_file}.
 *
 * @param words   texts by name
 * @param tensors arrays by name, in the order in which they are stored
 */
public record SafeTensors(Map<String, String> words, Map<String, Tensor> tensors) {

    private static final ObjectMapper MAPPER = new ObjectMapper();
    private static final String METADATA = "__metadata__";
    private static final int MOST_HEADER = 1 << 24;

    /**
     * An array.
     *
     * @param shape row-major
     * @param values as many as the shape says; not copied
     */
    public record Tensor(long[] shape, float[] values) {}

    /** The file's bytes. */
    public byte[] bytes() {
        ObjectNode header = MAPPER.createObjectNode();
        words.forEach(header.putObject(METADATA)::put);
        long at = 0;
        for (Map.Entry<String, Tensor> entry : tensors.entrySet()) {
            ObjectNode each = header.putObject(entry.getKey()).put("dtype", "F32");
            each.set("shape", MAPPER.valueToTree(entry.getValue().shape()));
            long end = at + 4L * entry.getValue().values().length;
            each.set("data_offsets", MAPPER.valueToTree(new long[] {at, end}));
            at = end;
        }
        StringBuilder json = new StringBuilder(header.toString());
        byte[] text = json.toString().getBytes(StandardCharsets.UTF_8);
        int padded = (text.length + 7) / 8 * 8;
        ByteBuffer out = ByteBuffer.allocate(Math.toIntExact(8 + padded + at)).order(ByteOrder.LITTLE_ENDIAN);
        out.putLong(padded).put(text);
        for (int i = text.length; i < padded; i++) {
            out.put((byte) ' ');
        }
        tensors.values().forEach(tensor -> {
            for (float value : tensor.values()) {
                out.putFloat(value);
            }
        });
        return out.array();
    }

    /**
     * Reads a file.
     *
     * @param name of the file, for messages
     * @param bytes Not modified.
     * @throws DataFault if it is no such file, or not all of it
     */
    public static SafeTensors parse(String name, byte[] bytes) {
        ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        long length = bytes.length < 8 ? -1 : in.getLong();
        if (length < 2 || length > MOST_HEADER || length > bytes.length - 8) {
            throw DataFault.in(name, "is no safetensors file, or cut short; a model is what 'wbv net train' writes");
        }
        JsonNode header;
        try {
            header = MAPPER.readTree(bytes, 8, (int) length);
        } catch (IOException wrong) { // no JSON, or no text at all
            throw DataFault.in(name, "is no safetensors file: its header is not JSON", wrong);
        }
        if (!header.isObject()) {
            throw DataFault.in(name, "is no safetensors file: its header is no JSON object {…}");
        }
        int start = 8 + (int) length;
        Map<String, String> words = new LinkedHashMap<>();
        Map<String, Tensor> tensors = new LinkedHashMap<>();
        for (Iterator<Map.Entry<String, JsonNode>> fields = header.fields(); fields.hasNext();) {
            Map.Entry<String, JsonNode> field = fields.next();
            if (field.getKey().equals(METADATA)) {
                field.getValue().fields().forEachRemaining(word -> words.put(word.getKey(), word.getValue().asText()));
            } else {
                tensors.put(field.getKey(), tensor(name, field.getKey(), field.getValue(), bytes, start));
            }
        }
        return new SafeTensors(words, tensors);
    }

    private static Tensor tensor(String file, String name, JsonNode node, byte[] bytes, int start) {
        long[] shape = new long[node.path("shape").size()];
        long count = 1;
        for (int i = 0; i < shape.length; i++) {
            shape[i] = node.path("shape").path(i).asLong(-1);
            count = shape[i] < 0 || shape[i] > Integer.MAX_VALUE || count < 0 || count > Integer.MAX_VALUE ? -1 : count * shape[i];
        }
        long from = node.path("data_offsets").path(0).asLong(-1);
        long to = node.path("data_offsets").path(1).asLong(-1);
        if (!node.path("dtype").asText().equals("F32") || count < 0 || from < 0 || to - from != 4 * count) {
            throw DataFault.in(file, "'" + name + "' is no array of 32-bit numbers with a shape and a place in the file");
        }
        if (start + to > bytes.length) {
            throw DataFault.in(file, "is cut short: '" + name + "' ends at byte " + (start + to) + " of " + bytes.length);
        }
        float[] values = new float[(int) count];
        ByteBuffer.wrap(bytes, start + (int) from, (int) (to - from)).order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer().get(values);
        for (float value : values) {
            if (!Float.isFinite(value)) {
                throw DataFault.in(file, "'" + name + "' must hold finite numbers: " + value);
            }
        }
        return new Tensor(shape, values);
    }
}

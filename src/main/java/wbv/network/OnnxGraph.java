package wbv.network;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** A graph of ONNX operators being written in the format's protocol buffers, as far as networks here need them (opset 13). */
final class OnnxGraph {

    private static final int FLOAT = 1;
    private static final int INT64 = 7;
    private static final int OPSET = 13;
    private static final int IR_VERSION = 8;

    private final Message graph = new Message();
    private int names;

    /** A message of protocol buffers: fields with their numbers, of variable length or whole numbers. */
    private static final class Message {
        private final ByteArrayOutputStream out = new ByteArrayOutputStream();

        Message number(int field, long value) {
            varint((long) field << 3);
            varint(value);
            return this;
        }

        Message bytes(int field, byte[] value) {
            varint((long) field << 3 | 2);
            varint(value.length);
            out.writeBytes(value);
            return this;
        }

        Message text(int field, String value) {
            return bytes(field, value.getBytes(StandardCharsets.UTF_8));
        }

        Message message(int field, Message value) {
            return bytes(field, value.out.toByteArray());
        }

        private void varint(long value) {
            long rest = value;
            while ((rest & ~0x7FL) != 0) {
                out.write((int) (rest & 0x7F | 0x80));
                rest >>>= 7;
            }
            out.write((int) rest);
        }
    }

    /**
     * What changes how an operator works.
     *
     * @param ints one or more; one that is no list is said so
     */
    record Attribute(String name, boolean list, long... ints) {
        static Attribute of(String name, long value) {
            return new Attribute(name, false, value);
        }

        static Attribute list(String name, long... values) {
            return new Attribute(name, true, values);
        }
    }

    /**
     * An operator.
     *
     * @return name of its output
     */
    String node(String operator, List<String> inputs, Attribute... attributes) {
        String output = operator.toLowerCase(Locale.ROOT) + names++;
        node(operator, inputs, output, attributes);
        return output;
    }

    /** An operator with a name for its output. */
    void node(String operator, List<String> inputs, String output, Attribute... attributes) {
        Message node = new Message();
        inputs.forEach(input -> node.text(1, input));
        node.text(2, output).text(4, operator);
        for (Attribute attribute : attributes) {
            Message each = new Message().text(1, attribute.name());
            for (long value : attribute.ints()) {
                each.number(attribute.list() ? 8 : 3, value);
            }
            node.message(5, each.number(20, attribute.list() ? 7 : 2));
        }
        graph.message(1, node);
    }

    /**
     * A constant of 32-bit numbers.
     *
     * @return its name
     */
    String constant(float[] values, long... shape) {
        ByteBuffer raw = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        raw.asFloatBuffer().put(values);
        return constant(FLOAT, raw.array(), shape);
    }

    /**
     * A constant of whole numbers.
     *
     * @return its name
     */
    String constant(long... values) {
        ByteBuffer raw = ByteBuffer.allocate(8 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        raw.asLongBuffer().put(values);
        return constant(INT64, raw.array(), values.length);
    }

    private String constant(int type, byte[] raw, long... shape) {
        Message tensor = new Message();
        for (long length : shape) {
            tensor.number(1, length);
        }
        String name = "c" + names++;
        graph.message(5, tensor.number(2, type).text(8, name).bytes(9, raw));
        return name;
    }

    /** An input of the graph; the first length is free. */
    void input(String name, long... rest) {
        graph.message(11, value(name, rest));
    }

    /** An output of the graph; the first length is free. */
    void output(String name, long... rest) {
        graph.message(12, value(name, rest));
    }

    private static Message value(String name, long... rest) {
        Message shape = new Message().message(1, new Message().text(2, "n"));
        for (long length : rest) {
            shape.message(1, new Message().number(1, length));
        }
        Message tensor = new Message().number(1, FLOAT).message(2, shape);
        return new Message().text(1, name).message(2, new Message().message(1, tensor));
    }

    /**
     * The file.
     *
     * @param words that it says of itself
     */
    byte[] bytes(String name, Map<String, String> words) {
        Message model = new Message().number(1, IR_VERSION).text(2, "wbv").message(7, graph.text(2, name))
                .message(8, new Message().text(1, "").number(2, OPSET));
        words.forEach((key, text) -> model.message(14, new Message().text(1, key).text(2, text)));
        return model.out.toByteArray();
    }
}

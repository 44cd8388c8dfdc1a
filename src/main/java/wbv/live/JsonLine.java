package wbv.live;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;

/** One JSON object as a line of text. Numbers have six digits at most: nobody measures more; what is no number is null. */
final class JsonLine {

    /** Writes fields. */
    interface Fields {
        void write(JsonLine json) throws IOException;
    }

    private static final JsonFactory FACTORY = new JsonFactory();
    private static final int DIGITS = 6;

    private final JsonGenerator out;

    private JsonLine(JsonGenerator out) {
        this.out = out;
    }

    static String object(Fields fields) {
        StringWriter text = new StringWriter();
        try (JsonGenerator generator = FACTORY.createGenerator(text)) {
            generator.writeStartObject();
            fields.write(new JsonLine(generator));
            generator.writeEndObject();
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
        return text.toString();
    }

    JsonLine text(String name, String value) throws IOException {
        out.writeStringField(name, value);
        return this;
    }

    JsonLine number(String name, double value) throws IOException {
        out.writeFieldName(name);
        return number(value);
    }

    /** A time, exact to the microsecond [s]. */
    JsonLine time(String name, double value) throws IOException {
        out.writeFieldName(name);
        return time(value);
    }

    /** A time in a list, likewise. */
    JsonLine time(double value) throws IOException {
        return Double.isFinite(value) ? raw(Math.rint(value * 1e6) / 1e6) : number(value);
    }

    JsonLine count(String name, long value) throws IOException {
        out.writeNumberField(name, value);
        return this;
    }

    JsonLine truth(String name, boolean value) throws IOException {
        out.writeBooleanField(name, value);
        return this;
    }

    JsonLine nested(String name, Fields fields) throws IOException {
        out.writeObjectFieldStart(name);
        fields.write(this);
        out.writeEndObject();
        return this;
    }

    JsonLine list(String name, Fields items) throws IOException {
        out.writeArrayFieldStart(name);
        items.write(this);
        out.writeEndArray();
        return this;
    }

    /** An object in a list. */
    JsonLine item(Fields fields) throws IOException {
        out.writeStartObject();
        fields.write(this);
        out.writeEndObject();
        return this;
    }

    /** A text in a list. */
    JsonLine item(String text) throws IOException {
        out.writeString(text);
        return this;
    }

    /** A number in a list. */
    JsonLine number(double value) throws IOException {
        if (!Double.isFinite(value)) {
            out.writeNull();
            return this;
        }
        return raw(rounded(value));
    }

    private JsonLine raw(double value) throws IOException {
        if (value == Math.rint(value) && Math.abs(value) < 1e15) {
            out.writeNumber((long) value);
        } else {
            out.writeNumber(value);
        }
        return this;
    }

    private static double rounded(double value) {
        if (value == 0) {
            return 0;
        }
        double decimals = DIGITS - 1 - Math.floor(Math.log10(Math.abs(value)));
        double scale = Math.pow(10, Math.abs(decimals));
        double rounded = decimals >= 0 ? Math.rint(value * scale) / scale : Math.rint(value / scale) * scale;
        return Double.isFinite(rounded) ? rounded : value;
    }
}

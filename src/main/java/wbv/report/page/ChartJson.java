package wbv.report.page;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;

/**
 * The data of a chart as compact JSON for the page's script.
 *
 * <p>Evenly spaced x are written as {@code {"from", "step", "count"}}, others exactly; x shared by several curves stand once, in
 * {@code xs}. Values are written in single precision (relative error below 6e-8, finer than any screen), NaN as null. Heat maps
 * are base64 of one byte a value: 0 to 254 from the low to the high end of the colour axis, 255 for a hole.
 */
public final class ChartJson {

    /** Points from which on a curve is written in two bytes each. */
    public static final int LONG = 1000;

    private static final JsonFactory FACTORY = new JsonFactory();

    private ChartJson() {}

    /** The object, on one line. */
    public static String of(Chart chart) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = FACTORY.createGenerator(text)) {
            json.writeStartObject();
            json.writeStringField("title", chart.title());
            json.writeStringField("group", chart.group());
            axis(json, "x", chart.x());
            axis(json, "y", chart.y());
            if (chart instanceof LineChart lines) {
                line(json, lines);
            } else if (chart instanceof XyChart xy) {
                xy(json, xy);
            } else if (chart instanceof BarChart bars) {
                bars(json, bars);
            } else if (chart instanceof Heatmap map) {
                heatmap(json, map);
            } else {
                throw new IllegalStateException("no data of " + chart.getClass());
            }
            json.writeEndObject();
        } catch (IOException e) {
            throw new UncheckedIOException(e); // a StringWriter does not fail
        }
        return text.toString();
    }

    private static void axis(JsonGenerator json, String name, ChartAxis axis) throws IOException {
        json.writeObjectFieldStart(name);
        json.writeStringField("label", axis.label());
        json.writeStringField("unit", axis.unit());
        json.writeBooleanField("log", axis.scale() == ChartAxis.Scale.LOG);
        json.writeFieldName("low");
        exact(json, axis.low());
        json.writeFieldName("high");
        exact(json, axis.high());
        if (!axis.names().isEmpty()) {
            json.writeArrayFieldStart("names");
            for (String each : axis.names()) {
                json.writeString(each);
            }
            json.writeEndArray();
        }
        json.writeEndObject();
    }

    private static void line(JsonGenerator json, LineChart chart) throws IOException {
        json.writeStringField("kind", "line");
        List<double[]> xs = new ArrayList<>();
        json.writeArrayFieldStart("series");
        for (Series series : chart.series()) {
            int index = 0;
            while (index < xs.size() && xs.get(index) != series.x()) {
                index++;
            }
            if (index == xs.size()) {
                xs.add(series.x());
            }
            json.writeStartObject();
            json.writeStringField("name", series.name());
            json.writeStringField("style", series.style().name().toLowerCase(Locale.ROOT));
            json.writeNumberField("x", index);
            boolean packed = series.y().length >= LONG && chart.y().scale() == ChartAxis.Scale.LINEAR;
            curve(json, "y", series.y(), packed);
            if (series.band().lower().length > 0) {
                json.writeObjectFieldStart("band");
                json.writeStringField("kind", series.band().kind().name().toLowerCase(Locale.ROOT));
                json.writeStringField("meaning", series.band().meaning());
                curve(json, "lower", series.band().lower(), packed);
                curve(json, "upper", series.band().upper(), packed);
                json.writeEndObject();
            }
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeArrayFieldStart("xs");
        for (double[] x : xs) {
            positions(json, x);
        }
        json.writeEndArray();
        markers(json, chart.markers());
        json.writeArrayFieldStart("shades");
        for (LineChart.Shade shade : chart.shades()) {
            json.writeStartArray();
            exact(json, shade.from());
            exact(json, shade.to());
            json.writeString(shade.reason());
            json.writeNumber(shade.pattern());
            json.writeEndArray();
        }
        json.writeEndArray();
    }

    private static void xy(JsonGenerator json, XyChart chart) throws IOException {
        json.writeStringField("kind", "xy");
        json.writeArrayFieldStart("series");
        for (XySeries series : chart.series()) {
            json.writeStartObject();
            json.writeStringField("name", series.name());
            json.writeStringField("style", series.style().name().toLowerCase(Locale.ROOT));
            json.writeNumberField("colour", series.colour());
            values(json, "x", series.x());
            values(json, "y", series.y());
            if (series.whisker().length > 0) {
                values(json, "whisker", series.whisker());
            }
            json.writeEndObject();
        }
        json.writeEndArray();
    }

    private static void bars(JsonGenerator json, BarChart chart) throws IOException {
        json.writeStringField("kind", "bars");
        json.writeArrayFieldStart("groups");
        for (String group : chart.groups()) {
            json.writeString(group);
        }
        json.writeEndArray();
        json.writeArrayFieldStart("bars");
        for (BarChart.Bars each : chart.bars()) {
            json.writeStartObject();
            json.writeStringField("name", each.name());
            json.writeNumberField("colour", each.colour());
            values(json, "values", each.values());
            if (each.low().length > 0) {
                values(json, "low", each.low());
                values(json, "high", each.high());
            }
            json.writeEndObject();
        }
        json.writeEndArray();
        markers(json, chart.markers());
    }

    private static void markers(JsonGenerator json, List<LineChart.Marker> markers) throws IOException {
        json.writeArrayFieldStart("markers");
        for (LineChart.Marker marker : markers) {
            json.writeStartArray();
            exact(json, marker.x());
            json.writeString(marker.label());
            json.writeEndArray();
        }
        json.writeEndArray();
    }

    private static void heatmap(JsonGenerator json, Heatmap chart) throws IOException {
        json.writeStringField("kind", "heatmap");
        axis(json, "colour", chart.colour());
        json.writeFieldName("columns");
        positions(json, chart.columns());
        json.writeFieldName("rows");
        positions(json, chart.rows());
        double low = chart.colour().low();
        double scale = 254 / (chart.colour().high() - low);
        int rows = chart.rows().length;
        byte[] levels = new byte[chart.columns().length * rows];
        for (int i = 0; i < levels.length; i++) {
            double value = chart.values()[i / rows][i % rows];
            long level = Double.isNaN(value) ? 255 : Math.round(Math.max(0, Math.min(254, (value - low) * scale)));
            levels[i] = (byte) level;
        }
        json.writeStringField("levels", Base64.getEncoder().encodeToString(levels));
    }

    private static void positions(JsonGenerator json, double[] x) throws IOException {
        int count = x.length;
        double step = count > 1 ? (x[count - 1] - x[0]) / (count - 1) : 0;
        boolean even = count > 2;
        for (int i = 0; i < count && even; i++) {
            even = Math.abs(x[i] - (x[0] + i * step)) <= 1e-12 * Math.max(Math.abs(x[0]), Math.abs(x[count - 1]));
        }
        if (even) {
            json.writeStartObject();
            json.writeNumberField("from", x[0]);
            json.writeNumberField("step", step);
            json.writeNumberField("count", count);
            json.writeEndObject();
        } else {
            json.writeStartArray();
            for (double value : x) {
                exact(json, value);
            }
            json.writeEndArray();
        }
    }

    private static void curve(JsonGenerator json, String name, double[] values, boolean packed) throws IOException {
        if (packed) {
            packed(json, name, values);
        } else {
            values(json, name, values);
        }
    }

    private static void packed(JsonGenerator json, String name, double[] values) throws IOException {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (double value : values) {
            if (Double.isFinite(value)) {
                low = Math.min(low, value);
                high = Math.max(high, value);
            }
        }
        low = low <= high ? low : 0;
        double step = high > low ? high / 65534 - low / 65534 : 1;
        ByteBuffer codes = ByteBuffer.allocate(2 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (double value : values) {
            codes.putShort((short) (Double.isFinite(value) ? Math.round((value - low) / step) - 32767 : Short.MIN_VALUE));
        }
        json.writeObjectFieldStart(name);
        json.writeNumberField("low", low);
        json.writeNumberField("step", step);
        json.writeStringField("codes", Base64.getEncoder().encodeToString(codes.array()));
        json.writeEndObject();
    }

    private static void values(JsonGenerator json, String name, double[] values) throws IOException {
        json.writeArrayFieldStart(name);
        for (double value : values) {
            float single = (float) value;
            if (!Float.isFinite(single)) {
                json.writeNull();
            } else if (single == Math.rint(single) && Math.abs(single) < 1e7) {
                json.writeNumber((int) single);
            } else {
                json.writeNumber(single);
            }
        }
        json.writeEndArray();
    }

    private static void exact(JsonGenerator json, double value) throws IOException {
        if (Double.isFinite(value)) {
            json.writeNumber(value);
        } else {
            json.writeNull();
        }
    }
}

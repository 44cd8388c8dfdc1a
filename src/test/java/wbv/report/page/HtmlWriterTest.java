package wbv.report.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Deque;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.report.page.Figures.Figure;
import wbv.report.page.Findings.Finding;
import wbv.report.page.Findings.Severity;
import wbv.report.page.Table.Column;

class HtmlWriterTest {

    private static final String HOSTILE = "<script>alert(1)</script>\"'&--><!--</style>\u2028";

    @Test
    void everyTagIsClosedInOrder() {
        assertBalanced(HtmlWriter.render(DemoPage.page()));
        assertBalanced(HtmlWriter.render(hostilePage()));
    }

    @Test
    void demonstrationPageIsWrittenForTheEye() throws IOException {
        Path file = Path.of("target", "demo-report.html");
        HtmlWriter.write(DemoPage.page(), file);
        assertEquals(HtmlWriter.render(DemoPage.page()), Files.readString(file));
    }

    @Test
    void nothingIsLoadedFromOutside() {
        String html = HtmlWriter.render(DemoPage.page()).replaceAll("\"codes\":\"[A-Za-z0-9+/=]*\"", ""); // samples may spell anything
        assertFalse(Pattern.compile("https?://|//[a-z0-9.-]+/|@import|url\\(|\\ssrc=|<link|fetch\\(|XMLHttpRequest")
                .matcher(html).find());
        assertTrue(html.contains("default-src 'none'"));
    }

    @Test
    void hostileTextStaysText() {
        String html = HtmlWriter.render(hostilePage());
        assertEquals(0, count(html, "<script>alert"));
        assertEquals(1, count(html, "<style>"));
        assertEquals(3, count(html, "<script")); // two charts' data and the program
        assertEquals(3, count(html, "</script"));
        assertEquals(0, count(html, "<!--"));
        assertTrue(html.contains("<title>&lt;script&gt;alert(1)&lt;/script&gt;&quot;&#39;&amp;--&gt;&lt;!--&lt;/style&gt;"));
        for (JsonNode data : data(html)) {
            assertEquals(HOSTILE, data.get("title").asText());
        }
    }

    @Test
    void chartDataReadBackEqual() {
        Random random = new Random(1);
        double[] uniform = new double[500];
        double[] ragged = new double[500];
        double[] y = new double[500];
        for (int i = 0; i < 500; i++) {
            uniform[i] = 12.5 + i / 60.0;
            ragged[i] = i + random.nextDouble();
            y[i] = i % 50 == 7 ? Double.NaN : random.nextGaussian() * Math.pow(10, random.nextInt(20) - 10);
        }
        LineChart chart = new LineChart("c", ChartAxis.linear("t", "s"), ChartAxis.linear("a", "m"), List.of(
                Series.line("even", uniform, y).with(Band.extremes(y, y)), Series.points("ragged", ragged, y),
                Series.dashed("again", uniform, y)));
        JsonNode data = data(HtmlWriter.render(new Page("p", "", List.of(new Section("s", "", chart))))).get(0);
        assertEquals(2, data.get("xs").size(), "x of two curves stand once");
        JsonNode even = data.get("xs").get(0);
        assertEquals(500, even.get("count").asInt());
        for (int i = 0; i < 500; i++) {
            assertEquals(uniform[i], even.get("from").asDouble() + i * even.get("step").asDouble(), 1e-11);
            assertEquals(ragged[i], data.get("xs").get(1).get(i).asDouble());
            for (JsonNode values : List.of(data.get("series").get(0).get("y"), data.get("series").get(0).get("band").get("upper"),
                    data.get("series").get(2).get("y"))) {
                assertEquals(Double.isNaN(y[i]), values.get(i).isNull());
                assertTrue(Double.isNaN(y[i]) || (float) y[i] == (float) values.get(i).asDouble());
            }
        }
    }

    @Test
    void heatmapLevelsAreTheValuesBetweenTheEndsOfTheColours() {
        double[][] values = {{-60, -40, Double.NaN}, {-20, 0, 100}};
        Heatmap map = new Heatmap("m", ChartAxis.linear("t", "s"), ChartAxis.linear("f", "Hz"),
                ChartAxis.linear("PSD", "dB").within(-40, 0), new double[] {0.5, 1.5}, new double[] {0, 1, 2}, values);
        JsonNode data = data(HtmlWriter.render(new Page("p", "", List.of(new Section("s", "", map))))).get(0);
        byte[] levels = Base64.getDecoder().decode(data.get("levels").asText());
        int[] expected = {0, 0, 255, 127, 254, 254};
        for (int i = 0; i < 6; i++) {
            assertEquals(expected[i], levels[i] & 0xff);
        }
    }

    @Test
    void barsKeepTheValuesToPointOut() {
        BarChart bars = new BarChart("b", ChartAxis.linear("", "m/s²"), List.of("x", "z"),
                List.of(new BarChart.Bars("day", new double[] {0.4, Double.NaN}, 0)),
                List.of(new LineChart.Marker(0.5, "action")), "");
        JsonNode data = data(HtmlWriter.render(new Page("p", "", List.of(new Section("s", "", bars))))).get(0);
        assertEquals(0.5, data.get("markers").get(0).get(0).asDouble());
        assertEquals("action", data.get("markers").get(0).get(1).asText());
        assertTrue(data.get("bars").get(0).get("values").get(1).isNull());
    }

    @Test
    void onlyASheetIsPrintedAsOne() {
        List<Section> sections = List.of(new Section("s", "", new Text("words")), new Section("t", "", new Text("more")),
                new Section("u", "", new Text("behind")));
        assertEquals(2, count(HtmlWriter.render(new Page("p", "", sections, 2)), "class=\"printed\""));
        assertThrows(IllegalArgumentException.class, () -> new Page("p", "", sections, 4));
        assertTrue(HtmlWriter.render(new Page("p", "", sections, 1)).contains("<body class=\"sheet\">"));
        assertTrue(HtmlWriter.render(new Page("p", "", sections)).contains("<body>"));
    }

    @Test
    void shadesCoverExactlyWhatIsNotUsable() {
        LineChart chart = new LineChart("c", ChartAxis.linear("f", "Hz"), ChartAxis.linear("a", ""), List.of())
                .shadedUnless(new boolean[] {false, false, true, false, true}, new double[] {0, 1, 2, 3, 4}, "dead");
        assertEquals(List.of(new LineChart.Shade(0, 1.5, "dead"), new LineChart.Shade(2.5, 3.5, "dead")), chart.shades());
    }

    @Test
    void samePageSameBytes(@TempDir Path folder) throws IOException {
        HtmlWriter.write(DemoPage.page(), folder.resolve("a.html"));
        HtmlWriter.write(DemoPage.page(), folder.resolve("b.html"));
        assertEquals(-1, Files.mismatch(folder.resolve("a.html"), folder.resolve("b.html")));
    }

    @Test
    void wordsTablesAndFindingsNeedNoScript() {
        String words = HtmlWriter.render(hostilePage()).replaceAll("(?s)<script.*?</script>", "");
        for (String text : List.of("a paragraph", "a cell", "a finding", "an advice", "3.142", "This chart needs JavaScript.")) {
            assertTrue(words.contains(text), text);
        }
    }

    private static Page hostilePage() {
        double[] x = {1, 2};
        return new Page(HOSTILE, HOSTILE, List.of(new Section(HOSTILE, HOSTILE, new Text("a paragraph\n\n" + HOSTILE),
                new Code(HOSTILE, HOSTILE),
                new Figures(new Figure(HOSTILE, HOSTILE, HOSTILE, HOSTILE), Figure.of("π", Math.PI, "")),
                new Table(HOSTILE, List.of(Column.words(HOSTILE)), List.of(List.of(HOSTILE), List.of("a cell"))),
                new Findings(List.of(new Finding(Severity.FAULT, "a finding" + HOSTILE, "an advice" + HOSTILE)), HOSTILE),
                new Tiles(List.of(new Tiles.Tile(HOSTILE, HOSTILE, HOSTILE,
                        new Gauge(0, 1, List.of(new Gauge.Range(0, 1, "share", HOSTILE)),
                                List.of(new Gauge.Mark(0.5, HOSTILE)), List.of(new Gauge.Point(2, 0.1, 3))),
                        List.of(HOSTILE), Tiles.Tone.FAULT))),
                new Folded(HOSTILE, new Text(HOSTILE)),
                new SensorFigure(List.of(new SensorFigure.Sensor("head" + HOSTILE, HOSTILE, Tiles.Tone.WARNING, HOSTILE))),
                new LineChart(HOSTILE, ChartAxis.linear(HOSTILE, HOSTILE), ChartAxis.linear(HOSTILE, HOSTILE),
                        List.of(Series.line(HOSTILE, x, x))).grouped(HOSTILE).noted(HOSTILE),
                new Heatmap(HOSTILE, ChartAxis.linear(HOSTILE, HOSTILE), ChartAxis.linear(HOSTILE, HOSTILE),
                        ChartAxis.linear(HOSTILE, HOSTILE), x, x, new double[][] {x, x}))));
    }

    private static List<JsonNode> data(String html) {
        List<JsonNode> data = new ArrayList<>();
        Matcher scripts = Pattern.compile("(?s)<script type=\"application/json\">(.*?)</script>").matcher(html);
        while (scripts.find()) {
            try {
                data.add(new ObjectMapper().readTree(scripts.group(1)));
            } catch (IOException e) {
                throw new AssertionError(e);
            }
        }
        return data;
    }

    private static int count(String text, String part) {
        return text.split(Pattern.quote(part), -1).length - 1;
    }

    private static void assertBalanced(String html) {
        String bare = html.replaceAll("(?s)<(script|style)[^>]*>.*?</\\1>", "");
        Deque<String> open = new ArrayDeque<>();
        Matcher tags = Pattern.compile("<(/?)([a-z0-9]+)[^<>]*?(/?)>").matcher(bare);
        while (tags.find()) {
            if (!tags.group(1).isEmpty()) {
                assertEquals(open.pop(), tags.group(2));
            } else if (!Set.of("meta").contains(tags.group(2)) && tags.group(3).isEmpty()) {
                open.push(tags.group(2));
            }
        }
        assertTrue(open.isEmpty());
        assertFalse(tags.replaceAll("").replace("<!DOCTYPE html>", "").contains("<"));
    }
}

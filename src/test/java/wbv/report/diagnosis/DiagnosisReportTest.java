package wbv.report.diagnosis;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.Model;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.Interval;
import wbv.diagnosis.picture.Pictures;
import wbv.diagnosis.picture.Portrait;
import wbv.recording.Channel;
import wbv.report.page.BarChart;
import wbv.report.page.ChartAxis;
import wbv.report.page.ChartJson;
import wbv.report.page.XyChart;
import wbv.report.page.XySeries;
import wbv.result.OutputFolder;

class DiagnosisReportTest {

    private static final String HOSTILE = "</script><script>alert(1)</script>\"'&<!--";
    private static final double THIRD = 1.0 / 3;

    private static Diagnosis diagnosis(String name, Diagnosis.Verdict verdict) {
        Map<String, Interval> intervals = new LinkedHashMap<>();
        intervals.put("k3_N_per_m3", new Interval(-1.3e6, -1.1e6, Interval.Source.CURVATURE));
        intervals.put("knee_m", new Interval(6e-4, Double.POSITIVE_INFINITY, Interval.Source.PROFILE));
        Map<String, Double> values = new LinkedHashMap<>();
        values.put("k3_N_per_m3", -1.2e6 - THIRD);
        values.put("knee_m", 6.8e-4);
        Model model = new Model(name, Optional.empty(), 'z', new Model.Base("platform",
                Optional.of(Channel.parse("platform.acc.z"))),
                List.of(new Model.Body(name, 40, Optional.of(Channel.parse("sternum.acc.z")), List.of(), Optional.empty(),
                        List.of())),
                List.of(new Model.Link("platform", name, 45e3, 800, Optional.empty(), List.of(), List.of())));
        return new Diagnosis(verdict, "The link " + name + " softens", List.of(
                new Diagnosis.Located("sternum.acc.z", new double[] {4, 6.5}, new double[] {0, 120}, 0.61, 7 + THIRD)),
                List.of(new Diagnosis.Named("stiffness.softening", name, 0.97, values, intervals, 1.04, 0, Map.of("side", "extension"))),
                List.of(new Diagnosis.Named("hysteresis", name, 0.02, Map.of(), Map.of(), 5.5)), "Ask " + name,
                new Diagnosis.Fit(90, 7, 1.04, 8, 1.1, new double[] {105, 150}, List.of(proof(0, 30, 0.31, 0.012, 0.011)),
                        List.of(proof(0.4, 2, 0.05, 0.004, 0.004), proof(2, 22, 0.3, 0.0115, 0.01)),
                        Map.of("sternum.acc.z", Map.of("delay_s", 0.0012))),
                List.of(new Diagnosis.Latent("link", name, 1.3)), model, Optional.empty());
    }

    private static Diagnosis.Proof proof(double low, double high, double before, double after, double floor) {
        return new Diagnosis.Proof("sternum.acc.z", new double[] {low, high}, 0.5, new Diagnosis.Ranged(before, 0.9 * before, 1.2 * before),
                new Diagnosis.Ranged(after, after, 1.1 * after), floor, new Diagnosis.Ranged(0.98, Double.NaN, Double.NaN));
    }

    private static Pictures pictures(String name) {
        double[] x = {-1, 0, 1, 0.5};
        double[] rising = {1, 2, 3, 4};
        Portrait.Scale deflection = new Portrait.Scale("Deflection " + name, "mm", false);
        Portrait.Scale hertz = new Portrait.Scale("Frequency", "Hz", true);
        double[] none = new double[0];
        return new Pictures(true, List.of(new Pictures.View("sternum.acc.z", "m/s²",
                new Pictures.Traces(105, 0.5, new double[] {1, Double.NaN, 3, 4}, rising, rising),
                new Pictures.ResidualMap(new double[] {1, 2}, rising, new double[][] {{1, 2, 3, 4}, {5, 6, 7, Double.NaN}},
                        new double[2][4]),
                List.of(new Pictures.Transfer(name, "1", rising, rising, new double[4], new boolean[] {true, true, false, true},
                        rising,
                        rising)),
                0.4, 4000)),
                List.of(new Portrait("Force in " + name, deflection, deflection, List.of(
                        new Portrait.Trail(name, Portrait.Kind.SAMPLES, x, x, none),
                        new Portrait.Trail("mean", Portrait.Kind.MEAN, x, x, rising),
                        new Portrait.Trail("law", Portrait.Kind.LAW, x, x, none)), name),
                        new Portrait("Gain", hertz, deflection, List.of(new Portrait.Trail("as measured",
                                Portrait.Kind.MEASURED, rising, x, rising)), "")),
                List.of(new Pictures.Value(name, "stiffness_N_per_m", 45e3, 50e3, 47e3,
                        Optional.of(new Interval(0.9, 1.1, Interval.Source.CURVATURE)))));
    }

    private static Path write(Path folder, String name, Diagnosis.Verdict verdict) throws IOException {
        Map<String, String> provenance = new LinkedHashMap<>();
        provenance.put("wbv", "test");
        provenance.put("command", "wbv diagnose " + name);
        try (OutputFolder out = OutputFolder.at(folder)) {
            DiagnosisReport.write(diagnosis(name, verdict), pictures(name), provenance, out);
            out.publish();
        }
        return folder;
    }

    private static JsonNode json(Path folder) throws IOException {
        return new ObjectMapper().readTree(Files.readString(folder.resolve("diagnosis.json")));
    }

    @Test
    void jsonHoldsWhatTheFormatPromisesWithEveryDigit(@TempDir Path folder) throws IOException {
        JsonNode json = json(write(folder.resolve("out"), "seat-torso", Diagnosis.Verdict.MISSING_PHYSICS));
        assertEquals("missing-physics", json.get("verdict").asText());
        JsonNode located = json.get("located").get(0);
        assertEquals("sternum.acc.z", located.get("channel").asText());
        assertEquals(6.5, located.get("band_hz").get(1).asDouble());
        assertEquals(120, located.get("time_s").get(1).asDouble());
        assertEquals(0.61, located.get("share").asDouble());
        assertTrue(located.get("p_value").asDouble() < 1e-9);
        JsonNode missing = json.get("missing").get(0);
        assertEquals("stiffness.softening", missing.get("mechanism").asText());
        assertEquals("seat-torso", missing.get("where").asText());
        assertEquals(0.97, missing.get("probability").asDouble());
        assertEquals("extension", missing.get("form").get("side").asText());
        assertTrue(json.get("alternatives").get(0).get("form").isEmpty());
        assertEquals(-1.2e6 - THIRD, missing.get("parameters").get("k3_N_per_m3").asDouble());
        assertEquals(1e5 / 1.959964, missing.get("std").get("k3_N_per_m3").asDouble(), 1e-6);
        assertTrue(missing.get("std").get("knee_m").isNull(), "what the recording does not tell is null");
        assertEquals(-1.3e6, missing.get("intervals").get("k3_N_per_m3").get("low").asDouble());
        assertEquals(-1.1e6, missing.get("intervals").get("k3_N_per_m3").get("high").asDouble());
        assertEquals("curvature", missing.get("intervals").get("k3_N_per_m3").get("from").asText());
        assertTrue(missing.get("identifiable").get("k3_N_per_m3").asBoolean());
        assertEquals(6e-4, missing.get("intervals").get("knee_m").get("low").asDouble());
        assertTrue(missing.get("intervals").get("knee_m").get("high").isNull(), "an open end is null");
        assertEquals("profile", missing.get("intervals").get("knee_m").get("from").asText());
        assertFalse(missing.get("identifiable").get("knee_m").asBoolean());
        assertEquals("hysteresis", json.get("alternatives").get(0).get("mechanism").asText());
        assertEquals("Ask seat-torso", json.get("next_experiment").asText());
        JsonNode fit = json.get("fit");
        assertEquals(105, fit.get("heldout_s").get(0).asDouble());
        assertEquals(0.31, fit.get("heldout_nrmse_before").get("sternum.acc.z").asDouble());
        assertEquals(0.012, fit.get("heldout_nrmse_after").get("sternum.acc.z").asDouble());
        assertEquals(0.011, fit.get("noise_floor_nrmse").get("sternum.acc.z").asDouble());
        assertEquals(1.1, fit.get("heldout_chi2_after").asDouble());
        assertEquals(0.0012, fit.get("sensor_errors").get("sternum.acc.z").get("delay_s").asDouble());
        assertEquals(0.4, fit.get("heldout_nrmse_given").get("sternum.acc.z").asDouble());
    }

    @Test
    void everyVerdictIsAWordWithHyphens(@TempDir Path folder) throws IOException {
        List<String> words = List.of("missing-physics", "parameters-only", "nothing-missing", "unexplained", "learned-law", "ambiguous",
                "cannot-tell");
        for (Diagnosis.Verdict verdict : Diagnosis.Verdict.values()) {
            assertEquals(words.get(verdict.ordinal()), json(write(folder.resolve(verdict.word()), "a", verdict)).get("verdict")
                    .asText());
        }
    }

    @Test
    void hostileNamesStayText(@TempDir Path folder) throws IOException {
        Path out = write(folder.resolve("out"), HOSTILE, Diagnosis.Verdict.AMBIGUOUS);
        String html = Files.readString(out.resolve("report.html"));
        assertFalse(html.contains("<script>alert"));
        assertFalse(html.contains("<!--"));
        assertEquals(HOSTILE, json(out).get("missing").get(0).get("where").asText());
    }

    @Test
    void sameDiagnosisSameBytes(@TempDir Path folder) throws IOException {
        Path a = write(folder.resolve("a"), "seat-torso", Diagnosis.Verdict.MISSING_PHYSICS);
        Path b = write(folder.resolve("b"), "seat-torso", Diagnosis.Verdict.MISSING_PHYSICS);
        for (String file : List.of("report.html", "diagnosis.json")) {
            assertEquals(-1, Files.mismatch(a.resolve(file), b.resolve(file)), file);
        }
    }

    @Test
    void pageSaysTheSentenceTheIntervalAndWhatIsNotIdentifiable(@TempDir Path folder) throws IOException {
        String html = Files.readString(write(folder.resolve("out"), "seat-torso", Diagnosis.Verdict.MISSING_PHYSICS)
                .resolve("report.html"));
        assertTrue(html.contains("<p class=\"lead\">The link seat-torso softens</p>"));
        assertTrue(html.contains("not identifiable, at least 0.6"));
        assertTrue(html.contains("−1300000 to −1100000"));
        assertTrue(html.contains(">side</td>") && html.contains(">extension</td>"), "what no number tells");
        assertTrue(html.contains("Ask seat-torso"));
        assertTrue(html.contains(">45</td>"), "45 kN/m as given");
        assertTrue(html.contains("delay [ms]") && html.contains(">1.2</td>"), "the sensor's small error");
        assertTrue(html.contains(">99.33 %</td>"), "of 7 - 1, 1.04 - 1 is left");
        assertTrue(html.contains(">98.6 %<"), "held out, of 8 - 1, 1.1 - 1 is left");
    }

    @Test
    void pointsInThePlaneAndBarsReadBackEqual() throws IOException {
        double[] x = {3, 1, Double.NaN, 2};
        double[] y = {0.125, -7, 1e9, Double.NaN};
        XyChart plane = new XyChart("p", ChartAxis.linear("r", "mm"), ChartAxis.linear("F", "N"), List.of(
                new XySeries("cloud", x, y, XySeries.Style.CLOUD), new XySeries("mean", x, y, new double[] {1, 2, 3, 4},
                        XySeries.Style.POINTS, 5)));
        BarChart bars = new BarChart("b", ChartAxis.linear("e", "%"), List.of("one", "two"),
                List.of(new BarChart.Bars("before", new double[] {31, Double.NaN}, 1)), "");
        JsonNode first = new ObjectMapper().readTree(ChartJson.of(plane));
        assertEquals("xy", first.get("kind").asText());
        for (JsonNode series : first.get("series")) {
            assertArrayEquals(x, read(series.get("x")));
            assertArrayEquals(y, read(series.get("y")));
        }
        assertEquals("cloud", first.get("series").get(0).get("style").asText());
        assertEquals(-1, first.get("series").get(0).get("colour").asInt());
        assertEquals(5, first.get("series").get(1).get("colour").asInt());
        assertArrayEquals(new double[] {1, 2, 3, 4}, read(first.get("series").get(1).get("whisker")));
        JsonNode second = new ObjectMapper().readTree(ChartJson.of(bars));
        assertEquals("two", second.get("groups").get(1).asText());
        assertArrayEquals(new double[] {31, Double.NaN}, read(second.get("bars").get(0).get("values")));
    }

    private static double[] read(JsonNode values) {
        double[] out = new double[values.size()];
        for (int i = 0; i < out.length; i++) {
            out[i] = values.get(i).isNull() ? Double.NaN : values.get(i).asDouble();
        }
        return out;
    }
}

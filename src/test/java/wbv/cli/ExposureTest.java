package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ExposureTest {

    private static final String RIDE = "data/arff/ride-subject1.arff";

    @TempDir
    private Path folder;

    private JsonNode exposure(String... words) throws IOException {
        Path out = folder.resolve("out");
        String[] all = Arrays.copyOf(words, words.length + 3);
        System.arraycopy(words, 0, all, 1, words.length);
        all[0] = "exposure";
        all[words.length + 1] = "--out";
        all[words.length + 2] = out.toString();
        Run run = Run.of(all);
        assertEquals(0, run.code(), run.err());
        return new ObjectMapper().readTree(out.resolve("exposure.json").toFile());
    }

    private static double number(JsonNode node, String... path) {
        JsonNode at = node;
        for (String name : path) {
            at = at.get(name);
        }
        return at.asDouble();
    }

    private static boolean remarked(JsonNode results, String severity, String words) {
        for (JsonNode remark : results.get("remarks")) {
            if (remark.get("severity").asText().equals(severity) && remark.get("message").asText().contains(words)) {
                return true;
            }
        }
        return false;
    }

    /** Writes a recording of seat.acc x, y, z. */
    private Path seat(String name, double rate, double seconds, IntToDoubleFunction x, IntToDoubleFunction y,
            IntToDoubleFunction z)
            throws IOException {
        StringBuilder rows = new StringBuilder("t,seat.acc.x,seat.acc.y,seat.acc.z\n");
        for (int i = 0; i < seconds * rate; i++) {
            rows.append(String.format(Locale.ROOT, "%.6f,%.6f,%.6f,%.6f%n", i / rate, x.applyAsDouble(i), y.applyAsDouble(i),
                    z.applyAsDouble(i)));
        }
        return Files.writeString(folder.resolve(name), rows);
    }

    /** Sines of known weighted level: at 10 Hz Wk is 0.9884 and Wd 0.2017 (formula at 10 Hz). */
    private Path sines(String name, double rate, double seconds, double amplitude) throws IOException {
        return seat(name, rate, seconds, i -> 0.5 * Math.sin(2 * Math.PI * 10 * i / rate),
                i -> 0.2 * Math.cos(2 * Math.PI * 10 * i / rate),
                i -> amplitude * Math.sin(2 * Math.PI * 10 * i / rate));
    }

    @Test
    void sinesGiveTheDayThatTheyMust() throws IOException {
        JsonNode results = exposure(sines("a.csv", 250, 60, 1).toString(), "--task", "shaking=120");
        double z = 0.9884 / Math.sqrt(2);
        double x = 1.4 * 0.5 * 0.2017 / Math.sqrt(2);
        assertEquals(z / 2, number(results, "day", "a8_m_s2"), 2e-3 * z);
        assertEquals("z", results.get("day").get("a8_axis").asText());
        assertEquals(x / 2, number(results, "day", "axes", "x", "a8_m_s2"), 3e-3 * x);
        assertEquals(400 * z * z / 4, number(results, "day", "points"), 0.5);
        assertEquals("below the action value", results.get("day").get("verdict").asText());
        assertEquals("below the caution zone", results.get("day").get("caution_zone").asText());
        assertEquals(480 * 0.25 / (z * z), number(results, "day", "minutes_until_action_a8"), 1);
        // VDV of a sine: (3/8)^¼ A T^¼
        double dose = 0.9884 * Math.pow(0.375 * 7200, 0.25);
        assertEquals(dose, number(results, "day", "vdv_m_s1_75"), 3e-3 * dose);
        assertEquals(1.4 * z * Math.pow(7200, 0.25), number(results, "day", "axes", "z", "estimated_vdv_m_s1_75"), 0.02);
        JsonNode axis = results.get("tasks").get(0).get("axes").get("z");
        assertEquals(z, axis.get("a_w_m_s2").asDouble(), 2e-3 * z);
        assertEquals(0.707, bandOf(axis, 10, "measured_m_s2"), 0.005);
        assertEquals(z, bandOf(axis, 10, "weighted_m_s2"), 0.005);
        assertFalse(axis.get("lower_bound").asBoolean());
        double total = Math.sqrt(z * z + Math.pow(x / 1.4, 2) + Math.pow(0.2 * 0.2017, 2) / 2);
        assertEquals(total, number(results.get("tasks").get(0), "comfort", "total_m_s2"), 3e-3);
        assertEquals("fairly uncomfortable", results.get("tasks").get(0).get("comfort").get("reaction").asText());
    }

    private static double bandOf(JsonNode axis, double nominal, String what) {
        JsonNode bands = axis.get("third_octaves");
        for (int i = 0; i < bands.get("nominal_hz").size(); i++) {
            if (bands.get("nominal_hz").get(i).asDouble() == nominal) {
                return bands.get(what).get(i).asDouble();
            }
        }
        throw new AssertionError("no band of " + nominal + " Hz");
    }

    /** The seat shakes twice as much as the platform: SEAT 2 by r.m.s. and by dose. */
    @Test
    void theSeatIsComparedWithWhatIsBelow() throws IOException {
        StringBuilder rows = new StringBuilder("t,platform.acc.z,seat.acc.z\n");
        Random random = new Random(1);
        for (int i = 0; i < 6000; i++) {
            double value = random.nextGaussian();
            rows.append(i / 100.0).append(',').append(value).append(',').append(2 * value).append('\n');
        }
        JsonNode results = exposure(Files.writeString(folder.resolve("two.csv"), rows).toString(), "--task", "ride=60");
        JsonNode axis = results.get("tasks").get(0).get("axes").get("z");
        assertEquals(2, axis.get("seat_rms").asDouble(), 1e-9);
        assertEquals(2, axis.get("seat_vdv").asDouble(), 1e-9);
        assertTrue(remarked(results, "WARNING", "seat was not measured along x"));
    }

    @Test
    void tasksOfSeveralRecordingsMakeADay() throws IOException {
        Path rough = sines("rough.csv", 100, 60, 1);
        Path smooth = sines("smooth.csv", 100, 60, 0.4);
        Files.writeString(folder.resolve("rough.json"), "{\"task\": \"rough, loaded\", \"daily_minutes\": 60}");
        Files.writeString(folder.resolve("smooth.json"),
                "{\"task\": \"smooth\", \"daily_minutes\": 240, \"notes\": {\"machine\": \"dumper 7\"}}");
        JsonNode results = exposure(rough.toString(), smooth.toString());
        double z = 0.9884 / Math.sqrt(2);
        assertEquals(Math.sqrt(z * z / 8 + 0.16 * z * z / 2), number(results, "day", "a8_m_s2"), 2e-3 * z);
        assertEquals(300, number(results, "day", "minutes"));
        assertEquals("rough, loaded", results.get("tasks").get(0).get("name").asText());
        List<String> table = Files.readAllLines(folder.resolve("out/exposure.csv")).stream()
                .filter(line -> !line.startsWith("#")).toList();
        assertEquals(1 + 6 + 3, table.size());
        assertTrue(table.get(1).startsWith("\"rough, loaded\",60.0,x,Wd,1.4,"), table.get(1));
        assertEquals(number(results, "day", "a8_m_s2"), Double.parseDouble(table.get(9).split(",", -1)[12]));
        assertTrue(Files.readString(folder.resolve("out/report.html")).contains("dumper 7"));
    }

    /** A sheet has room for a few tasks with all axes; of more it shows the worst axis, and the others behind it. */
    @Test
    void manyTasksLeaveTheSheetLegible() throws IOException {
        String file = sines("a.csv", 100, 10, 1).toString();
        List<String> words = new ArrayList<>();
        for (int i = 1; i <= 7; i++) {
            words.add(file);
        }
        for (int i = 1; i <= 7; i++) {
            words.addAll(List.of("--task", "road " + i + "=" + 10 * i));
        }
        JsonNode results = exposure(words.toArray(String[]::new));
        assertEquals(7, results.get("tasks").size());
        String html = Files.readString(folder.resolve("out/report.html"));
        String sheet = html.substring(html.indexOf("<section"), html.indexOf("</section>"));
        String behind = html.substring(html.indexOf("</section>"));
        String every = behind.substring(behind.indexOf("<section"), behind.indexOf("</section>", 1));
        assertTrue(every.startsWith("<section id=\"section-2\" class=\"printed\">"), every);
        assertEquals(7, sheet.split(", W[dk]</td>").length - 1);
        assertEquals(21, every.split(", W[dk]</td>").length - 1);
        assertTrue(sheet.contains("\"2 more\"") && sheet.contains("\"road 7\""));
        assertFalse(sheet.contains("\"road 2\""), "the lightest tasks are not named in charts");
        assertTrue(sheet.contains("m/s¹·⁷⁵") && !html.contains("m/s^1"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"ride-subject1", "one-dof-linear", "one-dof-step", "two-dof", "sweep-chapter4"})
    void shippedRecordingsGiveAReport(String name) throws IOException {
        JsonNode results = exposure("data/arff/" + name + ".arff", "--task", "ride=60");
        assertTrue(number(results, "day", "a8_m_s2") > 0);
        String html = Files.readString(folder.resolve("out/report.html"));
        assertTrue(html.contains("<body class=\"sheet\">") && html.contains("not ISO 8041-1 conformant above 23.4 Hz"));
        assertFalse(html.contains(">NaN") || html.contains("Infinity<"));
    }

    @Test
    void theSameCommandGivesTheSameBytes() throws IOException {
        for (String name : List.of("a", "b")) {
            assertEquals(0, Run.of("exposure", RIDE, "--task", "ride=60", "--out", folder.resolve(name).toString()).code());
        }
        for (String file : List.of("report.html", "exposure.json", "exposure.csv")) {
            assertArrayEquals(Files.readAllBytes(folder.resolve("a").resolve(file)),
                    Files.readAllBytes(folder.resolve("b").resolve(file)), file);
        }
    }

    /**
     * A car's front axle on a dirt road, measured by others. Expected values were computed with SciPy from the file itself:
     * spline
     * through the rows that are not all zero, weighting by one transform of twice the length.
     */
    @Test
    void aRealAxleReadsAsWithScipy() throws IOException {
        Path file = Path.of("../shared/real/wobble/wobble_20211027T145614.csv.gz");
        Assumptions.assumeTrue(Files.exists(file), "skipped: there is no " + file);
        JsonNode results = exposure(file.toString(), "--map", "data/maps/wobble.json", "--seat", "axle_pass", "--task",
                "road=60");
        double[][] expected = {{0.70374, 3.4335, 2.5577}, {0.70646, 3.5798, 2.2862}, {3.23278, 23.0215, 14.5997}};
        for (int i = 0; i < 3; i++) {
            JsonNode axis = results.get("tasks").get(0).get("axes").get(String.valueOf("xyz".charAt(i)));
            assertEquals(expected[i][0], axis.get("a_w_m_s2").asDouble(), 2e-3 * expected[i][0]);
            assertEquals(expected[i][1], axis.get("vdv_measured_m_s1_75").asDouble(), 2e-3 * expected[i][1]);
            assertEquals(expected[i][2], axis.get("mtvv_m_s2").asDouble(), 2e-3 * expected[i][2]);
        }
        assertTrue(remarked(results, "WARNING", "not on the seat"));
        assertTrue(remarked(results, "WARNING", "exactly zero in 2 rows"));
        assertTrue(remarked(results, "NOTE", "gravity was left in"));
    }

    private void refused(String said, String... words) {
        String[] all = new String[words.length + 3];
        all[0] = "exposure";
        System.arraycopy(words, 0, all, 1, words.length);
        all[words.length + 1] = "--out";
        all[words.length + 2] = folder.resolve("nothing").toString();
        Run run = Run.of(all);
        assertEquals(1, run.code(), run.err());
        assertTrue(run.err().contains(said), run.err());
        assertEquals(1, run.err().lines().count(), run.err());
        assertTrue(Files.notExists(folder.resolve("nothing")));
    }

    @Test
    void badDataAreRefusedInOneLine() throws IOException {
        refused("sampled at 20 Hz", sines("slow.csv", 20, 60, 1).toString());
        refused("lasts 0.5 s", sines("short.csv", 100, 0.5, 1).toString());
        refused("1500 minutes; a day has 1440", sines("a.csv", 100, 10, 1).toString(), sines("b.csv", 100, 10, 1).toString(),
                "--task", "a=800", "--task", "b=700");
        refused("how many minutes a day", folder.resolve("a.csv").toString(), folder.resolve("b.csv").toString());
        Path elsewhere = Files.writeString(folder.resolve("head.csv"), Files.readString(folder.resolve("a.csv")).replace("seat.",
                "head."));
        refused("name the place with --seat", elsewhere.toString());
        refused("has no acceleration of saddle", folder.resolve("a.csv").toString(), "--seat", "saddle");
        Path gs = seat("g.csv", 100, 20, i -> 0, i -> 0, i -> 1 + 0.05 * Math.sin(i / 3.0));
        refused("g read as m/s²", gs.toString());
    }

    @Test
    void doubtfulDataAreFlagged() throws IOException {
        Path flat = seat("flat.csv", 100, 60, i -> Math.sin(i / 3.0), i -> Math.cos(i / 3.0), i -> 0);
        assertTrue(remarked(exposure(flat.toString(), "--task", "a=60"), "FAULT", "seat was not measured along z"));
        String said = Run.of("exposure", flat.toString(), "--task", "a=60", "--out", folder.resolve("said").toString()).out();
        assertTrue(said.contains("below the action value. Not measured along z: the whole may be higher."), said);
        Random random = new Random(3);
        Path clipped = seat("clipped.csv", 100, 60, i -> random.nextGaussian(), i -> random.nextGaussian(),
                i -> Math.max(-1.5, Math.min(1.5, 4 * Math.sin(i / 5.0) + random.nextGaussian())));
        assertTrue(remarked(exposure(clipped.toString(), "--task", "a=60"), "WARNING",
                "seat.acc.z stays at its extreme value 1.5"));
        List<String> rows = Files.readAllLines(clipped);
        rows.removeIf(row -> random.nextDouble() < 0.2);
        rows.set(0, "t,seat.acc.x,seat.acc.y,seat.acc.z");
        Path lossy = Files.write(folder.resolve("lossy.csv"), rows);
        assertTrue(remarked(exposure(lossy.toString(), "--task", "a=60"), "WARNING", "% of the samples of seat are missing"));
        Path gravity = seat("gravity.csv", 100, 60, i -> Math.sin(i / 3.0), i -> Math.cos(i / 3.0), i -> 9.81
                + Math.sin(i / 3.0));
        Path free = seat("free.csv", 100, 60, i -> Math.sin(i / 3.0), i -> Math.cos(i / 3.0), i -> Math.sin(i / 3.0));
        JsonNode with = exposure(gravity.toString(), "--task", "a=60");
        double level = number(with, "day", "a8_m_s2");
        assertTrue(remarked(with, "NOTE", "gravity was left in"));
        assertEquals(number(exposure(free.toString(), "--task", "a=60"), "day", "a8_m_s2"), level, 1e-6);
        assertTrue(remarked(exposure(free.toString()), "WARNING", "8 h are assumed"));
        Path jolt = seat("jolt.csv", 100, 60, i -> random.nextGaussian(), i -> random.nextGaussian(),
                i -> i > 3000 && i < 3020 ? 20 : 0.2 * random.nextGaussian());
        assertTrue(remarked(exposure(jolt.toString(), "--task", "a=60"), "WARNING", "z (crest factor"));
    }

    @Test
    void wrongUsageIsExitCodeTwo() throws IOException {
        String file = sines("a.csv", 100, 10, 1).toString();
        assertEquals(2, Run.of("exposure", file, "--task", "a").code());
        assertEquals(2, Run.of("exposure", file, "--task", "a=1441").code());
        assertEquals(2, Run.of("exposure", file, "--task", "a=60", "--task", "b=60").code());
        assertEquals(2, Run.of("exposure", file, "--seat", "No Place").code());
        assertEquals(2, Run.of("exposure", file, "--years", "0").code());
    }

    /** Magnitudes that are typed in stand for a recording; nothing is written, and what makes no sense is told. */
    @Test
    void magnitudesStandForARecording() throws IOException {
        Run run = Run.of("exposure", "--magnitude", "x=0.3", "--magnitude", "z=0.7", "--hours", "4", "--json");
        assertEquals(0, run.code(), run.err());
        JsonNode json = new ObjectMapper().readTree(run.out());
        assertEquals(0.7 * Math.sqrt(0.5), json.get("a8").asDouble(), 1e-12);
        assertEquals(98, json.get("points").asDouble(), 1e-9);
        assertEquals(1.4 * 0.3 * Math.sqrt(0.5), json.get("a8ByAxis").get("x").asDouble(), 1e-12);
        for (String[] wrong : new String[][] {{"--magnitude", "0.7", "--hours", "4"}, {"--magnitude", "z=0.7"}, {"--hours", "4"},
            {"--magnitude", "z=0.7,z=1",
                "--hours", "4"},
            {"--magnitude", "z=0.7", "--hours", "25"}, {"--magnitude", "z=7000", "--hours", "4"},
            {"--magnitude", "z=0.7", "--hours", "4", "--hours", "1"},
            {"--magnitude", "z=0.7", "--hours", "4", RIDE}, {}}) {
            List<String> words = new ArrayList<>(List.of("exposure"));
            words.addAll(List.of(wrong));
            Run refused = Run.of(words.toArray(String[]::new));
            assertEquals(2, refused.code(), words.toString());
            assertTrue(refused.err().startsWith("wbv: ") && refused.out().isEmpty(), refused.err());
        }
    }
}

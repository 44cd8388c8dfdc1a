package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.exposure.SeatAxis;
import wbv.exposure.SeatMeasurement;
import wbv.exposure.SeatMeter;
import wbv.recording.format.RecordingFile;

/** The main report: that of the ride that ships, with ten sensors of which each lost about one packet in a hundred. */
class AnalyzeReportTest {

    private static final Path RIDE = Path.of("data/arff/ride-subject1.arff");

    @TempDir
    private static Path folder;

    private static Run ride;
    private static String html;

    @BeforeAll
    static void analyze() throws IOException {
        ride = Run.of("analyze", RIDE.toString(), "--out", folder.resolve("ride").toString());
        assertEquals(0, ride.code(), ride.err());
        html = Files.readString(folder.resolve("ride/report.html"));
    }

    private static List<String> all(String pattern, String text) {
        List<String> found = new ArrayList<>();
        Matcher matcher = Pattern.compile(pattern, Pattern.DOTALL).matcher(text);
        while (matcher.find()) {
            found.add(matcher.group(1));
        }
        return found;
    }

    @Test
    void itOpensWithASentenceTilesAndAPicture() {
        assertEquals(List.of("Exposure", "Transmissibility", "Equivalent body", "Motion states", "Data"), all("<h3>(.*?)</h3>", html));
        String lead = all("<p class=\"lead\">(.*?)</p>", html).get(0);
        assertTrue(lead.contains("150\u00a0s of simulated seated vibration") && lead.contains("above the action value")
                && lead.contains("the head moves"), lead);
        assertTrue(html.indexOf("class=\"lead\"") < html.indexOf("class=\"tiles\""));
        assertTrue(html.indexOf("class=\"tiles\"") < html.indexOf("class=\"chart\""));
        assertFalse(html.substring(html.indexOf("<main>"), html.indexOf("class=\"chart\"")).contains("<table>"),
                "a table before the first chart");
        assertEquals(List.of("At a glance", "Transmissibility", "Spectra", "Body over time", "Signals and motion states", "Spectrograms",
                "Sensors", "Details"), all("<h2>(.*?)</h2>", html));
    }

    @Test
    void notesAreFoldedOnThePageAndOnTheTerminal() {
        assertEquals(1, ride.out().split("NOTE:", -1).length - 1, ride.out());
        assertTrue(Pattern.compile("NOTE: 10 sensors lack 0\\.63 to 1\\.6 % of their samples").matcher(ride.out()).find(), ride.out());
        assertTrue(ride.out().indexOf("above the action value") < ride.out().indexOf("NOTE:"), "the finding comes first");
        String open = html.replaceAll("(?s)<details>.*?</details>", "");
        assertEquals(0, all("(channels of \\w+ lack)", open).size());
        assertEquals(10, all("(channels of \\w+ lack)", html).size(), "one by one where they are folded");
        assertFalse(open.contains("RMS about mean"), "the table of channels is folded");
    }

    /** The tile's numbers are those that 'wbv exposure' has. */
    @Test
    void exposureIsThatOfTheCommandForIt() throws IOException {
        SeatMeasurement measured = SeatMeter.measure(new RecordingFile(RIDE),
                new SeatMeter.Setup(Optional.empty(), Optional.empty(), false), share -> {});
        JsonNode exposure = new ObjectMapper().readTree(folder.resolve("ride/results.json").toFile()).get("exposure");
        for (SeatAxis axis : SeatAxis.values()) {
            String letter = String.valueOf(axis.letter());
            assertEquals(measured.axes().get(axis).rms(), exposure.get("a_w_m_s2").get(letter).asDouble(), 0);
            assertEquals(measured.axes().get(axis).vdv(), exposure.get("vdv_m_s175").get(letter).asDouble(), 0);
        }
        assertEquals("seat", exposure.get("place").asText());
        assertEquals(480 * Math.pow(0.5 / exposure.get("a8_m_s2").asDouble(), 2), exposure.get("minutes_to_action_value").asDouble(), 0.1);
        assertEquals(measured.task("", 480).minutesUntilVdv(wbv.exposure.Directive.ACTION),
                exposure.get("minutes_to_action_value_by_dose").asDouble(), 0);
        assertTrue(exposure.get("lower_bound").asBoolean() && html.contains("A lower bound: 23.4"));
    }

    @Test
    void lostPacketsTearNoSpectrogram() throws IOException {
        int maps = 0;
        for (String data : all("<script type=\"application/json\">(.*?)</script>", html)) {
            JsonNode chart = new ObjectMapper().readTree(data);
            if (chart.get("kind").asText().equals("heatmap")) {
                maps++;
                for (byte level : Base64.getDecoder().decode(chart.get("levels").asText())) {
                    assertFalse(level == (byte) 255, "a hole in " + chart.get("title"));
                }
            }
        }
        assertEquals(2, maps);
    }

    @Test
    void powersOfTenAreRaisedAndNoHeaderIsEmpty() {
        String words = html.replaceAll("(?s)<(script|style).*?</\\1>", "");
        assertFalse(words.contains("10^"));
        assertTrue(words.contains("10⁻"), "the mean of an angular rate is small");
        assertFalse(words.contains("<th></th>"));
    }

    @Test
    void thePageStaysSmall() throws IOException {
        assertTrue(html.length() < 1_000_000, html.length() + " letters");
    }

    /** Five seconds are lost in a row: that stays to be seen. A second is too much for a bridge too. */
    @Test
    void whatIsLostForLongIsMarked() throws IOException {
        StringBuilder rows = new StringBuilder("t,platform.acc.z,head.acc.z\n");
        for (int i = 0; i < 3600; i++) {
            boolean lost = i >= 1200 && i < 1500;
            rows.append(i / 60.0).append(',').append(lost ? "" : Math.sin(0.3 * i + 0.0001 * i * i)).append(',')
                    .append(Math.sin(0.3 * i + 0.0001 * i * i - 0.2)).append('\n');
        }
        Path file = Files.writeString(folder.resolve("lost.csv"), rows);
        assertEquals(0, Run.of("analyze", file.toString(), "--out", folder.resolve("lost").toString()).code());
        String page = Files.readString(folder.resolve("lost/report.html"));
        JsonNode map = new ObjectMapper().readTree(all("<script type=\"application/json\">(.*?)</script>", page).stream()
                .filter(data -> data.contains("\"heatmap\"")).findFirst().orElseThrow());
        byte[] levels = Base64.getDecoder().decode(map.get("levels").asText());
        int holes = 0;
        for (byte level : levels) {
            holes += level == (byte) 255 ? 1 : 0;
        }
        assertTrue(holes > 0 && holes < levels.length, holes + " of " + levels.length);
        assertFalse(page.contains("<h3>Motion states</h3>"), "states are told from four channels");
    }

    /** Nothing that sits: no exposure, no states, no published range. */
    @Test
    void ofACarsAxleItSaysNothingOfPeople() throws IOException {
        StringBuilder rows = new StringBuilder("t,axle.acc.z,knuckle.acc.z\n");
        java.util.Random random = new java.util.Random(1);
        double y = 0;
        for (int i = 0; i < 6000; i++) {
            double u = random.nextGaussian();
            y = 0.6 * y + u;
            rows.append(i / 100.0).append(',').append(u).append(',').append(y).append('\n');
        }
        Path file = Files.writeString(folder.resolve("axle.csv"), rows);
        Run run = Run.of("analyze", file.toString(), "--input", "axle.acc.z", "--out", folder.resolve("axle").toString());
        assertEquals(0, run.code(), run.err());
        String page = Files.readString(folder.resolve("axle/report.html"));
        assertEquals(List.of("Transmissibility", "Equivalent body", "Data"), all("<h3>(.*?)</h3>", page));
        assertTrue(run.out().contains("60 s of vibration at 100 Hz: the knuckle moves"), run.out());
        assertFalse(page.contains("published models of seated people"));
        assertTrue(new ObjectMapper().readTree(folder.resolve("axle/results.json").toFile()).get("exposure").isNull());
    }
}

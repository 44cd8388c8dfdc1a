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
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class FrfTest {

    private static final String ONE = "data/arff/one-dof-linear.arff";
    private static final String TWO = "data/arff/two-dof.arff";
    private static final String RIDE = "data/arff/ride-subject1.arff";
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    private JsonNode frf(String... words) throws IOException {
        List<String> all = new ArrayList<>(List.of("frf"));
        all.addAll(List.of(words));
        all.addAll(List.of("--out", folder.resolve("out").toString()));
        Run run = Run.of(all.toArray(String[]::new));
        assertEquals(0, run.code(), run.err());
        return JSON.readTree(folder.resolve("out").resolve("frf.json").toFile());
    }

    /** The rig's two masses are Allen's: the published model lies on what is measured. */
    @Test
    void aModelLiesOnTheBodyThatItDescribes() throws IOException {
        JsonNode head = frf(TWO, "--output", "head.acc.z", "--model", "allen-1978-2dof").get("responses").get(0);
        assertTrue(head.get("misfit").get("relative").asDouble() < 0.015, head.get("misfit").toString());
        assertEquals(1.47, head.get("peak").get("modulus").asDouble(), 0.02);
        assertFalse(head.get("peak").get("at_end").asBoolean());
        String html = Files.readString(folder.resolve("out/report.html"));
        assertTrue(html.contains("\"model\"") && html.contains("\"Hv\"") && html.contains("95 %"));
        assertFalse(html.contains("src=\"http") || html.contains("href=\"http"));
    }

    @Test
    void csvHoldsWhatJsonHolds() throws IOException {
        JsonNode head = frf(ONE).get("responses").get(0);
        List<String> lines = Files.readAllLines(folder.resolve("out/frf.csv")).stream().filter(line -> !line.startsWith("#"))
                .toList();
        List<String> names = List.of(lines.get(0).split(","));
        int bins = head.get("h1").get("modulus").size();
        assertEquals(bins, lines.size() - 1);
        for (int k : new int[] {5, 20, 100}) {
            String[] cells = lines.get(1 + k).split(",", -1);
            assertEquals(head.get("h1").get("modulus").get(k).asDouble(), Double.parseDouble(cells[names.indexOf("h1")]));
            assertEquals(head.get("multiple_coherence").get(k).asDouble(),
                    Double.parseDouble(cells[names.indexOf("multiple_coherence")]));
            assertEquals(head.get("h1").get("modulus").get(k).asDouble() + head.get("margin").get(k).asDouble(),
                    Double.parseDouble(cells[names.indexOf("h1_high")]), 1e-12);
            assertEquals(head.get("usable").get(k).asBoolean() ? "1" : "0", cells[names.indexOf("usable")]);
        }
    }

    /** Three axes at once: nine answers, of which those between the sagittal plane and the sides vanish. */
    @Test
    void theCrossAxisMatrixOfAPerson() throws IOException {
        JsonNode results = frf(RIDE, "--input", "platform.acc.x,platform.acc.y,platform.acc.z", "--output",
                "head.acc.x,head.acc.y,head.acc.z");
        assertEquals(9, results.get("responses").size());
        assertEquals(3, results.get("among").size());
        for (int output = 0; output < 3; output++) {
            double[] partial = new double[3];
            for (int input = 0; input < 3; input++) {
                JsonNode response = results.get("responses").get(3 * output + input);
                for (int k = 24; k < 34; k++) {   // 5.6 to 7.7 Hz, where the platform moves most
                    partial[input] += response.get("partial_coherence").get(k).asDouble() / 10;
                }
                assertTrue(response.get("h2").isObject());
            }
            // The rig's people are the same on the left as on the right: what moves them sideways leaves the rest be. The
            // platform's pitch, which is no input here, takes its share of fore and aft.
            boolean sideways = output == 1;
            assertTrue(sideways ? partial[1] > 0.6 && partial[0] < 0.2 && partial[2] < 0.2 : partial[2] > 0.8 && partial[1] < 0.2,
                    output + ": " + List.of(partial[0], partial[1], partial[2]));
        }
        assertTrue(Files.readString(folder.resolve("out/report.html")).contains("Cross-axis matrix"));
    }

    /** A sitter of 10 kg on a plate of 2 kg: the force is known from the motion. */
    @Test
    void apparentMassComesFromForce() throws IOException {
        List<String> rows = new ArrayList<>();
        try (Stream<String> lines = Files.lines(Path.of(ONE))) {
            lines.dropWhile(line -> !line.startsWith("@data")).skip(1).filter(line -> !line.isBlank()).forEach(line -> {
                String[] cells = line.split(",");
                double base = Double.parseDouble(cells[1]);
                rows.add(cells[0] + "," + cells[1] + "," + (10 * Double.parseDouble(cells[2]) + 2 * base));
            });
        }
        Path file = Files.writeString(folder.resolve("shaker.csv"), "t,seat.acc.z,seat.force.z\n" + String.join("\n", rows)
                + "\n");
        JsonNode response = frf(file.toString(), "--plate", "2").get("responses").get(0);
        assertEquals("kg", response.get("unit").asText());
        // |T| = 1.009 at the bin of 0.47 Hz (closed form), where the platform's band begins.
        assertEquals(10.09, response.get("driving_point").get("sitting_mass_kg").asDouble(), 0.15);
        assertEquals(17.97, response.get("peak").get("modulus").asDouble(), 0.3);   // ζ = 0.35: 1.797 (closed form)
        assertTrue(response.get("driving_point").get("absorbed_power_w").asDouble() > 0);
        assertTrue(Files.readString(folder.resolve("out/report.html")).contains("Absorbed power"));
    }

    @Test
    void theMeanOfPeopleKeepsTheirPeaks() throws IOException {
        List<String> files = new ArrayList<>();
        for (String f0 : List.of("4", "5", "6")) {
            files.add(folder.resolve("person" + f0 + ".csv").toString());
            assertEquals(0, Run.of("simulate", "sitter=one-dof", "zeta=0.25", "f0=" + f0, "seconds=120", "seed=3", "--out",
                    files.get(files.size() - 1)).code());
        }
        JsonNode people = frf(files.get(0), "--also", files.get(1), "--also", files.get(2)).get("responses").get(0).get("people");
        assertEquals(3, people.get("averaged").asInt());
        assertEquals(5 * 0.9481, people.get("peak_hz").asDouble(), 0.1);     // ζ = 0.25: 2.2832 at 0.9481 f0 (closed form)
        assertEquals(2.2832, people.get("peak").asDouble(), 0.06);
        double plain = 0;
        for (JsonNode value : people.get("plain_mean")) {
            plain = Math.max(plain, value.asDouble());
        }
        assertTrue(plain < 0.9 * 2.2832, "the plain mean smears: " + plain);
    }

    /** The spring becomes stiffer by a quarter after a minute: the peak rises by √1.25. */
    @Test
    void theResponseIsFollowedThroughTime() throws IOException {
        frf("data/arff/one-dof-step.arff", "--wavelet");
        String page = Files.readString(folder.resolve("out/report.html"));
        assertTrue(page.contains("<h2>Through time</h2>"));
        List<String> lines = Files.readAllLines(folder.resolve("out/wavelet.csv"));
        String at = lines.stream().filter(line -> line.startsWith("head.acc.z,30.2,15")).findFirst().orElseThrow();
        assertEquals("", at.split(",", -1)[3], "the platform moves from 0.5 to 12 Hz");
        assertEquals(2, Run.of("frf", RIDE, "--wavelet", "--input", "platform.acc.x,platform.acc.z").code());
    }

    @Test
    void peopleAreComparedByTheNamesOfTheirChannels() throws IOException {
        String two = folder.resolve("two.csv").toString();
        assertEquals(0, Run.of("simulate", "sitter=two-dof", "seconds=120", "seed=3", "--out", two).code());
        JsonNode responses = frf(two, "--also", ONE).get("responses");
        assertEquals("sternum.acc.z", responses.get(0).get("output").asText());
        assertTrue(responses.get(0).path("people").isMissingNode() || responses.get(0).get("people").isNull(), "one has no sternum");
        assertEquals("head.acc.z", responses.get(1).get("output").asText());
        assertEquals(2, responses.get(1).get("people").get("averaged").asInt());
        Run none = Run.of("frf", two, "--output", "sternum.acc.z", "--also", ONE, "--out", folder.resolve("none").toString());
        assertEquals(1, none.code());
        assertTrue(none.err().contains("one-dof-linear.arff"), none.err());
    }

    @Test
    void skinIsTakenOut() throws IOException {
        JsonNode bare = frf(ONE).get("responses").get(0);
        JsonNode bone = frf(ONE, "--skin", "head=20:0.3").get("responses").get(0);
        int k = 43;
        double beta = bare.path("h1").get("modulus").size() > 0 ? 60.0 / 256 * k / 20 : Double.NaN;
        double factor = Math.hypot(1 - beta * beta, 0.6 * beta) / Math.hypot(1, 0.6 * beta);
        assertEquals(factor, bone.get("h1").get("modulus").get(k).asDouble() / bare.get("h1").get("modulus").get(k).asDouble(),
                1e-9);
        assertEquals(bare.get("multiple_coherence").get(k).asDouble(), bone.get("multiple_coherence").get(k).asDouble(), 1e-12);
    }

    @Test
    void aTapShowsTheSkin() throws IOException {
        StringBuilder tap = new StringBuilder("t,head.accg.x,head.accg.z\n");
        for (int n = 0; n < 500; n++) {
            double t = (n - 100) / 500.0;
            double w = 2 * Math.PI * 35;
            double rings = t < 0 ? 0 : 8 * Math.exp(-0.3 * w * t) * Math.cos(w * Math.sqrt(1 - 0.09) * t);
            tap.append(n / 500.0).append(",0.1,").append(9.81 + rings).append('\n');
        }
        Path file = Files.writeString(folder.resolve("tap.csv"), tap);
        Run run = Run.of("frf", ONE, "--skin", "head=" + file, "--out", folder.resolve("out").toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("skin under head taken out: 35.0 Hz, damping ratio 0.30"), run.out());
        Run elsewhere = Run.of("frf", ONE, "--skin", "knee=" + file, "--out", folder.resolve("other").toString());
        assertEquals(1, elsewhere.code());
        assertTrue(elsewhere.err().contains("no acceleration of knee"), elsewhere.err());
    }

    /** What a stream averages sample by sample is what the command averages; the string stands in the report. */
    @Test
    void theTaskOfTheReportGivesTheSamePeak() throws IOException {
        JsonNode head = frf(RIDE, "--input", "platform.acc.z", "--output", "head.acc.z").get("responses").get(0);
        String html = Files.readString(folder.resolve("out/report.html"));
        int at = html.indexOf("wbv.task.RespondOverTime");
        String task = html.substring(at, html.indexOf('<', at)).replace("RespondOverTime", "RespondOverTime -e 1000")
                .replace("ride-subject1.arff", RIDE).replace("data/arff/data/arff", "data/arff");
        Run run = Run.of("task", task);
        assertEquals(0, run.code(), run.err());
        String[] last = run.out().strip().lines().reduce((a, b) -> b).orElseThrow().split(",");
        assertEquals(head.get("averages").asDouble(), Double.parseDouble(last[1]), 1e-9);
        assertEquals(head.get("peak").get("modulus").asDouble(), Double.parseDouble(last[2]), 1e-9);
        assertEquals(head.get("peak").get("frequency_hz").asDouble(), Double.parseDouble(last[4]), 1e-9);
    }

    @Test
    void theSameCommandGivesTheSameBytes() throws IOException {
        for (String name : List.of("a", "b")) {
            assertEquals(0, Run.of("frf", ONE, "--model", "coermann-1962-1dof", "--out", folder.resolve(name).toString()).code());
        }
        for (String file : List.of("report.html", "frf.json", "frf.csv")) {
            assertArrayEquals(Files.readAllBytes(folder.resolve("a").resolve(file)),
                    Files.readAllBytes(folder.resolve("b").resolve(file)));
        }
    }

    @Test
    void aCarsAxleIsMeasured() throws IOException {
        Path recording = Path.of("../shared/real/wobble/wobble_20211027T145614.csv.gz");
        Assumptions.assumeTrue(Files.exists(recording), "no recordings of others here");
        JsonNode results = frf(recording.toString(), "--map", "data/maps/wobble.json", "--input",
                "axle_pass.acc.x,axle_pass.acc.y,axle_pass.acc.z", "--output",
                "knuckle_pass.acc.x,knuckle_pass.acc.y,knuckle_pass.acc.z",
                "--segment", "2");
        assertEquals(9, results.get("responses").size());
        assertTrue(results.get("recording").get("findings").toString().contains("gravity was left in"));
    }

    private static String rows(double rate, double seconds, String names, int width, Sample sample) {
        Random random = new Random(5);
        StringBuilder text = new StringBuilder("t," + names + "\n");
        double[] row = new double[width];
        for (int n = 0; n < seconds * rate; n++) {
            sample.fill(n / rate, random, row);
            text.append(String.format(Locale.ROOT, "%.6f", n / rate));
            for (double value : row) {
                text.append(',').append(value);
            }
            text.append('\n');
        }
        return text.toString();
    }

    private interface Sample {
        void fill(double time, Random random, double[] row);
    }

    private static final String TWO_NAMES = "platform.acc.z,head.acc.z";
    private static final Sample WHITE = (t, random, row) -> {
        row[0] = random.nextGaussian();
        row[1] = row[0] + 0.1 * random.nextGaussian();
    };

    static Stream<Arguments> refused() {
        return Stream.of(
                Arguments.of("half a second", rows(60, 0.5, TWO_NAMES, 2, WHITE), List.of(), "too short"),
                Arguments.of("no z axis", rows(60, 60, "platform.acc.x,head.acc.x", 2, WHITE), List.of(), "--input"),
                Arguments.of("a dead input", rows(60, 60, TWO_NAMES, 2, (t, random, row) -> row[1] = random.nextGaussian()),
                        List.of(),
                        "does not move"),
                Arguments.of("inputs that move as one", rows(60, 60, "platform.acc.z,seat.acc.z,head.acc.z", 3, (t, random, row) -> {
                    WHITE.fill(t, random, row);
                    row[2] = row[1];
                    row[1] = row[0] + 1e-3 * random.nextGaussian();
                }), List.of("--input", "platform.acc.z,seat.acc.z"), "leave one of"),
                Arguments.of("no such channel", rows(60, 60, TWO_NAMES, 2, WHITE), List.of("--output", "knee.acc.z"),
                        "no channel knee.acc.z"),
                Arguments.of("input and output the same", rows(60, 60, TWO_NAMES, 2, WHITE),
                        List.of("--output", "platform.acc.z"),
                        "both input and output"),
                Arguments.of("an input twice", rows(60, 60, TWO_NAMES, 2, WHITE),
                        List.of("--input", "platform.acc.z,platform.acc.z"),
                        "named twice"),
                Arguments.of("segments longer than all", rows(60, 60, TWO_NAMES, 2, WHITE), List.of("--segment", "100"),
                        "too short"),
                Arguments.of("a model of something else", rows(60, 60, "seat.acc.z,knee.acc.z", 2, WHITE),
                        List.of("--model", "allen-1978-2dof"), "answers none"),
                Arguments.of("no such model", rows(60, 60, TWO_NAMES, 2, WHITE), List.of("--model", "nobody-1900"),
                        "nobody-1900"),
                Arguments.of("skin elsewhere", rows(60, 60, TWO_NAMES, 2, WHITE), List.of("--skin", "knee=30:0.3"),
                        "told of knee"),
                Arguments.of("a plate under no force", rows(60, 60, TWO_NAMES, 2, WHITE), List.of("--plate", "3"),
                        "apparent mass"),
                Arguments.of("no such person", rows(60, 60, TWO_NAMES, 2, WHITE), List.of("--also", "nobody.csv"), "nobody.csv"),
                Arguments.of("holes in every segment", holes(), List.of(), "without gaps"));
    }

    private static String holes() {
        StringBuilder text = new StringBuilder("t," + TWO_NAMES + "\n");
        Random random = new Random(6);
        for (int n = 0; n < 1800; n++) {
            text.append(n / 60.0).append(',').append(random.nextGaussian()).append(',');
            text.append(n % 60 < 10 ? "" : Double.toString(random.nextGaussian())).append('\n');
        }
        return text.toString();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("refused")
    void oneLineAndNothingLeftBehind(String name, String content, List<String> options, String said) throws IOException {
        Path file = Files.writeString(folder.resolve("bad.csv"), content);
        Path out = folder.resolve("out");
        List<String> words = new ArrayList<>(List.of("frf", file.toString(), "--out", out.toString()));
        words.addAll(options);
        Run run = Run.of(words.toArray(String[]::new));
        assertEquals(1, run.code(), run.err());
        assertEquals(1, run.err().strip().lines().count(), run.err());
        assertTrue(run.err().startsWith("wbv: ") && run.err().contains(said), run.err());
        assertFalse(Files.exists(out));
        assertEquals("", run.out());
    }

    /** Gravity, clipping and a low rate do not stop a response; they are said. */
    @Test
    void whatIsWrongButUsableIsFlagged() throws IOException {
        Sample heavy = (t, random, row) -> {
            WHITE.fill(t, random, row);
            row[0] += 9.81;
            row[1] = Math.max(-1.2, Math.min(1.2, row[1]));
        };
        Path file = Files.writeString(folder.resolve("flagged.csv"), rows(20, 120, TWO_NAMES, 2, heavy));
        Run run = Run.of("frf", file.toString(), "--out", folder.resolve("out").toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("gravity") && run.out().contains("stays at its extreme"), run.out());
        JsonNode results = JSON.readTree(folder.resolve("out/frf.json").toFile());
        assertTrue(results.get("responses").get(0).get("usable_to_hz").asDouble() <= 10);
    }

    @Test
    void helpShowsExamplesThatAreWhole() {
        Run run = Run.of("frf", "--help");
        assertEquals(0, run.code());
        List<String> examples = run.out().lines().dropWhile(line -> !line.startsWith("Example")).skip(1).toList();
        assertTrue(examples.size() > 5 && examples.stream().allMatch(line -> line.isBlank() || line.startsWith("  ")), run.out());
    }

    @ParameterizedTest
    @ValueSource(strings = {"--segment=-1", "--segment=NaN", "--level=1", "--plate=-2", "--skin=head=30", "--skin=head=-3:0.3",
        "--skin=Head=30:0.3", "--input=platform", "--output=head.acc"})
    void wrongWordsAreWrongUsage(String word) {
        Run run = Run.of("frf", ONE, word, "--out", folder.resolve("out").toString());
        assertEquals(2, run.code(), run.err());
        assertFalse(Files.exists(folder.resolve("out")));
    }
}

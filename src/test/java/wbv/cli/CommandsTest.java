package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import weka.core.Instances;
import weka.core.converters.ConverterUtils.DataSource;

class CommandsTest {

    private static final String LINEAR = "data/arff/one-dof-linear.arff";

    @TempDir
    private Path folder;

    @Test
    void analyzeFindsTheBodyThatTheRigHas() throws IOException {
        Path out = folder.resolve("out");
        Run run = Run.of("analyze", LINEAR, "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        JsonNode results = new ObjectMapper().readTree(out.resolve("results.json").toFile());
        JsonNode truth = new ObjectMapper().readTree(Path.of("data/arff/one-dof-linear.truth.json").toFile());
        JsonNode output = results.get("outputs").get(0);
        assertEquals("head.acc.z", output.get("channel").asText());
        JsonNode mode = output.get("body").get("modes").get(0);
        assertEquals(5, mode.get("natural_frequency_hz").asDouble(), 0.01 * 5, truth.toString());
        assertEquals(0.35, mode.get("damping_ratio").asDouble(), 0.01 * 0.35);
        assertEquals(5, output.get("stream").get("natural_frequency_hz").asDouble(), 0.05 * 5, truth.toString());
        assertEquals(0.35, output.get("stream").get("damping_ratio").asDouble(), 0.05 * 0.35);
        assertEquals(0, output.get("stream").get("adwin_cuts_s").size());
    }

    /** The estimator's body agrees with H1 from 1 to 9 Hz wherever the coherence is above 0.9. */
    @Test
    void theEstimatorsModulusIsThatOfH1() throws IOException {
        Path out = folder.resolve("out");
        Run.of("analyze", LINEAR, "--start-frequency", "7", "--start-damping", "0.5", "--out", out.toString());
        JsonNode response = new ObjectMapper().readTree(out.resolve("results.json").toFile()).get("outputs").get(0).get("transmissibility");
        int compared = 0;
        for (int k = 0; k < response.get("frequency_hz").size(); k++) {
            double f = response.get("frequency_hz").get(k).asDouble();
            if (f >= 1 && f <= 9 && response.get("coherence").get(k).asDouble() > 0.9) {
                double h1 = response.get("h1").get(k).asDouble();
                assertEquals(h1, response.get("estimator").get(k).asDouble(), 0.05 * h1, f + " Hz");
                compared++;
            }
        }
        assertTrue(compared > 30, compared + " frequencies compared");
    }

    @Test
    void tracksAreTheSameInCsvAndArffAndWekaReadsThem() throws Exception {
        Path out = folder.resolve("out");
        assertEquals(0, Run.of("analyze", LINEAR, "--out", out.toString()).code());
        Instances tracks = DataSource.read(out.resolve("tracks.arff").toString());
        List<String> csv = Files.readAllLines(out.resolve("tracks.csv")).stream().filter(line -> !line.startsWith("#")).toList();
        assertEquals(csv.size() - 1, tracks.numInstances());
        assertEquals(String.join(",", java.util.Collections.list(tracks.enumerateAttributes()).stream().map(a -> a.name()).toList()),
                csv.get(0));
        String[] last = csv.get(csv.size() - 1).split(",");
        assertEquals(Double.parseDouble(last[1]), tracks.lastInstance().value(1));
    }

    /** What is left out of a track is less than a hundredth of what it may be off, and compressed it is the same. */
    @Test
    void tracksHaveTheDecimalsThatTheyDeserve() throws Exception {
        assertEquals(0, Run.of("analyze", LINEAR, "--out", folder.resolve("plain").toString()).code());
        Run run = Run.of("analyze", LINEAR, "--gz", "--out", folder.resolve("packed").toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("tracks.csv.gz, tracks.arff.gz"), run.out());
        List<String> plain = Files.readAllLines(folder.resolve("plain/tracks.csv")).stream().filter(line -> !line.startsWith("#")).toList();
        try (java.io.BufferedReader packed = new java.io.BufferedReader(new java.io.InputStreamReader(new java.util.zip.GZIPInputStream(
                Files.newInputStream(folder.resolve("packed/tracks.csv.gz")))))) {
            assertEquals(plain, packed.lines().filter(line -> !line.startsWith("#")).toList());
        }
        String[] last = plain.get(plain.size() - 1).split(",");
        assertTrue(last[1].length() <= 7 && last[2].length() <= 8, String.join(" ", last));
        assertEquals(5, Double.parseDouble(last[1]), 0.2);
        double deviation = Double.parseDouble(last[2]);
        assertTrue(deviation > 0 && Math.rint(deviation * 1e6) == deviation * 1e6, last[2]);
        assertFalse(Files.exists(folder.resolve("packed/tracks.csv")));
    }

    @Test
    void theSameCommandGivesTheSameBytes() throws IOException {
        for (String name : List.of("a", "b")) {
            assertEquals(0, Run.of("analyze", LINEAR, "--out", folder.resolve(name).toString()).code());
        }
        for (String file : List.of("report.html", "results.json", "tracks.csv", "tracks.arff")) {
            assertArrayEquals(Files.readAllBytes(folder.resolve("a").resolve(file)), Files.readAllBytes(folder.resolve("b").resolve(file)),
                    file);
        }
    }

    @Test
    void aRecordingWithoutMotionGivesNoBody() throws IOException {
        StringBuilder rows = new StringBuilder("t,platform.acc.z,head.acc.z\n");
        for (int i = 0; i < 1200; i++) {
            rows.append(i / 60.0).append(",0,0\n");
        }
        Path still = Files.writeString(folder.resolve("stands still.csv"), rows);
        Path out = folder.resolve("out");
        Run run = Run.of("analyze", still.toString(), "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("no natural frequency: nothing moves")
                && run.out().contains("2 channels never move: platform.acc.z, head.acc.z"), run.out());
        JsonNode results = new ObjectMapper().readTree(out.resolve("results.json").toFile());
        JsonNode body = results.get("outputs").get(0).get("body");
        assertTrue(body.get("modes").isEmpty() && body.get("no_number").asText().equals("nothing moves"), body.toString());
        assertTrue(results.get("provenance").get("command").asText().contains("stands still.csv'"));
    }

    @Test
    void unitsInTheReportAreThoseOfTheChannels() throws IOException {
        Path turned = folder.resolve("turned.csv");
        Run.of("convert", LINEAR, "--out", turned.toString());
        Files.writeString(turned, Files.readString(turned).replace("t,platform.acc.z,head.acc.z", "t,platform.gyr.y,head.gyr.y"));
        Path out = folder.resolve("out");
        Run run = Run.of("analyze", turned.toString(), "--input", "platform.gyr.y", "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        String html = Files.readString(out.resolve("report.html"));
        assertTrue(html.contains("\"label\":\"Angular rate\",\"unit\":\"rad/s\""));
        assertTrue(html.contains("(rad/s)²/Hz") && !html.contains("(m/s²)²/Hz"));
    }

    @Test
    void standardInputIsARecordingToo() throws IOException {
        Run run = Run.with(Files.newInputStream(Path.of(LINEAR)), "analyze", "-", "--json", "--out", folder.resolve("out").toString());
        assertEquals(0, run.code(), run.err());
        assertEquals(7200, new ObjectMapper().readTree(run.out()).get("recording").get("rows").asInt());
    }

    @ParameterizedTest
    @ValueSource(strings = {"--help", "simulate --models", "prove --open data/arff/concealed/003",
        "task wbv.task.TrackBody -s (wbv.stream.RigStream -e 'sitter=one-dof seconds=5')"})
    void standardOutputThatCannotBeWrittenIsTold(String command) {
        OutputStream full = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("No space left on device");
            }
        };
        Run run = Run.into(full, command.startsWith("task") ? new String[] {"task", command.substring(5)} : command.split(" "));
        assertEquals(1, run.code());
        assertEquals("wbv: standard output: cannot be written; is its disk full, or its reader gone?", run.err().strip());
    }

    @Test
    void theShippedRecordingsGoIntoAFolderThatIsMadeForThem() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "mine");
        Run run = Run.of("simulate", "--shipped", file.toString());
        assertEquals(1, run.code());
        assertTrue(run.err().contains("is a file"), run.err());
        assertEquals("mine", Files.readString(file));
    }

    @Test
    void theReportLoadsNothingAndNamesItsTask() throws IOException {
        Path out = folder.resolve("out");
        Run.of("analyze", LINEAR, "--out", out.toString());
        String html = Files.readString(out.resolve("report.html"));
        assertTrue(html.contains("wbv.task.TrackBody -l (wbv.learn.AdwinKalman"));
        assertTrue(!html.contains("src=\"http") && !html.contains("href=\"http"));
    }

    @Test
    void simulateAndConvertAgree() throws IOException {
        Path ride = folder.resolve("ride.csv.gz");
        assertEquals(0, Run.of("simulate", "sitter=one-dof", "seconds=20", "seed=3", "--out", ride.toString()).code());
        Path arff = folder.resolve("ride.arff");
        Run convert = Run.of("convert", ride.toString(), "--out", arff.toString());
        assertEquals(0, convert.code(), convert.err());
        assertTrue(convert.out().contains("1200 rows laid on 1200 samples"), convert.out());
        assertEquals(0, Run.of("analyze", arff.toString(), "--out", folder.resolve("out").toString()).code());
    }

    @Test
    void convertReplacesNoFileThatAPersonWrote() throws IOException {
        for (String mine : List.of("{\"axis_signs\": {\"head\": {\"z\": -1}}}", "{\"name\": \"a model\", \"bodies\": []}")) {
            Path json = Files.writeString(folder.resolve("ride.json"), mine);
            Run run = Run.of("convert", LINEAR, "--out", folder.resolve("ride.csv").toString());
            assertEquals(1, run.code());
            assertTrue(run.err().contains("ride.json"), run.err());
            assertEquals(mine, Files.readString(json));
            assertTrue(Files.notExists(folder.resolve("ride.csv")));
        }
        Files.delete(folder.resolve("ride.json"));
        for (int twice = 0; twice < 2; twice++) {
            assertEquals(0, Run.of("convert", LINEAR, "--out", folder.resolve("ride.csv").toString()).code());
        }
    }

    @Test
    void aTaskStringGivesItsCurve() {
        Run run = Run.of("task",
                "wbv.task.TrackBody -s (wbv.stream.RecordingStream -f " + LINEAR + " -i platform.acc.z -o head.acc.z) -e 30");
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("natural frequency [Hz]"), run.out());
    }

    @ParameterizedTest
    @ValueSource(strings = {"analyze", "exposure", "frf", "track", "live", "poles", "states", "fleet", "identify", "diagnose", "prove",
        "convert", "simulate", "export", "task", "map", "completion"})
    void everyCommandExplainsItselfWithAnExample(String command) {
        Run run = Run.of(command, "--help");
        assertEquals(0, run.code());
        assertTrue(run.out().contains("Example"), run.out());
        for (String line : run.out().lines().dropWhile(line -> !line.startsWith("Example")).skip(1).toList()) {
            assertTrue(line.isBlank() || line.startsWith("  "), "an example was broken: " + line);
        }
    }

    @Test
    void aCarsAxleIsReadByTheShippedMap() throws IOException {
        Path recording = Path.of("../shared/real/wobble/wobble_20211029T125712.csv.gz");
        Assumptions.assumeTrue(Files.exists(recording), "no recordings of others here");
        Path out = folder.resolve("out");
        Run run = Run.of("analyze", recording.toString(), "--map", "data/maps/wobble.json", "--input", "axle_pass.acc.z", "--output",
                "knuckle_pass.acc.z", "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        String html = Files.readString(out.resolve("report.html"));
        assertTrue(html.contains("axle_pass.acc has a gross bias"));
        assertTrue(html.contains("all channels of axle_pass are exactly zero in 2 rows"));
    }
}

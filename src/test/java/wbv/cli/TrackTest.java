package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.filter.Method;
import weka.core.Instances;
import weka.core.converters.ConverterUtils.DataSource;

class TrackTest {

    private static final String LINEAR = "data/arff/one-dof-linear.arff";
    private static final String TWO = "data/arff/two-dof.arff";
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    private JsonNode results(Path out) throws IOException {
        return JSON.readTree(out.resolve("results.json").toFile());
    }

    @Test
    void everyEstimatorFindsTheBodyThatTheRigHas() throws Exception {
        Path out = folder.resolve("out");
        Run run = Run.of("track", LINEAR, "--estimator", "all", "--particles", "400", "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        double frequency = truth("omega") / (2 * Math.PI);
        double damping = truth("zeta");
        JsonNode tracks = results(out).get("tracks");
        assertEquals(Method.values().length, tracks.size());
        for (JsonNode track : tracks) {
            JsonNode mode = track.get("modes").get(0);
            String name = track.get("estimator").asText();
            assertEquals(1, mode.get("natural_frequency_hz").asDouble() / frequency, 0.02, name);
            assertEquals(1, mode.get("damping_ratio").asDouble() / damping, 0.03, name);
            assertTrue(track.get("mse_of_variance").asDouble() < 0.01, name);
        }
        List<String> csv = Files.readAllLines(out.resolve("tracks.csv")).stream().filter(line -> !line.startsWith("#")).toList();
        Instances arff = DataSource.read(out.resolve("tracks.arff").toString());
        JsonNode json = JSON.readTree(out.resolve("tracks.json").toFile());
        assertEquals(csv.size() - 1, arff.numInstances());
        assertEquals(csv.size() - 1, json.get("rows").size());
        String[] names = csv.get(0).split(",");
        String[] last = csv.get(csv.size() - 1).split(",");
        for (int i = 0; i < names.length; i++) {
            assertEquals(names[i], arff.attribute(i).name());
            assertEquals(names[i], json.get("columns").get(i).asText());
            assertEquals(Double.parseDouble(last[i]), arff.lastInstance().value(i), 0);
            assertEquals(Double.parseDouble(last[i]), json.get("rows").get(csv.size() - 2).get(i).asDouble(), 0);
        }
        assertTrue(Files.readString(out.resolve("report.html")).contains("Natural frequency"));
    }

    private static double truth(String name) throws IOException {
        return JSON.readTree(Path.of("data/arff/one-dof-linear.truth.json").toFile()).get("at_start").get(name).asDouble();
    }

    /** A ride with many axes: what fore-and-aft motion and pitch do to the head is most of what one input cannot foresee. */
    @Test
    void otherMotionsOfTheBaseAreTakenAway() throws IOException {
        String ride = "data/arff/ride-subject1.arff";
        double[] left = new double[2];
        for (int i = 0; i < 2; i++) {
            Path out = folder.resolve("out" + i);
            List<String> words = new java.util.ArrayList<>(List.of("track", ride, "--output", "head.acc.z", "--estimator",
                    "constrained", "--out", out.toString()));
            if (i == 1) {
                words.addAll(List.of("--cross", "platform.acc.x,platform.gyr.y"));
            }
            Run run = Run.of(words.toArray(String[]::new));
            assertEquals(0, run.code(), run.err());
            left[i] = results(out).get("tracks").get(0).get("mse_of_variance").asDouble();
        }
        assertTrue(left[1] < 0.25 * left[0], left[1] + " of " + left[0]);
        assertEquals(1, Run.of("track", ride, "--cross", "platform.acc.z", "--out", folder.resolve("no").toString()).code());
        assertEquals(1, Run.of("track", ride, "--cross", "roof.acc.x", "--out", folder.resolve("no").toString()).code());
        assertFalse(Files.exists(folder.resolve("no")), "nothing half-written");
    }

    @Test
    void bothModesOfTheTwoMassesAreFound() throws IOException {
        Path out = folder.resolve("out");
        assertEquals(0, Run.of("track", TWO, "--degrees", "2", "--estimator", "ekf-adwin", "--output", "head.acc.z", "--out",
                out.toString()).code());
        JsonNode truth = JSON.readTree(Path.of("data/arff/two-dof.truth.json").toFile()).get("at_start");
        JsonNode modes = results(out).get("tracks").get(0).get("modes");
        for (int m = 0; m < 2; m++) {
            assertEquals(truth.get("omega" + (m + 1)).asDouble() / (2 * Math.PI),
                    modes.get(m).get("natural_frequency_hz").asDouble(),
                    4 * modes.get(m).get("natural_frequency_sd_hz").asDouble());
            assertEquals(truth.get("zeta" + (m + 1)).asDouble(), modes.get(m).get("damping_ratio").asDouble(), 0.03);
        }
    }

    @Test
    void theTaskInTheReportGivesTheSameEstimate() throws IOException {
        Path out = folder.resolve("out");
        Run.of("track", LINEAR, "--estimator", "ukf", "--out", out.toString());
        String html = Files.readString(out.resolve("report.html"));
        int at = html.indexOf("wbv.task.TrackBody");
        String task = html.substring(at, html.indexOf('<', at)).replace("&quot;", "\"");
        Run run = Run.of("task", task);
        assertEquals(0, run.code(), run.err());
        String[] lines = run.out().strip().split("\n");
        double frequency = results(out).get("tracks").get(0).get("modes").get(0).get("natural_frequency_hz").asDouble();
        assertTrue(lines[lines.length - 1].contains(Double.toString(frequency)), lines[lines.length - 1] + " lacks " + frequency);
    }

    @Test
    void aBoundHolds() throws IOException {
        Path out = folder.resolve("out");
        Run run = Run.of("track", LINEAR, "--estimator", "constrained", "--bound", "frequency=6:8", "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        assertEquals(6, results(out).get("tracks").get(0).get("modes").get(0).get("natural_frequency_hz").asDouble(), 1e-6);
    }

    @Test
    void aRecordingInWhichNothingMovesSaysSo() throws IOException {
        StringBuilder rows = new StringBuilder("t,platform.acc.z,head.acc.z\n");
        for (int i = 0; i < 1200; i++) {
            rows.append(i / 60.0).append(",0.001,").append(i % 2 == 0 ? 0.001 : 0.002).append('\n');
        }
        Path still = Files.writeString(folder.resolve("still.csv"), rows);
        Run run = Run.of("track", still.toString(), "--estimator", "ekf-adwin", "--out", folder.resolve("out").toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("nothing excited the body"), run.out());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "2 | --estimator kalman                               | must be one of ekf, ekf-adwin, ukf, particle, constrained",
        "2 | --degrees 3                                      | degrees of freedom must be 1 or 2: 3",
        "2 | --particles 3 --estimator particle               | particles must be 50 to 1000000: 3",
        "2 | --bound frequency=3:6                            | --bound needs --estimator constrained",
        "2 | --estimator constrained --bound weight=3:6       | frequency, damping, real, imaginary, output",
        "2 | --estimator constrained --bound frequency=6      | a bound is written like frequency=3:6",
        "2 | --noise 0                                        | --noise must be",
        "1 | --output sternum.acc.z                           | no channel sternum.acc.z",
        "1 | --output platform.acc.z                          | input and output are both platform.acc.z"})
    void whatIsWrongIsSaidAndNothingIsLeft(int code, String options, String said) {
        Path out = folder.resolve("out");
        String[] words = ("track " + LINEAR + " --out " + out + " " + options.trim()).split(" ");
        Run run = Run.of(words);
        assertEquals(code, run.code(), run.err());
        assertTrue(run.err().contains(said.trim()), run.err());
        assertFalse(Files.exists(out));
    }

    @Test
    void anAccelerationDoesNotAnswerAnAngularRate() {
        Run run = Run.of("track", "data/arff/ride-subject1.arff", "--input", "platform.gyr.y", "--output", "head.acc.z", "--out",
                folder.resolve("out").toString());
        assertEquals(1, run.code());
        assertTrue(run.err().contains("two accelerations or two angular rates"), run.err());
    }

    @Test
    void bothFiltersRestAtTheBodyOfTheRig() throws IOException {
        Path out = folder.resolve("out");
        Run run = Run.of("track", LINEAR, "--asymptotes", "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        for (JsonNode filter : results(out).get("filters")) {
            assertEquals(1, filter.get("rest_frequency_hz").asDouble() / (truth("omega") / (2 * Math.PI)), 0.01);
            assertEquals(1, filter.get("rest_damping_ratio").asDouble() / truth("zeta"), 0.02);
            assertTrue(filter.get("stable").asBoolean());
        }
        assertTrue(Files.readString(out.resolve("report.html")).contains("Where ekf-adwin goes"));
        assertTrue(Files.readAllLines(out.resolve("asymptotes.csv")).size() > 300);
    }
}

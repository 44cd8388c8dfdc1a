package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The numbers that {@code analyze} and {@code track} print of a body: the same of the same question, and none where none stand. */
class BodyNumbersTest {

    @TempDir
    private Path folder;

    private JsonNode results(String command, String file) throws IOException {
        Path out = folder.resolve(command);
        Run run = command.equals("track") ? Run.of("track", file, "--estimator", "ekf-adwin", "--out", out.toString())
                : Run.of("analyze", file, "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        return new ObjectMapper().readTree(out.resolve("results.json").toFile());
    }

    @Test
    void theSameQuestionHasTheSameAnswer() throws IOException {
        String file = "data/arff/one-dof-linear.arff";
        JsonNode analyzed = results("analyze", file).get("outputs").get(0).get("body");
        assertEquals(analyzed, results("track", file).get("bodies").get("head.acc.z"));
        JsonNode mode = analyzed.get("modes").get(0);
        assertEquals(5, mode.get("natural_frequency_hz").asDouble(), 3 * mode.get("natural_frequency_sd_hz").asDouble());
        assertEquals(0.35, mode.get("damping_ratio").asDouble(), 3 * mode.get("damping_ratio_sd").asDouble());
        assertTrue(analyzed.get("explained").asDouble() > 0.99, analyzed.toString());
    }

    /** Two noises of the same band that have nothing to do with each other. */
    @Test
    void whereNothingIsExplainedThereIsAReasonInstead() throws IOException {
        Random random = new Random(4);
        StringBuilder rows = new StringBuilder("t,platform.acc.z,head.acc.z\n");
        double u = 0;
        double y = 0;
        for (int i = 0; i < 2400; i++) {
            u = 0.8 * u + random.nextGaussian();
            y = 0.8 * y + random.nextGaussian();
            rows.append(i / 60.0).append(',').append(u).append(',').append(y).append('\n');
        }
        String file = Files.writeString(folder.resolve("apart.csv"), rows).toString();
        JsonNode body = results("analyze", file).get("outputs").get(0).get("body");
        assertTrue(body.get("modes").isEmpty() && !body.get("no_number").asText().isEmpty(), body.toString());
        JsonNode track = results("track", file);
        assertEquals(body, track.get("bodies").get("head.acc.z"));
        Run run = Run.of("track", file, "--estimator", "ekf-adwin,fused", "--out", folder.resolve("again").toString());
        assertTrue(run.out().lines().filter(line -> line.contains("head.acc.z") || line.contains("at the end"))
                .allMatch(line -> line.contains("no natural frequency: ") && !line.contains("±")), run.out());
    }
}

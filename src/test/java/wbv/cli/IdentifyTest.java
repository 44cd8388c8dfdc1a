package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code wbv identify} against the truth beside the shipped recordings. */
class IdentifyTest {

    @TempDir
    private Path folder;

    @Test
    void twoMassesHaveTheirTwoModes() throws IOException {
        Run run = Run.of("identify", "data/arff/two-dof.arff", "--input", "platform.acc.z", "--output", "head.acc.z", "--poles", "2,4",
                "--out", folder.resolve("out").toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("Schwarz's criterion chooses 4 poles of 2, 4"), run.out());
        JsonNode found = new ObjectMapper().readTree(folder.resolve("out/identification.json").toFile());
        JsonNode modes = found.get("armax").get("modes");
        assertEquals(2, modes.size());
        assertHolds(5.868, modes.get(0), "natural_frequency");
        assertHolds(14.340, modes.get(1), "natural_frequency");
        assertEquals(0.681, modes.get(0).get("damping_ratio").asDouble(), 3 * modes.get(0).get("damping_ratio_sd").asDouble());
        assertTrue(found.get("armax").get("simulated").asDouble() > 0.99);
        assertHolds(5.868, found.get("instruments").get("modes").get(0), "natural_frequency");
        assertHolds(14.340, found.get("instruments").get("modes").get(1), "natural_frequency");
        assertFalse(found.get("provenance").get("command").asText().isEmpty());
    }

    /** A dashpot follows its rod: motion up to 10 Hz, 300 samples a second, no mode. */
    @Test
    void nothingThatIsNotExcitedGetsANumber() throws IOException {
        Random random = new Random(5);
        StringBuilder rows = new StringBuilder("t,rod.pos.z [m],damper.force.z [N]\n");
        double[] phases = random.doubles(100, 0, 2 * Math.PI).toArray();
        for (int k = 0; k < 3000; k++) {
            double t = k / 300.0;
            double x = 0;
            double v = 0;
            for (int line = 5; line < phases.length; line++) {
                double w = 2 * Math.PI * line / 10;
                x += 2e-3 / w * Math.sin(w * t + phases[line]);
                v += 2e-3 * Math.cos(w * t + phases[line]);
            }
            rows.append(String.format(Locale.ROOT, "%.6f,%.8f,%.5f%n", t, x + 1e-6 * random.nextGaussian(),
                    2000 * x + 1800 * v + 0.5 * random.nextGaussian()));
        }
        Path bench = Files.writeString(folder.resolve("bench.csv"), rows);
        Run run = Run.of("identify", bench.toString(), "--input", "rod.pos.z", "--output", "damper.force.z", "--out",
                folder.resolve("none").toString());
        assertEquals(0, run.code(), run.err());
        assertFalse(run.out().contains("natural frequency"), run.out());
        assertTrue(run.out().contains("is no mode with a number"), run.out());
        assertTrue(run.out().contains("used at 4"), "slower than it was recorded: " + run.out());
        JsonNode found = new ObjectMapper().readTree(folder.resolve("none/identification.json").toFile());
        assertEquals(0, found.get("armax").get("modes").size());
        assertTrue(found.get("armax").get("undetermined").size() > 0, found.toString());
        assertEquals(9.9, found.get("excited_to_hz").asDouble(), 1);
    }

    private static void assertHolds(double truth, JsonNode mode, String what) {
        assertEquals(truth, mode.get(what + "_hz").asDouble(), 3 * mode.get(what + "_sd_hz").asDouble());
    }

    @Test
    void whatCannotBeIdentifiedIsOneLine() throws IOException {
        String[] start = {"identify", "data/arff/two-dof.arff", "--input", "platform.acc.z", "--output"};
        assertRefused(2, "must be different channels", start[0], start[1], start[2], start[3], start[4], "platform.acc.z");
        assertRefused(2, "--poles must be 2 to 20", start[0], start[1], start[2], start[3], start[4], "head.acc.z", "--poles", "1");
        assertRefused(1, "no channel knee.acc.z", start[0], start[1], start[2], start[3], start[4], "knee.acc.z");
        StringBuilder rows = new StringBuilder("t,platform.acc.z,head.acc.z\n");
        for (int i = 0; i < 40; i++) {
            rows.append(i / 60.0).append(',').append(Math.sin(i)).append(",0\n");
        }
        Path still = Files.writeString(folder.resolve("still.csv"), rows);
        assertRefused(1, "head.acc.z does not move", "identify", still.toString(), "--input", "platform.acc.z", "--output", "head.acc.z");
        Path brief = Files.writeString(folder.resolve("brief.csv"), rows.toString().replace(",0\n", ",1\n").replaceFirst(",1\n", ",2\n"));
        assertRefused(1, "samples without a gap", "identify", brief.toString(), "--input", "platform.acc.z", "--output", "head.acc.z",
                "--poles", "8");
    }

    private void assertRefused(int code, String why, String... words) {
        String[] all = java.util.Arrays.copyOf(words, words.length + 2);
        all[words.length] = "--out";
        all[words.length + 1] = folder.resolve("none").toString();
        Run run = Run.of(all);
        assertEquals(code, run.code(), run.err());
        assertTrue(run.err().lines().findFirst().orElse("").contains(why), run.err());
        assertFalse(Files.exists(folder.resolve("none")));
    }
}

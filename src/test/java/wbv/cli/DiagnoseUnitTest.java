package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.fmi.BuiltUnit;
import wbv.fmi.FmuSimulation;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.recording.format.RecordingWriter;

/** A user's own simulator as a functional mock-up unit: a quarter car, from which nothing, values, or a bump stop are concealed. */
class DiagnoseUnitTest {

    private static final double RATE = 60;
    private static final double NOISE = 0.01;
    private static final Channel BASE = Channel.parse("platform.acc.z");

    @TempDir
    private Path folder;

    @BeforeAll
    static void compiler() {
        BuiltUnit.needsCompiler();
    }

    /** What sensors record of a quarter car on a plate that is shaken. @param level root mean square of the plate [m/s²] */
    private Path recorded(BuiltUnit.Plan plan, double level, int seconds, long seed, String... concealed) throws IOException {
        return recorded(plan, Map.of(BASE, level), seconds, seed, concealed);
    }

    /** What sensors record of a unit that is shaken at random from 0.5 to 15 Hz. @param levels root mean square of each input */
    private Path recorded(BuiltUnit.Plan plan, Map<Channel, Double> levels, int seconds, long seed, String... concealed)
            throws IOException {
        int samples = (int) (seconds * RATE);
        Random random = new Random(seed);
        Map<Channel, double[]> inputs = new LinkedHashMap<>();
        levels.forEach((channel, level) -> inputs.put(channel, shaken(samples, level, random)));
        Path truth = BuiltUnit.build(folder, "truth.fmu", plan, 3, BuiltUnit.DERIVATIVES, concealed);
        Map<Channel, double[]> all = new LinkedHashMap<>();
        inputs.forEach((channel, x) -> all.put(channel, measured(channel, x, random)));
        Recording shaken = new Recording(new Clock(0, RATE), inputs, Metadata.NONE);
        try (FmuSimulation simulation = FmuSimulation.open(truth, shaken, Map.of(), Map.of())) {
            Recording moved = simulation.run(Map.of());
            moved.channels().forEach(channel -> all.put(channel, measured(channel, moved.values(channel), random)));
        }
        Path file = folder.resolve("recording.csv");
        RecordingWriter.write(file, new Recording(shaken.clock(), all, Metadata.NONE));
        return file;
    }

    private static double[] shaken(int samples, double level, Random random) {
        double[] out = new double[samples];
        for (int k = 0; k < 200; k++) {
            double frequency = 0.5 + 14.5 * random.nextDouble();
            double phase = 2 * Math.PI * random.nextDouble();
            for (int i = 0; i < samples; i++) {
                out[i] += level * 0.1 * Math.sin(2 * Math.PI * frequency * i / RATE + phase);
            }
        }
        return out;
    }

    /** Noise of accelerometers [m/s²] and of gyroscopes [rad/s]. */
    private static double[] measured(Channel channel, double[] x, Random random) {
        double noise = channel.quantity() == Quantity.ANGULAR_RATE ? 0.05 * NOISE : NOISE;
        return java.util.Arrays.stream(x).map(value -> value + noise * random.nextGaussian()).toArray();
    }

    private JsonNode diagnosed(Path recording, Path unit) throws IOException {
        Path out = folder.resolve("out");
        Run run = Run.of("diagnose", recording.toString(), "--simulation", unit.toString(), "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        return new ObjectMapper().readTree(out.resolve("diagnosis.json").toFile());
    }

    @Tag("slow")
    @Test
    void nothingIsMissingOfAUnitThatIsRight() throws IOException {
        Path recording = recorded(BuiltUnit.QUARTER_CAR, 1, 40, 1);
        JsonNode found = diagnosed(recording, BuiltUnit.build(folder, "car.fmu", BuiltUnit.QUARTER_CAR, 2, BuiltUnit.STEPS));
        assertEquals("nothing-missing", found.get("verdict").asText(), found.get("sentence").asText());
        assertEquals(3, new RecordingFile(folder.resolve("out/simulation.csv")).load().channels().size());
    }

    /** The body's spring and the seat's damper as the unit has them are wrong. */
    @Tag("slow")
    @Test
    void wrongValuesOfAUnitAreFitted() throws IOException {
        Path recording = recorded(BuiltUnit.QUARTER_CAR, 1, 40, 2);
        BuiltUnit.Plan wrong = BuiltUnit.QUARTER_CAR.off("suspension.k", 1.12).off("seat.c", 0.85);
        JsonNode found = diagnosed(recording, BuiltUnit.build(folder, "car.fmu", wrong, 3, BuiltUnit.DERIVATIVES));
        assertEquals("parameters-only", found.get("verdict").asText(), found.get("sentence").asText());
        JsonNode values = new ObjectMapper().readTree(folder.resolve("out/parameters.json").toFile());
        // Accelerations know values up to a factor on all; the one is chosen with which few have changed.
        BuiltUnit.QUARTER_CAR.parameters().forEach(each -> {
            JsonNode own = values.get(each.name());
            assertEquals(each.start(), own.get("fitted").asDouble(), 4 * own.get("std").asDouble() + 0.003 * each.start(), each.name());
        });
        assertTrue(values.get("suspension.k").get("std").asDouble() < 0.01 * 22000);
        assertEquals(1.12 * 22000, values.get("suspension.k").get("given").asDouble(), 1e-6);
        String sentence = found.get("sentence").asText();
        assertTrue(sentence.contains("car.fmu were wrong: ") && sentence.contains("suspension.k ") && sentence.contains("seat.c "),
                sentence);
    }

    /** A stop of rubber in the suspension, of which the unit knows nothing. */
    @Tag("exam")
    @Test
    void whatIsConcealedAgainstAUnitIsNamedAndProven() throws IOException {
        Path recording = recorded(BuiltUnit.QUARTER_CAR, 1, 30, 3, "BUMP_STOP");
        JsonNode found = diagnosed(recording, BuiltUnit.build(folder, "car.fmu", BuiltUnit.QUARTER_CAR, 2, BuiltUnit.STEPS));
        assertEquals("missing-physics", found.get("verdict").asText(), found.get("sentence").asText());
        JsonNode named = found.get("missing").get(0);
        assertEquals("contact.bumpstop", named.get("mechanism").asText());
        assertEquals("axle-body", named.get("where").asText());
        JsonNode fit = found.get("fit");
        for (String channel : new String[] {"axle.acc.z", "body.acc.z", "seat.acc.z"}) {
            double before = fit.get("heldout_nrmse_before").get(channel).asDouble();
            assertTrue(fit.get("heldout_nrmse_after").get(channel).asDouble() < before / 3, channel);
        }
    }

    /** A stop under the cushion of a person who is shaken in x, z and pitch at once. */
    @Tag("exam")
    @Test
    void whatIsConcealedInAPlanarPersonIsNamedAndProven() throws IOException {
        Map<Channel, Double> levels = new LinkedHashMap<>();
        levels.put(Channel.parse("platform.acc.x"), 0.6);
        levels.put(BASE, 1.0);
        levels.put(Channel.parse("platform.gyr.y"), 0.05);
        Path recording = recorded(BuiltUnit.PLANAR_PERSON, levels, 40, 6, "BUMP_STOP");
        JsonNode found = diagnosed(recording, BuiltUnit.build(folder, "person.fmu", BuiltUnit.PLANAR_PERSON, 2, BuiltUnit.SLOPES));
        assertEquals("missing-physics", found.get("verdict").asText(), found.get("sentence").asText());
        JsonNode named = found.get("missing").get(0);
        assertEquals("contact.bumpstop", named.get("mechanism").asText());
        assertEquals("platform-sternum", named.get("where").asText());
        assertEquals(0.6e-3, named.get("parameters").get("gap_m").asDouble(), 0.06e-3);
        for (String channel : new String[] {"sternum.acc.z", "head.acc.z"}) {
            assertTrue(found.get("fit").get("heldout_nrmse_after").get(channel).asDouble()
                    < found.get("fit").get("heldout_nrmse_before").get(channel).asDouble() / 2, channel);
        }
    }

    @Test
    void aUnitIsSimulatedOnARecording() throws IOException {
        Path recording = recorded(BuiltUnit.QUARTER_CAR, 1, 10, 4);
        BuiltUnit.Plan named = BuiltUnit.QUARTER_CAR.inputs(BuiltUnit.ordered("road", "m/s2", "f1", "N", "f2", "N"));
        Path unit = BuiltUnit.build(folder, "car.fmu", named, 2, BuiltUnit.STEPS);
        Path out = folder.resolve("simulated.csv");
        Run run = Run.of("simulate", "--fmu", unit.toString(), "--input", recording.toString(), "--map-input", "road=platform.acc.z",
                "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().contains("road = platform.acc.z") && run.out().contains("no channel for the input f1, held at 0.0 N"),
                run.out());
        Recording simulated = new RecordingFile(out).load();
        Recording truth = new RecordingFile(recording).load();
        Channel seat = Channel.parse("seat.acc.z");
        double largest = 0;
        for (int i = 30; i < truth.length() - 30; i++) {
            largest = Math.max(largest, Math.abs(simulated.values(seat)[i] - truth.values(seat)[i]));
        }
        assertTrue(largest < 10 * NOISE, "off by " + largest);
    }

    @Test
    void whatCannotWorkGetsOneLine() throws IOException {
        Path recording = recorded(BuiltUnit.QUARTER_CAR, 1, 10, 5);
        Path text = Files.writeString(folder.resolve("text.fmu"), "t,seat.acc.z\n0,1\n");
        refused(1, text + ": is no functional mock-up unit: not a whole zip archive", "diagnose", recording.toString(), "--simulation",
                text.toString());
        refused(1, "there is no such file", "diagnose", recording.toString(), "--simulation", folder.resolve("none.fmu").toString());
        refused(2, "--map-input and --map-output are about", "diagnose", recording.toString(), "--simulation", "simulation.csv",
                "--map-input", "a=platform.acc.z");
        refused(2, "--input goes with one of --model and --fmu", "simulate", "--fmu", text.toString(), "--out",
                folder.resolve("x.csv").toString());
        refused(2, "a channel is named location.quantity.axis", "simulate", "--fmu", text.toString(), "--input", recording.toString(),
                "--map-input", "a=b", "--out", folder.resolve("x.csv").toString());
    }

    private void refused(int code, String said, String... words) {
        Run run = Run.of(words);
        assertEquals(code, run.code(), run.err());
        assertTrue(run.err().contains(said), run.err());
        assertEquals(code, run.err().strip().lines().count(),
                "a line, and where the usage is wrong one that says what helps: " + run.err());
        assertFalse(Files.exists(folder.resolve("x.csv")));
    }
}

package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.recording.format.RecordingWriter;

/** What {@code wbv diagnose} cannot work with gets one clear line and exit code 1, and leaves nothing behind. */
class DiagnoseInputTest {

    private static final Path CASE = Path.of("data/arff/concealed/001");
    private static final double G = 9.80665;

    private static Recording whole;
    private static String model;

    @TempDir
    private Path folder;

    @BeforeAll
    static void read() throws IOException {
        whole = new RecordingFile(CASE.resolve("recording.csv.gz")).load();
        model = Files.readString(CASE.resolve("model.json"));
    }

    static Stream<Arguments> models() {
        return Stream.of(
                Arguments.of("a link to no body", model("\"to\": \"torso\"", "\"to\": \"chest\""),
                        "joins 'chest', which is no body"),
                Arguments.of("a body that no link reaches", model("\"from\": \"platform\"", "\"from\": \"head\""),
                        "no chain of links joins it to the base 'platform'"),
                Arguments.of("no mass", model("48.84", "0"), "bodies[1]: mass of torso must be > 0 kg: 0.0"),
                Arguments.of("a mass below nothing", model("48.84", "-48.84"), "bodies[1]: mass of torso must be > 0 kg: -48.84"),
                Arguments.of("a mass that is no number", model("48.84", "NaN"), "bodies[1]: mass of torso must be > 0 kg: NaN"),
                Arguments.of("a mass without end", model("48.84", "1e999"), "bodies[1]: mass of torso must be > 0 kg: Infinity"),
                Arguments.of("a mass in words", model("48.84", "\"48.84\""), "bodies[1]: 'mass_kg' must be a number"),
                Arguments.of("a mass in pounds", model("\"mass_kg\": 48.84", "\"mass_lb\": 107"), "'mass_lb' is not known here"),
                Arguments.of("stiffness below nothing", model("76480.0", "-1"),
                        "links[1]: stiffness of seat-torso must be >= 0 N/m: -1.0"),
                Arguments.of("a base without a sensor", model("\"platform.acc.z\"", "null"), "base 'platform' has no sensor"),
                Arguments.of("a sensor that was not there", model("sternum.acc.z", "neck.acc.z"), "has no channel neck.acc.z"),
                Arguments.of("a word without quotes", model("\"seat\",\n   \"mass_kg\"", "seat,\n   \"mass_kg\""),
                        "model.json:10: is not JSON"),
                Arguments.of("a comma too many", model("11.84,", "11.84,,"), "model.json:11: is not JSON"),
                Arguments.of("an end too early", model.substring(0, model.indexOf("48.84")),
                        "model.json:16: is not JSON: Unexpected end-of-input"),
                Arguments.of("a key twice", model("\"axis\": \"z\"", "\"name\": \"z\""),
                        "model.json:3: is not JSON: Duplicate field 'name'"),
                Arguments.of("a list", "[1, 2]", "must be an object"), Arguments.of("nothing", "", "must be an object"));
    }

    private static String model(String part, String replacement) {
        String out = model.replaceFirst(java.util.regex.Pattern.quote(part),
                java.util.regex.Matcher.quoteReplacement(replacement));
        assertFalse(out.equals(model), "nothing was changed");
        return out;
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("models")
    void aModelThatIsWrong(String name, String text, String said) throws IOException {
        Path file = Files.writeString(folder.resolve("model.json"), text);
        refuses(said, CASE.resolve("recording.csv.gz"), "--model", file.toString());
    }

    @Test
    void aModelThatIsNoFileOrNoText() throws IOException {
        Path recording = CASE.resolve("recording.csv.gz");
        refuses("nowhere.json: there is no such file", recording, "--model", folder.resolve("nowhere.json").toString());
        refuses("published are allen-1978-2dof", recording, "--model", "wei-griffin-1999-2dof");
        refuses("is a folder", recording, "--model", folder.toString());
        refuses("is not text", recording, "--model", recording.toString());
    }

    @Test
    void anInputThatStandsStill() throws IOException {
        refuses("platform.acc.z is 0.25 throughout", changed(Map.of("platform", x -> 0.25)), "--model", given());
        refuses("head.acc.z is 0.0 throughout", changed(Map.of("head", x -> 0)), "--model", given());
    }

    @Test
    void anInputThatOnlyNoiseMoves() throws IOException {
        Random random = new Random(1);
        refuses("platform.acc.z has no excitation", changed(Map.of("platform", x -> 0.01 * random.nextGaussian())), "--model",
                given());
    }

    @Test
    void anInputThatCausesNothing() throws IOException {
        Random random = new Random(2);
        double[] slow = {0, 0};
        refuses("the coherence with the best of them is 0.", changed(Map.of("platform", x -> {
            slow[0] += 0.3 * (random.nextGaussian() - slow[0]);
            return slow[1] += 0.3 * (slow[0] - slow[1]);
        })), "--model", given());
    }

    @Test
    void aShortRecording() throws IOException {
        refuses("a diagnosis needs at least 15 s; the recording has 10.0 s", written(cut(whole, 600)), "--model", given());
        refuses("a diagnosis needs at least 1024 samples at 60.00 Hz, which are 17.1 s; the recording has 16.7 s",
                written(cut(whole, 1000)), "--model", given());
    }

    /** One place, the base alone, and all of them. */
    @ParameterizedTest
    @CsvSource({"g, head", "mg, head", "g, platform", "mg, platform", "g, platform seat sternum head",
        "mg, platform seat sternum head"})
    void accelerationsThatAreNotInMetresPerSecondSquared(String unit, String places) throws IOException {
        double factor = unit.equals("g") ? 1 / G : 1000 / G;
        Map<String, DoubleUnaryOperator> change = new LinkedHashMap<>();
        for (String place : places.split(" ")) {
            change.put(place, x -> factor * x);
        }
        refuses("to be in " + unit + "; say the unit", changed(change), "--model", given());
    }

    /** Whoever says that a faint ride is in m/s² is believed. */
    @Test
    void aUnitThatWasSaidIsNotDoubted() throws IOException {
        Path file = changed(Map.of("platform", x -> x / G, "seat", x -> x / G, "sternum", x -> x / G, "head", x -> x / G));
        Path map = Files.writeString(folder.resolve("map.json"), "{\"time\": {\"column\": \"t\"}, \"patterns\": [{\"column\": "
                + "\"{location}.acc.{axis}\", \"channel\": \"{location}.acc.{axis}\", \"unit\": \"m/s2\"}]}");
        Run run = Run.of("diagnose", file.toString(), "--map", map.toString(), "--model", given(), "--out",
                folder.resolve("out").toString());
        assertEquals(0, run.code(), run.err());
        assertTrue(run.out().startsWith("The model does not say its \"subject\"; it is taken for a person,")
                && run.out().contains("\nnothing-missing"), run.out());
    }

    @Test
    void resultsThatCannotGoWhereTheyShould() throws IOException {
        Path taken = Files.writeString(folder.resolve("taken"), "mine");
        String recording = CASE.resolve("recording.csv.gz").toString();
        Run run = Run.of("diagnose", recording, "--model", given(), "--out", taken.resolve("out").toString());
        assertEquals(1, run.code());
        assertTrue(run.err().startsWith("wbv: " + taken + ": is a file"), run.err());
        assertEquals("mine", Files.readString(taken));
    }

    @Test
    void resultsThatMayNotBeWritten() throws IOException {
        Path locked = Files.createDirectory(folder.resolve("locked"));
        Assumptions.assumeTrue(locked.toFile().setWritable(false) && !Files.isWritable(locked), "this user may write anywhere");
        Run run = Run.of("diagnose", CASE.resolve("recording.csv.gz").toString(), "--model", given(), "--out",
                locked.resolve("out").toString());
        assertEquals(1, run.code());
        assertTrue(run.err().contains("no permission"), run.err());
    }

    @Test
    void simulationsThatTellNothing() throws IOException {
        Path recording = CASE.resolve("recording.csv.gz");
        refuses("nowhere.csv: no such file", recording, "--simulation", folder.resolve("nowhere.csv").toString());
        Path file = folder.resolve("bad.csv");
        Files.writeString(file, "t,neck.acc.z\n0,1\n0.01667,2\n0.03333,1\n");
        refuses("has no acceleration along z that was recorded too", recording, "--simulation", file.toString());
        Files.writeString(file, "t,head.acc.z\n0,1\n0.01,2\n0.02,1\n0.03,1\n");
        refuses("is not on the recording's clock", recording, "--simulation", file.toString());
        refuses("at least 15 s", recording, "--simulation", written(cut(whole, 600)).toString());
        refuses("what drove the simulation", recording, "--simulation", written(whole).toString(), "--input", "floor.acc.z");
    }

    @Test
    void whatItIsHeldAgainstHasToBeSaid() {
        String recording = CASE.resolve("recording.csv.gz").toString();
        Run run = Run.of("diagnose", recording, "--out", folder.resolve("out").toString());
        assertEquals(2, run.code());
        assertTrue(run.err().contains("--model MODEL, or --simulation FILE"), run.err());
        for (String noise : List.of("0", "-1", "NaN", "Infinity")) {
            assertEquals(2, Run.of("diagnose", recording, "--model", given(), "--noise", noise).code(), noise);
        }
        run = Run.of("diagnose", recording, "--model", given(), "--simulation", "simulation.csv");
        assertEquals(2, run.code());
        assertTrue(run.err().contains("a file goes without --model"), run.err());
    }

    private void refuses(String said, Path recording, String... words) throws IOException {
        Path out = folder.resolve("out");
        List<String> line = new java.util.ArrayList<>(List.of("diagnose", recording.toString(), "--out", out.toString()));
        line.addAll(List.of(words));
        Run run = Run.of(line.toArray(String[]::new));
        assertEquals(1, run.code(), run.err() + run.out());
        assertEquals(1, run.err().strip().lines().count(), run.err());
        assertTrue(run.err().startsWith("wbv: ") && run.err().contains(said), run.err());
        assertEquals("", run.out());
        assertFalse(Files.exists(out), "something was left behind");
        try (Stream<Path> left = Files.list(folder)) {
            assertEquals(0, left.filter(path -> path.getFileName().toString().startsWith(".")).count());
        }
    }

    private static String given() {
        return CASE.resolve("model.json").toString();
    }

    /** The vertical channels of the recording, those of some places changed. */
    private Path changed(Map<String, DoubleUnaryOperator> change) throws IOException {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        for (String place : List.of("platform", "seat", "sternum", "head")) {
            Channel channel = Channel.parse(place + ".acc.z");
            values.put(channel, Arrays.stream(whole.values(channel)).map(change.getOrDefault(place, x -> x)).toArray());
        }
        return written(new Recording(whole.clock(), values, whole.metadata()));
    }

    private static Recording cut(Recording recording, int samples) {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        recording.channels().forEach(channel -> values.put(channel, Arrays.copyOf(recording.values(channel), samples)));
        return new Recording(recording.clock(), values, recording.metadata());
    }

    private Path written(Recording recording) throws IOException {
        Path file = folder.resolve("bad.csv");
        RecordingWriter.write(file, recording);
        return file;
    }
}

package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Files that are damaged at random, always in the same way: whatever stands in them, a command ends soon, in exit code 0 with
 * results that hold numbers, or in 1 with one clean line that names the file, and leaves nothing half-written.
 */
class MutatedInputTest {

    /** Of each kind, at every build; more of them where there is time. */
    private static final int FEW = 12;
    private static final int CASES = 200;
    private static final long SEED = 20_260_921;
    private static final ObjectMapper STRICT = JsonMapper.builder().enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).build();
    private static final Pattern NO_NUMBER = Pattern.compile("(?im)(^|,)\\s*(nan|[+-]?inf(inity)?)\\s*(,|$)");
    private static final Pattern NO_NUMBER_IN_WORDS = Pattern.compile("\\bNaN\\b|\\bInfinity\\b|∞");
    private static final Pattern JAVA = Pattern.compile("java\\.[a-z]|[a-z]Exception|out of bounds|Cannot invoke|: null$|For input string");
    private static final Pattern EMBEDDED = Pattern.compile("<script type=\"application/json\"[^>]*>(.*?)</script>", Pattern.DOTALL);
    private static final Pattern MARKUP = Pattern.compile("(?s)<(script|style).*?</\\1>|<[^>]*>");

    @TempDir
    private static Path shared;

    @TempDir
    private Path room;

    /** A file to damage, and the commands that read it; {@code *} is the damaged file, {@code +} a sound recording. */
    enum Kind {
        CSV("short.csv", "analyze *", "frf *", "exposure * --seat platform", "convert *", "convert * --as-is", "track * --estimator fused",
                "convert * --still 0:1 --free head", "diagnose * --model coermann-1962-1dof",
                "simulate --input * --model coermann-1962-1dof"),
        ARFF("short.arff", "analyze * --json", "frf * --json", "track * --estimator ukf", "convert *",
                "states apply * --model " + "data/none.json"),
        MVNX("body.mvnx", "convert *", "analyze * --input platform.acc.z", "frf * --input platform.acc.z --output head.acc.z"),
        SENSOR("mt.txt", "convert *", "convert * --location mt=head", "analyze * --input mt.acc.x --output mt.acc.z"),
        MAP("map.json", "convert + --map *", "analyze + --map *"),
        MODEL("model.json", "simulate --input + --model *", "frf + --model *"),
        NETWORK("n.safetensors", "net export --model *"),
        KEY("key.sealed", "prove --open ."),
        UFF("r.uff", "convert *", "analyze *", "map *"),
        UNV("r.unv", "convert *", "exposure * --seat platform"),
        MAT("r.mat", "convert *", "analyze *", "map *"),
        HDF5("r.h5", "convert *", "map *"),
        WAV("r.wav", "convert *", "analyze *", "map *"),
        TABLE("f.csv", "map *"),
        PARQUET("r.parquet", "convert *", "analyze *", "map *");

        private final String file;
        private final List<String> commands;

        Kind(String file, String... commands) {
            this.file = file;
            this.commands = List.of(commands);
        }
    }

    private static final Map<Kind, byte[]> SOUND = new TreeMap<>();

    @BeforeAll
    static void makesSoundFiles() throws IOException {
        Path whole = shared.resolve("whole.csv");
        assertEquals(0, Run.of("simulate", "sitter=one-dof", "seconds=12", "--out", whole.toString()).code());
        List<String> lines = Files.readAllLines(whole);
        Files.write(shared.resolve("short.csv"), lines.subList(0, Math.min(lines.size(), 560)));
        Path arff = shared.resolve("short.arff");
        assertEquals(0, Run.of("convert", shared.resolve("short.csv").toString(), "--out", arff.toString()).code());
        Random noise = new Random(1);
        StringBuilder mvnx = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<mvnx version=\"4\">\n<subject label=\"S\" "
                + "frameRate=\"60\"><segments><segment label=\"Platform\" id=\"1\"/><segment label=\"Head\" "
                + "id=\"2\"/></segments><frames>\n");
        StringBuilder sensor = new StringBuilder("// Update Rate: 60.0Hz\nPacketCounter,Acc_X,Acc_Y,Acc_Z,Gyr_X,Gyr_Y,Gyr_Z\n");
        StringBuilder foreign = new StringBuilder("t_ms,Az,head_az\n");
        for (int i = 0; i < 300; i++) {
            mvnx.append("<frame index=\"").append(i).append("\" time=\"").append(17 * i).append("\" type=\"normal\"><acceleration>");
            sensor.append(100 + i);
            for (int j = 0; j < 6; j++) {
                mvnx.append(noise.nextGaussian()).append(' ');
                sensor.append(',').append(noise.nextGaussian());
            }
            mvnx.append("</acceleration></frame>\n");
            sensor.append('\n');
            foreign.append(1000 + i * 50 / 3.0).append(',').append(noise.nextGaussian()).append(',').append(noise.nextGaussian())
                    .append('\n');
        }
        Files.writeString(shared.resolve("foreign.csv"), foreign);
        for (Kind kind : List.of(Kind.UFF, Kind.UNV, Kind.MAT, Kind.WAV, Kind.PARQUET)) {
            Path file = shared.resolve(kind.file);
            assertEquals(0, Run.of("convert", shared.resolve("short.csv").toString(), "--out", file.toString()).code());
            SOUND.put(kind, Files.readAllBytes(file));
        }
        SOUND.put(Kind.HDF5, Files.readAllBytes(Path.of("src/test/resources/signals/h5py.h5")));
        SOUND.put(Kind.TABLE, bytes(foreign.toString()));
        Map<Kind, byte[]> made = Map.of(Kind.CSV, Files.readAllBytes(shared.resolve("short.csv")), Kind.ARFF, Files.readAllBytes(arff),
                Kind.MVNX, bytes(mvnx + "</frames></subject></mvnx>\n"), Kind.SENSOR, bytes(sensor.toString()),
                Kind.MAP,
                bytes("{\"time\": {\"column\": \"t_ms\", \"unit\": \"ms\", \"from_zero\": true}, \"channels\": {\"platform.acc.z\": "
                        + "{\"column\": \"Az\", \"unit\": \"g\", \"scale\": -1}}, \"patterns\": [{\"column\": \"{location}_a{axis}\", "
                        + "\"channel\": \"{location}.acc.{axis}\", \"unit\": \"m/s2\"}]}"),
                Kind.MODEL, Files.readAllBytes(Path.of("data/arff/concealed/003/model.json")),
                Kind.NETWORK, MutatedInputTest.class.getResourceAsStream("/wbv/network/pooled-1-dof.safetensors").readAllBytes(),
                Kind.KEY, Files.readAllBytes(Path.of("data/arff/concealed/003/key.sealed")));
        SOUND.putAll(made);
    }

    @AfterAll
    static void forgets() {
        SOUND.clear();
    }

    /** The limit is for what would never end, not for speed. */
    @ParameterizedTest
    @EnumSource(Kind.class)
    @Timeout(value = 20, unit = TimeUnit.MINUTES, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void damagedFilesEndInResultsOrInOneCleanLine(Kind kind) throws IOException {
        damaged(kind, 0, FEW);
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource(Kind.class)
    @Timeout(value = 20, unit = TimeUnit.MINUTES, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void manyMoreDamagedFilesDo(Kind kind) throws IOException {
        damaged(kind, FEW, CASES);
    }

    private void damaged(Kind kind, int from, int to) throws IOException {
        for (int number = from; number < to; number++) {
            Random random = new Random(SEED + 1000L * kind.ordinal() + number);
            clear();
            Path file = room.resolve(kind.file);
            Files.write(file, new Damage(random).of(SOUND.get(kind)));
            if (kind == Kind.MAP) {
                Files.copy(shared.resolve("foreign.csv"), room.resolve("sound.csv"), StandardCopyOption.REPLACE_EXISTING);
            } else if (kind == Kind.MODEL) {
                Files.copy(shared.resolve("short.csv"), room.resolve("sound.csv"), StandardCopyOption.REPLACE_EXISTING);
            }
            String command = kind.commands.get(random.nextInt(kind.commands.size()));
            judge(kind + " " + number + ": wbv " + command, command, file);
        }
    }

    private void judge(String name, String command, Path file) throws IOException {
        List<String> words = new ArrayList<>();
        for (String word : command.split(" ")) {
            words.add(switch (word) {
                case "*" -> file.toString();
                case "+" -> room.resolve("sound.csv").toString();
                case "." -> room.toString();
                default -> word;
            });
        }
        List<Path> before = files();
        if (!command.startsWith("prove")) {
            words.addAll(List.of("--out", room.resolve(command.startsWith("convert") || command.startsWith("simulate") ? "o.csv"
                    : command.startsWith("map") ? "o.json" : command.startsWith("net") ? "o.onnx" : "o").toString()));
        }
        Run run = Run.of(words.toArray(String[]::new));
        List<Path> made = files();
        made.removeAll(before);
        String said = name + "\n" + run.err();
        assertTrue(run.code() == 0 || run.code() == 1, said);
        if (run.code() == 1) {
            List<String> lines = run.err().lines().filter(line -> !line.matches("(NOTE|WARNING|FAULT): .*")).toList();
            assertEquals(1, lines.size(), said);
            String line = lines.get(0);
            assertTrue(line.chars().noneMatch(Character::isISOControl), said);
            assertTrue(line.length() <= 2000, said);
            assertFalse(JAVA.matcher(line).find(), said);
            assertTrue(before.stream().anyMatch(each -> line.contains(each.getFileName().toString())) || line.contains("none.json"), said);
            assertEquals(List.of(), made, said);
            return;
        }
        assertFalse(!run.out().startsWith("{") && NO_NUMBER_IN_WORDS.matcher(run.out()).find(), name + "\n" + run.out());
        for (Path each : made) {
            results(name, each);
        }
    }

    private static void results(String name, Path result) throws IOException {
        String plain = result.getFileName().toString();
        assertFalse(plain.startsWith(".") || plain.endsWith(".part"), name + " left " + plain);
        String text = plain.matches(".*\\.(json|csv|arff|html)") ? Files.readString(result) : "";
        if (plain.endsWith(".json")) {
            Assertions.assertDoesNotThrow(() -> STRICT.readTree(text), name);
        } else if (plain.endsWith(".html")) {
            for (Matcher script = EMBEDDED.matcher(text); script.find();) {
                Assertions.assertDoesNotThrow(() -> STRICT.readTree(script.group(1)), name);
            }
            assertFalse(NO_NUMBER_IN_WORDS.matcher(MARKUP.matcher(text).replaceAll(" ")).find(), name);
        } else {
            assertFalse(NO_NUMBER.matcher(text).find(), name + " wrote no number into " + plain);
        }
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> walk = Files.walk(room)) {
            return new ArrayList<>(walk.filter(Files::isRegularFile).toList());
        }
    }

    private void clear() throws IOException {
        try (Stream<Path> walk = Files.walk(room)) {
            walk.filter(path -> !path.equals(room)).sorted(Comparator.reverseOrder()).forEach(path -> path.toFile().delete());
        }
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** One to three kinds of damage to a file, from a random source. */
    private record Damage(Random random) {

        private static final List<String> WORDS = List.of("", "0", "-0", "1e300", "-1e300", "1e-300", "4.9e-324", "1e999", "NaN",
                "Infinity",
                "1.6e17", "2147483648", "-1", "null", "true", "{}", "[]", "\"", "'", "\0", "\t", "\u001b[31m", "\u2028", "ä", "</script>",
                "a.b.c", "x".repeat(5000), " ".repeat(5000), "[".repeat(2000), "head.acc.z", "1;2", "0x10", "1_000", "٣");
        private static final Pattern TOKEN = Pattern.compile("[A-Za-z0-9_.+-]++");

        byte[] of(byte[] sound) {
            byte[] bytes = sound;
            for (int left = 1 + random.nextInt(3); left > 0; left--) {
                bytes = switch (random.nextInt(6)) {
                    case 0 -> bits(bytes);
                    case 1 -> cut(bytes);
                    case 2 -> column(bytes);
                    case 3 -> lines(bytes);
                    default -> token(bytes);
                };
            }
            return bytes;
        }

        private byte[] bits(byte[] bytes) {
            byte[] out = bytes.clone();
            for (int i = 0; i < 1 + random.nextInt(8) && out.length > 0; i++) {
                out[random.nextInt(random.nextBoolean() ? out.length : Math.min(out.length, 400))] ^= (byte) (1 << random.nextInt(8));
            }
            return out;
        }

        private byte[] cut(byte[] bytes) {
            int from = random.nextInt(bytes.length + 1);
            int to = random.nextBoolean() ? bytes.length : Math.min(bytes.length, from + random.nextInt(200));
            byte[] out = java.util.Arrays.copyOf(bytes, bytes.length - (to - from));
            System.arraycopy(bytes, to, out, from, bytes.length - to);
            return out;
        }

        /** One token, which is a number, a name or a key, becomes another word. */
        private byte[] token(byte[] bytes) {
            String text = new String(bytes, StandardCharsets.ISO_8859_1);
            Matcher found = TOKEN.matcher(text);
            int start = random.nextInt(random.nextBoolean() ? text.length() + 1 : Math.min(text.length(), 2000) + 1);
            String word = new String(bytes(WORDS.get(random.nextInt(WORDS.size()))), StandardCharsets.ISO_8859_1);
            return found.find(start)
                    ? (text.substring(0, found.start()) + word + text.substring(found.end())).getBytes(StandardCharsets.ISO_8859_1)
                    : bytes;
        }

        /** One column of a table, from some row on. */
        private byte[] column(byte[] bytes) {
            String[] lines = new String(bytes, StandardCharsets.ISO_8859_1).split("\n", -1);
            int from = random.nextInt(lines.length);
            int column = random.nextInt(3);
            double factor = List.of(0.0, 1e-300, 1e-160, 1e-9, -1.0, 1e6, 1e15, 1e300).get(random.nextInt(8));
            for (int i = from; i < lines.length; i++) {
                String[] cells = lines[i].split(",", -1);
                if (column < cells.length && cells[column].matches("-?[0-9.]+([eE]-?[0-9]+)?")) {
                    cells[column] = Double.toString(Double.parseDouble(cells[column]) * factor);
                    lines[i] = String.join(",", cells);
                }
            }
            return String.join("\n", lines).getBytes(StandardCharsets.ISO_8859_1);
        }

        /** Lines lost, doubled, or in another order. */
        private byte[] lines(byte[] bytes) {
            List<String> lines = new ArrayList<>(List.of(new String(bytes, StandardCharsets.ISO_8859_1).split("\n", -1)));
            int from = random.nextInt(lines.size());
            int to = Math.min(lines.size(), from + 1 + random.nextInt(100));
            List<String> some = new ArrayList<>(lines.subList(from, to));
            switch (random.nextInt(3)) {
                case 0 -> lines.subList(from, to).clear();
                case 1 -> lines.addAll(random.nextInt(lines.size()), some);
                default -> java.util.Collections.shuffle(lines.subList(from, to), random);
            }
            return String.join("\n", lines).getBytes(StandardCharsets.ISO_8859_1);
        }
    }
}

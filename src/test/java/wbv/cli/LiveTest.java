package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code wbv live} as a command: what it prints beside what {@code track} and {@code exposure} find in the same recording. */
class LiveTest {

    private static final String LINEAR = "data/arff/one-dof-linear.arff";

    @TempDir
    private Path folder;

    @Test
    void standardInputGivesTheDigitsOfTrack() throws IOException {
        Run run = Run.with(Files.newInputStream(Path.of(LINEAR)), "live", "-");
        assertEquals(0, run.code(), run.err());
        assertEquals("", run.err());
        List<String> lines = run.out().lines().toList();
        assertTrue(lines.get(0).startsWith("{\"type\":\"begin\",\"source\":\"standard input\""), lines.get(0));
        assertTrue(lines.get(lines.size() - 1).startsWith("{\"type\":\"end\""), lines.get(lines.size() - 1));
        JsonNode result = lines.stream().filter(line -> line.contains("\"type\":\"result\"")).reduce((first, second) -> second)
                .map(line -> {
                    try {
                        return new ObjectMapper().readTree(line);
                    } catch (IOException wrong) {
                        throw new AssertionError(line, wrong);
                    }
                }).orElseThrow();
        Path out = folder.resolve("out");
        assertEquals(0, Run.of("track", LINEAR, "--estimator", "ekf-adwin", "--out", out.toString()).code());
        List<String> tracks = Files.readAllLines(out.resolve("tracks.csv"));
        String[] last = tracks.get(tracks.size() - 1).split(",");
        assertEquals(Double.parseDouble(last[0]), result.get("t_s").asDouble(), 1e-6);
        JsonNode mode = result.get("bodies").get(0).get("modes").get(0);
        List<String> names = List.of("natural_frequency_hz", "natural_frequency_deviation_hz", "damping_ratio", "damping_ratio_deviation");
        for (int i = 0; i < names.size(); i++) {
            double written = Double.parseDouble(last[1 + i]);
            String decimals = last[1 + i].substring(last[1 + i].indexOf('.') + 1);
            assertEquals(written, mode.get(names.get(i)).asDouble(), 0.51 * Math.pow(10, -decimals.length()), names.get(i));
        }
    }

    @Test
    void linesThatCannotBeReadArePutAsideAndTheCommandGoesOn() throws IOException {
        StringBuilder rows = new StringBuilder("t,seat.acc.z,head.acc.z\n");
        for (int i = 0; i < 300; i++) {
            rows.append(i / 60.0).append(',').append(Math.sin(i)).append(',').append(Math.cos(1.1 * i))
                    .append(i == 100 ? "\noops\n" : "\n");
        }
        Path aside = folder.resolve("aside.txt");
        Run run = Run.with(new ByteArrayInputStream(rows.toString().getBytes(StandardCharsets.UTF_8)), "live", "-", "--aside",
                aside.toString(), "--state", folder.resolve("state").toString());
        assertEquals(0, run.code(), run.err());
        assertEquals("oops\n", Files.readString(aside));
        assertTrue(run.out().contains("standard input:103: ") && run.out().contains("\"unreadable\":1"), run.out());
        assertTrue(Files.exists(folder.resolve("state/state-2.bin")), "kept");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"'' | is empty", "t,seat.acc.z | no row of samples is among its 1 line"})
    void aStreamThatEndsWithoutARowIsToldSo(String text, String said) throws IOException {
        Path file = Files.writeString(folder.resolve("rows.csv"), text);
        Run run = Run.of("live", file.toString());
        assertEquals(1, run.code(), run.err());
        assertTrue(run.err().startsWith("wbv: " + file + ": " + said), run.err());
    }

    @Test
    void whereNobodyReadsTheLinesTheStreamEnds() {
        Run run = Run.into(new OutputStream() {
            @Override
            public void write(int one) throws IOException {
                throw new IOException("gone");
            }
        }, "live", LINEAR);
        assertEquals(1, run.code(), run.err());
        assertEquals("wbv: standard output: cannot be written; is its disk full, or its reader gone?", run.err().strip());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|',
            value = {"live|2|say where samples come from", "live nothing.csv|1|there is no such file", "live . |1|is a folder",
                "live - --pace 0|2|--pace must be > 0", "live --udp 70000|2|--udp must be 0 to 65535", "live - --every 0|2|--every must be",
                "live - --estimator none|2|--estimator must be one of", "live - --seat Seat|2|--seat names a place",
                "live --mqtt nonsense|1|no address of a broker",
                "live - --rate 0|2|--rate must be", "live - --seats 0|2|--seats must be", "live - --states nothing.json|1|nothing.json"})
    void whatIsWrongIsSaidInOneLine(String command, int code, String said) {
        Run run = Run.of(command.strip().split(" "));
        assertEquals(code, run.code(), run.err());
        assertTrue(run.err().startsWith("wbv: ") && run.err().contains(said), run.err());
    }
}

package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code prediction.csv} holds what the reported errors are errors of. */
class PredictionTest {

    private static final Path CASE = Path.of("data/arff/concealed/003");

    @TempDir
    private Path folder;

    @Tag("slow")
    @Test
    void theReportedErrorsFollowFromIt() throws IOException {
        String recording = CASE.resolve("recording.csv.gz").toString();
        Path out = folder.resolve("out");
        Run run = Run.of("diagnose", recording, "--model", CASE.resolve("model.json").toString(), "--out", out.toString());
        assertEquals(0, run.code(), run.err());
        Table table = Table.of(out.resolve("prediction.csv"));
        JsonNode fit = new ObjectMapper().readTree(out.resolve("diagnosis.json").toFile()).get("fit");
        List<String> channels = List.of("seat.acc.z", "sternum.acc.z", "head.acc.z").stream().filter(fit.get("heldout_nrmse_after")::has)
                .toList();
        assertTrue(!channels.isEmpty(), run.out());
        for (String channel : channels) {
            double claimed = fit.get("heldout_nrmse_after").get(channel).asDouble();
            assertEquals(claimed, table.error(channel), 1e-6 * claimed, channel);
            assertTrue(table.error(channel + " model") > claimed, "the sensors' errors are a part of what is claimed");
        }
        assertTrue(Files.readString(out.resolve("prediction.csv")).startsWith("t,"), "a table that anything reads begins with its names");
        // What was found is one law in one link; its force is that of the written model.
        Table force = Table.of(out.resolve("force.csv"));
        assertEquals(List.of("t", "platform-pelvis"), force.head());
        assertTrue(force.cells().stream().mapToDouble(row -> Math.abs(Double.parseDouble(row[1]))).max().orElse(0) > 1);
        Path simulated = folder.resolve("simulated.csv");
        assertEquals(0,
                Run.of("simulate", "--model", out.resolve("model.json").toString(), "--input", recording, "--out", simulated.toString())
                        .code());
        Table whole = Table.of(simulated);
        for (int row = 0; row < table.rows(); row++) {
            String time = table.text("t", row);
            for (String channel : channels) {
                assertEquals(whole.text(channel, whole.row(time)), table.text(channel + " model", row), channel + " at " + time);
            }
        }
    }

    /** Cells as text. @param at row of a time */
    private record Table(List<String> head, List<String[]> cells, Map<String, Integer> at) {

        static Table of(Path file) throws IOException {
            List<String> lines = Files.readAllLines(file).stream().filter(line -> !line.startsWith("#")).toList();
            List<String[]> cells = lines.subList(1, lines.size()).stream().map(line -> line.split(",", -1)).toList();
            Map<String, Integer> at = new HashMap<>();
            for (int i = 0; i < cells.size(); i++) {
                at.put(cells.get(i)[0], i);
            }
            return new Table(List.of(lines.get(0).split(",")), cells, at);
        }

        int rows() {
            return cells.size();
        }

        int row(String time) {
            return at.get(time);
        }

        String text(String column, int row) {
            return cells.get(row)[head.indexOf(column)];
        }

        /** Root mean square of what was recorded less a column, over that of what was recorded. */
        double error(String column) {
            String recorded = column.replace(" model", "") + " recorded";
            double error = 0;
            double signal = 0;
            for (int row = 0; row < rows(); row++) {
                if (!text(recorded, row).isEmpty()) {
                    double x = Double.parseDouble(text(recorded, row));
                    error += Math.pow(x - Double.parseDouble(text(column, row)), 2);
                    signal += x * x;
                }
            }
            return Math.sqrt(error / signal);
        }
    }
}

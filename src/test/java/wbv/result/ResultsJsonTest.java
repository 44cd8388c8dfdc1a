package wbv.result;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.recording.DataFault;

class ResultsJsonTest {

    private record Results(String zeta, double alpha, Optional<String> none, OptionalDouble rate, double[] track,
            Map<String, Double> means) {}

    @Test
    void everyKindOfValueHasItsOneForm() throws IOException {
        Results results = new Results("é \"<&", Double.NaN, Optional.empty(), OptionalDouble.of(60),
                new double[] {0.1, Double.NEGATIVE_INFINITY}, Map.of("z", 2.0, "a", Double.NaN));
        assertEquals("""
                {
                  "zeta" : "é \\"<&",
                  "alpha" : null,
                  "none" : null,
                  "rate" : 60.0,
                  "track" : [ 0.1, null ],
                  "means" : {
                    "a" : null,
                    "z" : 2.0
                  }
                }
                """, ResultsJson.render(results));
    }

    @Test
    void doublesReadBackEqual() throws IOException {
        Random random = new Random(1);
        double[] values = random.longs(2000).mapToDouble(Double::longBitsToDouble).filter(Double::isFinite).toArray();
        JsonNode json = new ObjectMapper().readTree(ResultsJson.render(List.of(values, Math.PI)));
        for (int i = 0; i < values.length; i++) {
            assertEquals(values[i], json.get(0).get(i).asDouble());
        }
        assertEquals(Math.PI, json.get(1).asDouble());
    }

    @Test
    void mapsAreWrittenInTheOrderOfTheirKeysHoweverTheyWereFilled() throws IOException {
        Map<String, Integer> up = new HashMap<>();
        Map<String, Integer> down = new HashMap<>(512);
        for (int i = 0; i < 100; i++) {
            up.put("key" + i, i);
            down.put("key" + (99 - i), 99 - i);
        }
        assertEquals(ResultsJson.render(up), ResultsJson.render(down));
    }

    @Test
    void aFileIsReplacedWhole(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("results.json");
        Files.writeString(file, "something much longer than the results that will replace it");
        ResultsJson.write(Map.of("a", 1), file);
        assertEquals(ResultsJson.render(Map.of("a", 1)), Files.readString(file));
        assertEquals(1, folder.toFile().list().length, "nothing else is left");
    }

    @Test
    void whatCannotBeWrittenLeavesNothing(@TempDir Path folder) throws IOException {
        assertThrows(DataFault.class, () -> ResultsJson.write(1, folder.resolve("missing/results.json")));
        assertThrows(IOException.class, () -> ResultsJson.write(new Object(), folder.resolve("results.json")));
        assertTrue(folder.toFile().list().length == 0);
    }
}

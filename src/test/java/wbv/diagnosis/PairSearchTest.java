package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.ModelFile;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** Two things are missing at two places: both are named, and nothing beside them. */
class PairSearchTest {

    @TempDir
    private Path folder;

    @Test
    void bothAreNamed() throws Exception {
        bothAreNamed(folder, List.of("damping.quadratic", "sensor.mount"), 1);
    }

    static void bothAreNamed(Path folder, List<String> words, long seed) throws Exception {
        allIsNamed(folder, new ConcealedSpec("pair", words, 1, Setting.RIG, false, seed));
    }

    /** What is concealed is named where it is, and nothing beside it. */
    static void allIsNamed(Path folder, ConcealedSpec spec) throws Exception {
        ConcealedCase made = Concealer.make(spec);
        Path model = Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8);
        Diagnosis diagnosis = Diagnoser.diagnose(ModelFile.read(model), made.recording(), (step, share) -> { });
        Set<String> truth = new TreeSet<>();
        for (JsonNode each : new ObjectMapper().readTree(made.key()).path("mechanisms")) {
            truth.add(each.path("mechanism").asText() + " at " + each.path("where").asText());
        }
        assertEquals(truth, diagnosis.missing().stream().map(found -> found.mechanism() + " at " + found.where())
                .collect(Collectors.toCollection(TreeSet::new)), diagnosis.sentence());
    }
}

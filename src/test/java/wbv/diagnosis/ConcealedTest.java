package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.ModelFile;
import wbv.proof.SealedCase;
import wbv.recording.format.RecordingFile;

/** The ten recordings that ship with an effect concealed by another engine; the keys are opened after the diagnosis. */
class ConcealedTest {

    private static final Path FOLDER = Path.of("data/arff/concealed");

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"001", "002", "003", "004", "005", "006", "007", "008", "009", "010"})
    void theConcealedEffectIsNamedAndNothingElse(String name) throws IOException {
        Path folder = FOLDER.resolve(name);
        Diagnosis diagnosis = Diagnoser.diagnose(ModelFile.read(folder.resolve("model.json")),
                new RecordingFile(folder.resolve("recording.csv.gz")).load(), (step, share) -> {});
        JsonNode concealed = new ObjectMapper().readTree(SealedCase.open(folder)).get("mechanisms").get(0);
        String mechanism = concealed.get("mechanism").asText();
        if (mechanism.equals("none") || mechanism.equals("parameters")) {
            assertEquals(mechanism.equals("none") ? Diagnosis.Verdict.NOTHING_MISSING : Diagnosis.Verdict.PARAMETERS_ONLY,
                    diagnosis.verdict(), diagnosis.sentence());
            assertTrue(diagnosis.missing().isEmpty(), diagnosis.sentence());
        } else {
            assertEquals(1, diagnosis.missing().size(), diagnosis.sentence());
            assertEquals(mechanism, diagnosis.missing().get(0).mechanism(), diagnosis.sentence());
            assertEquals(concealed.get("where").asText(), diagnosis.missing().get(0).where(), diagnosis.sentence());
            double named = diagnosis.missing().get(0).probability();
            assertTrue(named > 0.7, diagnosis.sentence());
            diagnosis.alternatives().forEach(rival -> assertTrue(rival.probability() <= named, rival + " is likelier than what was named"));
        }
        // Beside what sensor noise leaves, a law's form and second-order motion may leave a little.
        diagnosis.fit().nrmseAfter().forEach((channel, after) -> assertTrue(after < 1.8 * diagnosis.fit().nrmseFloor().get(channel),
                channel + ": " + after + ", floor " + diagnosis.fit().nrmseFloor().get(channel)));
    }
}

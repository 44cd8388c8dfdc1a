package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.ModelFile;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** Dry friction and a spring that yields look alike; sliders and bristles that are not the library's are told apart. */
class YieldingTest {

    @TempDir
    private Path folder;

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"hysteresis", "friction.coulomb"})
    void frictionAndHysteresisAreToldApart(String mechanism) throws Exception {
        ConcealedCase made = Concealer.make(new ConcealedSpec("yielding", List.of(mechanism), 1, Setting.FIELD, false, 1));
        Path model = Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8);
        Diagnosis diagnosis = Diagnoser.diagnose(ModelFile.read(model), made.recording(), (step, share) -> {});
        assertEquals(mechanism, diagnosis.missing().get(0).mechanism(), diagnosis.sentence() + diagnosis.alternatives());
        // Over one road the two are close relatives: one is held plainly, if not always alone.
        assertTrue(
                diagnosis.missing().get(0).probability() > 0.8
                        && diagnosis.alternatives().stream().allMatch(rival -> rival.probability() < 0.1),
                diagnosis.sentence() + diagnosis.alternatives());
    }
}

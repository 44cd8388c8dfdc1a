package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.ModelFile;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.Interval;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** A sensor late by half a sample, which is no more than several sensors scatter by together, and five times as much as one does. */
class OddSensorTest {

    @TempDir
    private Path folder;

    private Diagnosis diagnosed(List<String> words, long seed) throws Exception {
        ConcealedCase made = Concealer.make(new ConcealedSpec("late", words, 0.1, Setting.RIG, false, seed));
        Path model = Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8);
        return Diagnoser.diagnose(ModelFile.read(model), made.recording(), (step, share) -> {});
    }

    @Tag("slow")
    @Test
    void theOneThatIsLateIsBlamed() throws Exception {
        Diagnosis diagnosis = diagnosed(List.of("sensor.delay"), 5208654190441538260L);
        assertEquals(List.of("sensor.delay at head.acc.z"),
                diagnosis.missing().stream().map(n -> n.mechanism() + " at " + n.where()).toList(), diagnosis.sentence());
        // Its own scatter of a tenth of a sample comes on top of what was concealed.
        assertEquals(0.00794, diagnosis.missing().get(0).parameters().get("delay_s"), 0.0025);
        Interval delay = diagnosis.missing().get(0).intervals().get("delay_s");
        assertTrue(0.001 < delay.low() && delay.low() < 0.00794 && 0.00794 < delay.high(), diagnosis.sentence());
    }

    @Tag("slow")
    @Test
    void scatterIsNot() throws Exception {
        for (long seed = 1; seed <= 3; seed++) {
            Diagnosis diagnosis = diagnosed(List.of(), seed);
            assertEquals(List.of(), diagnosis.missing(), diagnosis.sentence());
        }
    }
}

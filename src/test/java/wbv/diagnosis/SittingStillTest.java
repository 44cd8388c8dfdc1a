package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.ModelFile;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** A person on the road who does nothing but sit still, of whom the model's values are off: by himself, and beside a law of little. */
@Tag("slow")
class SittingStillTest {

    private static Diagnosis diagnosis(List<String> words, double strength, long seed, Set<String> steps) {
        ConcealedCase made = Concealer.make(new ConcealedSpec("still", words, strength, Setting.FIELD, false, seed));
        return Diagnoser.diagnose(ModelFile.parse(made.model(), "model.json"), made.recording(), (step, share) -> steps.add(step));
    }

    @ParameterizedTest
    @ValueSource(longs = {61, 63})
    void byHimselfHeIsToldWithoutASearch(long seed) {
        Set<String> steps = new HashSet<>();
        Diagnosis diagnosis = diagnosis(List.of(), 1, seed, steps);
        assertTrue(diagnosis.verdict().isQuiet(), diagnosis.sentence());
        assertFalse(steps.contains("refitting"), steps.toString());
    }

    @Test
    void aLawThatDoesLittleIsNamedBesideHim() {
        Diagnosis diagnosis = diagnosis(List.of("contact.loss"), 0.3, 67, new HashSet<>());
        assertEquals(List.of("contact.loss"), diagnosis.missing().stream().map(Diagnosis.Named::mechanism).toList(),
                diagnosis.sentence());
    }
}

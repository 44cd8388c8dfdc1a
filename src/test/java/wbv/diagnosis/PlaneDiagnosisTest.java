package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** People of rigid bodies in a plane, integrated with whole angles by another program, with their joints as the model. */
class PlaneDiagnosisTest {

    private static ConcealedCase concealed(List<String> words, boolean exact, long seed) {
        return Concealer.make(new ConcealedSpec("plane", words, 1, Setting.JOINTED, exact, seed));
    }

    private static Diagnosis diagnosed(ConcealedCase made) {
        return Diagnoser.diagnose(ModelFile.parse(made.model(), "model.json"), made.recording(), (step, share) -> {});
    }

    @Tag("slow")
    @Test
    void nothingIsMissingWhereOnlyValuesAreOff() {
        isQuiet(71);
    }

    @ParameterizedTest
    @ValueSource(longs = {72, 73, 78})
    @Tag("exam")
    void norOfOthers(long seed) {
        isQuiet(seed);
    }

    private static void isQuiet(long seed) {
        Diagnosis diagnosis = diagnosed(concealed(List.of(), false, seed));
        assertEquals(Diagnosis.Verdict.PARAMETERS_ONLY, diagnosis.verdict(), diagnosis.sentence());
        // Beside what sensor noise leaves, the person's own force leaves a little.
        diagnosis.fit().nrmseAfter().forEach((channel, after) -> assertTrue(after < 1.8 * diagnosis.fit().nrmseFloor().get(channel),
                channel + ": " + after + ", floor " + diagnosis.fit().nrmseFloor().get(channel)));
    }

    @ParameterizedTest
    @CsvSource({"contact.bumpstop, 74", "stiffness.hardening, 75"})
    @Tag("exam")
    void whatIsConcealedInAJointIsNamedThere(String word, long seed) throws Exception {
        ConcealedCase made = concealed(List.of(word), false, seed);
        Diagnosis diagnosis = diagnosed(made);
        assertFalse(diagnosis.missing().isEmpty(), diagnosis.sentence());
        assertEquals(word, diagnosis.missing().get(0).mechanism(), diagnosis.sentence());
        assertTrue(made.key().contains("\"" + diagnosis.missing().get(0).where() + "\""), made.key());
    }

    /** A head that its damping brakes so much that it mostly moves below the speed at which that becomes quadratic. */
    @Test
    @Tag("exam")
    void whereTheFormIsNotTheLibrarysTheNearestNameIsTold() {
        Diagnosis diagnosis = diagnosed(concealed(List.of("damping.quadratic"), false, 76));
        assertEquals(Diagnosis.Verdict.LEARNED_LAW, diagnosis.verdict(), diagnosis.sentence());
        String neck = "sternum.pitch-head.pitch";
        assertEquals(neck, diagnosis.missing().get(0).where(), diagnosis.sentence());
        assertTrue(diagnosis.sentence().contains("Nearest in the library: The damping of " + neck + " grows with speed"),
                diagnosis.sentence());
    }

    @Test
    void aModelOfJointsIsOneOfSeveralAxes() {
        Model model = ModelFile.parse(concealed(List.of(), true, 77).model(), "model.json");
        assertEquals(3, model.base().sensors().size());
        assertFalse(model.isAlongOneAxis());
        assertEquals(9, model.bodies().size());
        // The masses of three bodies: what only turns weighs nothing, and what moves two ways weighs once.
        assertEquals(model.bodies().stream().filter(body -> body.name().endsWith(".x")).mapToDouble(Model.Body::mass).sum(), model.mass(),
                1e-9);
    }
}

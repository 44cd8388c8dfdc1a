package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.ModelFile;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** What a model that went far to make up for something leads away from is found all the same. */
class SearchTest {

    @TempDir
    private Path folder;

    private record Asked(Evidence evidence, Candidate baseline, Fitter.State base, String place) {

        static Asked of(Evidence evidence, String place) {
            Candidate baseline = Baseline.of(evidence);
            return new Asked(evidence, baseline, search(evidence).base(baseline), place);
        }

        Whereabouts where() {
            return Whereabouts.found(evidence, base);
        }

        List<Fitter.State> leaders() {
            return search(evidence).leaders(base, Effort.LEADERS, where());
        }

        /** Knowing what the person does who sits there. */
        Asked knowing() {
            return of(evidence.with(where().ownForce().orElseThrow()), place);
        }

        private static Search search(Evidence evidence) {
            return new Search(evidence, (step, share) -> {});
        }
    }

    private Asked asked(String mechanism, long seed) throws Exception {
        return asked(mechanism, 1, seed);
    }

    private Asked asked(String mechanism, double strength, long seed) throws Exception {
        ConcealedCase made = Concealer.make(new ConcealedSpec("search", List.of(mechanism), strength, Setting.RIG, false, seed));
        Path model = Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8);
        JsonNode key = new ObjectMapper().readTree(made.key());
        return Asked.of(new Evidence(ModelFile.read(model), made.recording()), key.path("mechanisms").path(0).path("where").asText());
    }

    /** A step shows in no part before or after it: there other numbers of the model explain all, and so does whatever comes with them. */
    @Tag("slow")
    @Test
    void aStepIsNotLookedForInAPart() throws Exception {
        Asked asked = asked("drift.step", 6227120087486066153L).knowing();
        assertTrue(Refinement.bent(asked.base()), "the model alone has to have gone far");
        assertFalse(asked.where().inPart(), "the part would show every place as good as any");
        Fitter.State first = asked.leaders().get(0);
        assertEquals("drift.step at " + asked.place(), first.candidate().last().mechanism() + " at " + first.candidate().last().where(),
                "leaves " + first.reduced());
    }

    /** An arm of three times the link's stiffness is far from numbers that did without it; few steps there are not enough to tell. */
    @Tag("slow")
    @Test
    void aStiffArmIsReachedFromUnbentNumbers() throws Exception {
        Asked asked = asked("memory.viscoelastic", 7810180427033834115L);
        assertTrue(Refinement.bent(asked.base()), "the model alone has to have gone far");
        Fitter.State arm = asked.leaders().stream().filter(fit -> fit.candidate().last().mechanism().equals("memory.viscoelastic")
                && fit.candidate().last().where().equals(asked.place())).findFirst().orElseThrow();
        assertTrue(Refinement.explained(asked.base(), arm) > Priors.NEARLY_ALL, "leaves " + arm.reduced());
    }

    /**
     * A reflex as late as the head swings, with a negative stiffness, does what an inerter does, and more of it as a bent model moves;
     * along the measured motion the inerter takes as much, and has farther to go from there.
     */
    @Tag("slow")
    @Test
    void whatImitatesALawDoesNotHideIt() throws Exception {
        Asked asked = asked("open.inerter", 0.3, 5367254090399903269L);
        assertEquals("learned at " + asked.place(),
                first(Asked.search(asked.evidence()).linear(asked.base(), Effort.LEADERS, Priors.MAJORITY)));
        assertEquals("learned at " + asked.place(), first(asked.knowing().leaders()));
    }

    private static String first(List<Fitter.State> fits) {
        return fits.get(0).candidate().last().mechanism() + " at " + fits.get(0).candidate().last().where();
    }
}

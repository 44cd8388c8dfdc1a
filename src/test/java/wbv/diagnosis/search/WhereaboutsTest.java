package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.BodyForce;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.FittedScene;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Library;
import wbv.recording.format.RecordingFile;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** Where a mismatch can enter, and how hard a person works who sits there, is known before any mechanism was tried. */
class WhereaboutsTest {

    private static final List<Long> SEEDS = List.of(2L, 5L, 9L);
    private static final Map<String, Asked> ASKED = new HashMap<>();

    @TempDir
    private Path folder;

    private record Asked(Evidence evidence, Candidate baseline, Fitter.State base, Whereabouts where, JsonNode key) {

        String place() {
            return key.path("mechanisms").path(0).path("where").asText();
        }
    }

    /** Asked once, though several tests look at the answer. */
    private Asked asked(String mechanism, long seed) throws Exception {
        String question = mechanism + " " + seed;
        if (!ASKED.containsKey(question)) {
            ASKED.put(question, answered(mechanism, seed));
        }
        return ASKED.get(question);
    }

    private Asked answered(String mechanism, long seed) throws Exception {
        ConcealedCase made = Concealer.make(new ConcealedSpec("whereabouts", List.of(mechanism), 1, Setting.RIG, false, seed));
        Model model = ModelFile.read(Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8));
        Evidence evidence = new Evidence(model, made.recording());
        Candidate baseline = Baseline.of(evidence);
        Fitter.State base = new Search(evidence, (step, share) -> {}).base(baseline);
        return new Asked(evidence, baseline, base, Whereabouts.found(evidence, base),
                new ObjectMapper().readTree(made.key()));
    }

    /** Every hypothesis of the library. */
    private static List<Hypothesis> bank(Asked asked) {
        Assembly fitted = asked.baseline().at(asked.base().x());
        return Library.standard().hypotheses(FittedScene.of(asked.evidence(), fitted, Motion.measured(asked.evidence(), fitted)));
    }

    /** A friction of which most of the mismatch comes leaves few places where anything could do the same. */
    @Tag("slow")
    @Test
    void fewPlacesAreLeft() throws Exception {
        Asked asked = asked("friction.coulomb", 2);
        List<Hypothesis> all = bank(asked);
        List<Hypothesis> likely = all.stream().filter(asked.where()::likely).toList();
        assertTrue(likely.stream().anyMatch(h -> h.mechanism().equals("friction.coulomb") && h.where().equals(asked.place())));
        assertTrue(likely.size() < all.size() / 2, likely.size() + " of " + all.size());
    }

    /** Where a sensor errs, and no fault of it explains that, something else near it may; a law in a link may be none of the library's. */
    @Tag("slow")
    @Test
    void whatNoFaultOfASensorExplainsMayComeFromElsewhere() throws Exception {
        Asked late = asked("sensor.delay", 2);
        assertTrue(late.where().besideSensor(0).isEmpty(), "where nothing may be left");
        Whereabouts elsewhere = late.where().besideSensor(late.base().reduced() - 1).orElseThrow();
        List<Hypothesis> likely = bank(late).stream().filter(elsewhere::likely).toList();
        assertFalse(likely.isEmpty());
        assertTrue(likely.stream().noneMatch(h -> late.where().likely(h)), likely.toString());
        Asked friction = asked("friction.coulomb", 2);
        assertTrue(friction.where().besideSensor(friction.base().reduced() - 1).isEmpty());
    }

    /** The force that moves a sitter who sits still: of white noise between half a hertz and five, most shows. */
    @Tag("slow")
    @Test
    void aPersonsOwnForceShowsBesideAMismatch() throws Exception {
        for (long seed : SEEDS) {
            Asked asked = asked("friction.coulomb", seed);
            Optional<BodyForce> force = asked.where().ownForce();
            double truth = asked.key().path("stirring_N").asDouble();
            String found = force.map(it -> it.rms() + " N").orElse("none") + " of " + truth;
            assertTrue(force.isPresent(), found);
            // Where a link of the torso is ignored, a force on its other end is as good as one on the torso.
            String body = asked.evidence().model().bodies().get(force.get().body()).name();
            assertTrue(body.equals("torso") || asked.place().contains("torso") && asked.place().contains(body),
                    body + " of " + asked.place());
            assertTrue(force.get().rms() > truth / 2 && force.get().rms() < 2 * truth, found);
        }
    }

    /** A push that is all there is is not halved into a force of the sitter's own and something that nothing explains. */
    @Tag("exam")
    @Test
    void aPushThatIsAllThereIsIsNamed() throws Exception {
        PairSearchTest.allIsNamed(folder,
                new ConcealedSpec("push", List.of("input.unmeasured"), 0.3, Setting.FIELD, false, 513673977106332782L));
    }

    /** Numbers fitted beside what is missing are nearer to the truth than those that had to make up for it. */
    @Tag("slow")
    @Test
    void numbersAreUnbent() throws Exception {
        double unbentOff = 0;
        double bentOff = 0;
        for (long seed : SEEDS) {
            Asked asked = asked("stiffness.softening", seed);
            Hypothesis there = bank(asked).stream()
                    .filter(h -> h.runsFree() && h.where().equals(asked.place())).findFirst().orElseThrow();
            double[] unbent = asked.where().unbent(there).orElseThrow();
            unbentOff += off(asked, unbent);
            bentOff += off(asked, asked.base().x());
        }
        assertTrue(unbentOff < bentOff / 2, unbentOff + " beside " + bentOff);
    }

    /** How far all other links' stiffness is from the truth, as a sum of squares of logarithms. */
    private static double off(Asked asked, double[] x) {
        JsonNode links = asked.key().path("true_linear_model").path("links");
        double sum = 0;
        for (int link = 0; link < links.size(); link++) {
            String name = links.path(link).path("from").asText() + "-" + links.path(link).path("to").asText();
            if (!name.equals(asked.place())) {
                double value = asked.baseline().at(x).structure().stiffness()[link];
                sum += Math.pow(Math.log(value / links.path(link).path("stiffness_N_per_m").asDouble()), 2);
            }
        }
        return sum;
    }

    @Tag("slow")
    @Test
    void whatNobodyDoesIsNotFound() throws Exception {
        Path shipped = Path.of("data/arff/concealed/003");
        Model model = ModelFile.read(shipped.resolve("model.json"));
        Evidence evidence = new Evidence(model, new RecordingFile(shipped.resolve("recording.csv.gz")).load());
        Candidate baseline = Baseline.of(evidence);
        Fitter.State base = new Search(evidence, (step, share) -> {}).base(baseline);
        assertFalse(Whereabouts.found(evidence, base).ownForce().isPresent());
    }
}

package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.ModelFile;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.FittedScene;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Library;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** A coupling across in a link of which one end carries no sensor, on the road, where the platform pitches as well. */
class SwingTest {

    private static ConcealedCase concealed(long seed) {
        return Concealer.make(new ConcealedSpec("swing", List.of("coupling.axis"), 1, Setting.FIELD, false, seed));
    }

    private static Evidence evidence(ConcealedCase made) {
        return new Evidence(ModelFile.parse(made.model(), "model.json"), made.recording());
    }

    /** Seat, a torso without a sensor, a head: the torso is the upper end of one link and the lower end of the next. */
    @Test
    void theEndWithoutASensorSwings() {
        Evidence evidence = evidence(concealed(857));
        Candidate baseline = Baseline.of(evidence);
        Assembly given = baseline.at(baseline.start());
        List<Hypothesis> all = Library.standard().hypotheses(FittedScene.of(evidence, given, Motion.measured(evidence, given)));
        assertTrue(drive(all, "coupling.axis@seat-torso[x]") instanceof Drive.UpperSwings swings
                && swings.measured().toString().equals("seat.acc.x") && swings.rate().toString().equals("platform.gyr.y"));
        assertTrue(drive(all, "coupling.axis@torso-head[y]") instanceof Drive.LowerSwings swings
                && swings.measured().toString().equals("head.acc.y") && swings.rate().toString().equals("platform.gyr.x"));
        assertTrue(drive(all, "coupling.axis@platform-seat[x]") instanceof Drive.CrossAxis, "both ends carry one");
    }

    /** What two ends do against each other needs no floor that was measured across. */
    @Tag("slow")
    @Test
    void whereBothEndsCarryASensorTheFloorNeedNone() {
        ConcealedCase made = concealed(859);
        Map<Channel, double[]> left = new LinkedHashMap<>();
        made.recording().channels().stream()
                .filter(channel -> !channel.location().equals("platform") || channel.toString().equals("platform.acc.z"))
                .forEach(channel -> left.put(channel, made.recording().values(channel)));
        Recording without = new Recording(made.recording().clock(), left, made.recording().metadata());
        Evidence evidence = new Evidence(ModelFile.parse(made.model(), "model.json"), without);
        Candidate baseline = Baseline.of(evidence);
        Assembly given = baseline.at(baseline.start());
        List<Hypothesis> all = Library.standard().hypotheses(FittedScene.of(evidence, given, Motion.measured(evidence, given)));
        assertTrue(drive(all, "coupling.axis@pelvis-torso[x]") instanceof Drive.CrossAxis);
        assertTrue(all.stream().noneMatch(hypothesis -> hypothesis.name().equals("coupling.axis@platform-pelvis[x]")),
                "the floor's own motion across is not known");
    }

    private static Drive drive(List<Hypothesis> all, String name) {
        Optional<Hypothesis> found = all.stream().filter(hypothesis -> hypothesis.name().equals(name)).findFirst();
        return ((Addition.Driven) found.orElseThrow().additions().get(0)).drive();
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"857, seat-torso", "858, pelvis-torso"})
    void itIsNamedWhereItIs(long seed, String where) throws Exception {
        ConcealedCase made = concealed(seed);
        Diagnosis diagnosis = Diagnoser.diagnose(ModelFile.parse(made.model(), "model.json"), made.recording(), (step, share) -> {});
        assertEquals(Diagnosis.Verdict.MISSING_PHYSICS, diagnosis.verdict());
        assertEquals(List.of("coupling.axis"), diagnosis.missing().stream().map(Diagnosis.Named::mechanism).toList());
        assertEquals(where, diagnosis.missing().get(0).where());
    }
}
